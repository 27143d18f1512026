// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "cases/program/digest.h"
#include "cases/program/errors.h"
#include "simulate/response/response_file.h"

namespace tiprub {

namespace {

const std::string mark = "tiprub seal ";
constexpr std::streamsize digits = 16, block = 1 << 20;
const std::streamsize seal_size = static_cast<std::streamsize>(mark.size()) + digits;

/// The seal of a file's first `count` bytes.
std::string make_seal(std::ifstream& file, std::streamsize count) {
  Digest digest;
  std::vector<char> bytes(static_cast<std::size_t>(block));
  file.seekg(0);
  for (; count > 0 && file; count -= file.gcount()) {
    file.read(bytes.data(), std::min(count, block));
    digest.add_bytes(bytes.data(), static_cast<std::size_t>(file.gcount()));
  }
  return mark + digest.digits();
}

}  // namespace

void seal(const std::filesystem::path& path) {
  std::ifstream written(path, std::ios::binary);
  const std::string made = make_seal(written, static_cast<std::streamsize>(std::filesystem::file_size(path)));
  std::ofstream file(path, std::ios::binary | std::ios::app);
  file << made;
  file.close();
  if (!written || !file) throw RunError(path.string() + ": can't be written to its end; is the disk full?");
}

Seal seal_of(const std::filesystem::path& path) {
  std::error_code unreadable;
  const auto size = static_cast<std::streamsize>(std::filesystem::file_size(path, unreadable));
  if (unreadable || size < seal_size) return Seal::none;
  std::ifstream file(path, std::ios::binary);
  std::string found(static_cast<std::size_t>(seal_size), ' ');
  file.seekg(size - seal_size);
  file.read(found.data(), seal_size);
  if (found.compare(0, mark.size(), mark) != 0) return Seal::none;
  return make_seal(file, size - seal_size) == found ? Seal::whole : Seal::broken;
}

}  // namespace tiprub
