// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/output_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "cases/program/errors.h"

namespace fs = std::filesystem;

namespace tiprub {

namespace {

fs::path lock_of(fs::path output) {
  if (!output.has_filename()) output = output.parent_path();  // "report/" is the folder "report"
  const std::string name = "." + output.filename().string() + ".lock";
  return output.replace_filename(name);
}

/// Whether the name still leads to the open file: its former holder removes it when it is done.
bool leads_to(const fs::path& path, int file) {
  struct stat by_name {
  }, opened{};
  return ::stat(path.c_str(), &by_name) == 0 && ::fstat(file, &opened) == 0 && by_name.st_ino == opened.st_ino &&
         by_name.st_dev == opened.st_dev;
}

std::string this_process() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return "process " + std::to_string(::getpid()) + " on " + host.data();
}

std::string holder(const fs::path& path) {
  std::string line;
  std::ifstream file(path);
  std::getline(file, line);
  return line.empty() ? "another process" : line;
}

}  // namespace

OutputLock::OutputLock(const fs::path& output) : path_(lock_of(output)) {
  const fs::path folder = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
  if (!fs::is_directory(folder)) throw RunError(output.string() + ": can't be written: no folder " + folder.string());
  while (file_ < 0) {
    constexpr mode_t readable_by_all = 0644;
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, readable_by_all);
    if (file_ < 0) throw RunError(output.string() + ": can't be written: " + std::generic_category().message(errno));
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
      ::close(file_);
      throw RunError(output.string() + ": " + holder(path_) + " is writing it; wait for that, or give another -o");
    }
    if (leads_to(path_, file_)) break;
    ::close(file_);
    file_ = -1;
  }
  const std::string who = this_process() + "\n";
  const bool named = ::ftruncate(file_, 0) == 0 && ::write(file_, who.data(), who.size()) > 0;
  removed_on_signal_.emplace(path_);
  static_cast<void>(named);  // on a full disk the lock holds without a name
}

OutputLock::~OutputLock() {
  ::unlink(path_.c_str());
  removed_on_signal_.reset();
  ::close(file_);
}

}  // namespace tiprub
