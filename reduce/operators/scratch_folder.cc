// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/scratch_folder.h"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include "cases/program/errors.h"

namespace tiprub::reduce {

namespace {

std::filesystem::path new_folder(const std::filesystem::path& parent) {
  std::string name = (std::filesystem::absolute(parent.empty() ? "." : parent) / ".tiprub-factor-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw RunError(parent.string() +
                   ": no folder for factors can be made: " + std::generic_category().message(errno));
  return name;
}

}  // namespace

ScratchFolder::ScratchFolder(const std::filesystem::path& parent) : path_(new_folder(parent)) {
  // Reads the name of the folder until this process closes the pipe or ends. It has a session of its own: a signal to
  // the processes of the terminal or of mpirun passes it by.
  constexpr const char* watcher =
      "exec setsid sh -c 'folder=$(cat; echo .); exec rm -rf -- \"${folder%.}\"' >/dev/null 2>&1";
  watcher_ = ::popen(watcher, "we");
  if (watcher_ == nullptr) return;  // the folder then stays if the process is killed
  std::fputs(path_.c_str(), watcher_);
  std::fflush(watcher_);
}

ScratchFolder::~ScratchFolder() {
  if (watcher_ != nullptr) ::pclose(watcher_);
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace tiprub::reduce
