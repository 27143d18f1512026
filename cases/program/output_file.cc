// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "cases/program/errors.h"
#include "cases/program/made_files.h"

namespace fs = std::filesystem;

namespace tiprub {

namespace {

/// "sector.msh" -> "sector.tiprub.part.msh".
fs::path beside(const fs::path& target, const std::string& word) {
  fs::path name = target;
  return name.replace_filename(target.stem().string() + ".tiprub." + word + target.extension().string());
}

/// By name too, for files that are still to come.
bool same_file(const fs::path& one, const fs::path& other) {
  if (one.empty() || other.empty()) return false;
  std::error_code ignored;
  if (fs::equivalent(one, other, ignored)) return true;
  const fs::path place = fs::weakly_canonical(fs::absolute(one), ignored);
  return !place.empty() && place == fs::weakly_canonical(fs::absolute(other), ignored);
}

void require_replaceable(const fs::path& target) {
  const fs::file_status status = fs::status(target);
  if (!fs::exists(status) || fs::is_regular_file(status)) return;
  if (!fs::is_directory(status))
    throw RunError(target.string() + ": can't be replaced: it is neither a file nor a folder; give another -o");
  if (const auto stranger = first_file_not_made_here(target))
    throw RunError(target.string() + ": can't be replaced: it holds " + stranger->string() +
                   ", which this program did not make; move that away, or give another -o");
}

/// Waits until the disk has the file: a full one may only be noticed here.
std::error_code synchronise_file(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return {errno, std::generic_category()};
  const bool failed = ::fsync(file) != 0;
  const std::error_code error(failed ? errno : 0, std::generic_category());
  ::close(file);
  return error;
}

/// The same for a file or all that is in a folder.
std::error_code synchronise(const fs::path& path) {
  if (!fs::is_directory(path)) return synchronise_file(path);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path))
    if (entry.is_regular_file())
      if (const std::error_code error = synchronise_file(entry.path())) return error;
  return {};
}

/// rename() replaces files, but only empty folders.
std::error_code replace_folder(const fs::path& scratch, const fs::path& target) {
  std::error_code error;
  const fs::path old = beside(target, "old");
  fs::remove_all(old, error);
  fs::rename(target, old, error);
  if (error) return error;
  fs::rename(scratch, target, error);
  std::error_code ignored;
  if (error)
    fs::rename(old, target, ignored);
  else
    fs::remove_all(old, ignored);
  return error;
}

}  // namespace

OutputFile::OutputFile(fs::path target) : target_(std::move(target)) {
  if (!target_.has_filename()) target_ = target_.parent_path();  // "report/" is the folder "report"
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  if (!fs::is_directory(folder))
    throw RunError(target_.string() + ": can't be written: no folder " + folder.string());
  require_replaceable(target_);
  scratch_ = beside(target_, "part");
  fs::remove_all(scratch_);
  removed_on_signal_.emplace(scratch_);
}

OutputFile::~OutputFile() {
  removed_on_signal_.reset();
  std::error_code ignored;
  fs::remove_all(scratch_, ignored);
}

void OutputFile::commit() {
  require_replaceable(target_);
  if (fs::is_directory(scratch_)) list_made_files(scratch_);
  std::error_code error = synchronise(scratch_);
  if (!error && fs::is_directory(scratch_) && fs::is_directory(target_))
    error = replace_folder(scratch_, target_);
  else if (!error)
    fs::rename(scratch_, target_, error);
  if (error) throw RunError(target_.string() + ": can't be written: " + error.message());
  removed_on_signal_.reset();
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& body) {
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  if (out) body(out);
  out.close();  // streams hold back: only now is it known
  const int reason = errno;
  if (!out)
    throw RunError(path.string() + ": can't be written" +
                   (reason == 0 ? "" : ": " + std::generic_category().message(reason)));
}

void refuse_overwriting(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
  std::vector<fs::path> taken = inputs;
  for (const fs::path& output : outputs) {
    for (const fs::path& other : taken)
      if (same_file(output, other))
        throw InputError(output.string() + ": would be written over " + other.string() +
                         ", which this run reads or writes too; give it another name");
    taken.push_back(output);
  }
}

}  // namespace tiprub
