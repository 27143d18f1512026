// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/made_files.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <string>

#include "cases/program/errors.h"

namespace fs = std::filesystem;

namespace tiprub {

namespace {

constexpr const char* list_name = ".tiprub-files";

/// All but folders, relative to the folder; sorted.
std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_directory() || entry.is_symlink())
      files.insert(entry.path().lexically_relative(folder).generic_string());
  files.erase(list_name);
  return files;
}

}  // namespace

void list_made_files(const fs::path& folder) {
  std::ofstream list(folder / list_name);
  for (const std::string& file : files_in(folder)) list << file << "\n";
  list.close();
  if (!list) throw RunError((folder / list_name).string() + ": can't be written");
}

std::optional<fs::path> first_file_not_made_here(const fs::path& folder) {
  std::set<std::string> made;
  std::ifstream list(folder / list_name);
  for (std::string line; std::getline(list, line);) made.insert(line);
  for (const std::string& file : files_in(folder))
    if (!made.contains(file)) return fs::path(file);
  return std::nullopt;
}

}  // namespace tiprub
