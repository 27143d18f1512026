// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/lines/named_text.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "cases/program/errors.h"
#include "cases/text/case_text.h"

namespace tiprub {

namespace {

constexpr std::uintmax_t largest_text = 4 << 20;  // [byte]

}  // namespace

NamedText read_named_text(const std::filesystem::path& path, const std::string& kind) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw RunError(path.string() + ": can't be read: it is " + (fs::is_directory(status) ? "a folder" : "no file") +
                   "; name " + kind);
  if (fs::exists(status) && fs::file_size(path, ignored) > largest_text)
    throw InputError(path.string() + ": is larger than " + std::to_string(largest_text >> 20) + " MiB; name " + kind);
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream.is_open() || stream.bad())
    throw RunError(path.string() + ": can't be read" + (errno != 0 ? std::string(": ") + std::strerror(errno) : ""));
  if (const TextFault fault = fault_of_letters(text)) throw InputError(path.string() + *fault);
  return {path.string(), text};
}

}  // namespace tiprub
