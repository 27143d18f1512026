// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/scratch_folder.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
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

/// Starts the shell, in a session of its own: a signal to the terminal's or to mpirun's processes passes it by.
int start_watcher(int waits_for, const std::string& folder) {
  constexpr const char* script = "read -r end; exec rm -rf -- \"$1\"";
  std::array<const char*, 6> arguments = {"sh", "-c", script, "sh", folder.c_str(), nullptr};
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, waits_for, STDIN_FILENO);
  for (const int output : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&files, output, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t session;
  posix_spawnattr_init(&session);
  posix_spawnattr_setflags(&session, POSIX_SPAWN_SETSID);
  pid_t process = -1;
  if (posix_spawn(&process, "/bin/sh", &files, &session, const_cast<char* const*>(arguments.data()), environ) != 0)
    process = -1;
  posix_spawnattr_destroy(&session);
  posix_spawn_file_actions_destroy(&files);
  return process;
}

}  // namespace

ScratchFolder::ScratchFolder(const std::filesystem::path& parent) : path_(new_folder(parent)) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;  // the folder then stays if the process is killed
  alive_ = ends[1];
  watcher_ = start_watcher(ends[0], path_.string());
  ::close(ends[0]);
}

ScratchFolder::~ScratchFolder() {
  if (alive_ >= 0) ::close(alive_);
  if (watcher_ > 0) ::waitpid(watcher_, nullptr, 0);
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace tiprub::reduce
