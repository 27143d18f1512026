// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/sandbox.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <new>
#include <string_view>

#include "cases/program/errors.h"
#include "cases/program/machine.h"

namespace tiprub {

namespace {

// The first letter of the child's answer.
constexpr char made = 'm', wrong_input = 'i', failed = 'f', too_large = 'l';

/// Whether the limit could be lowered. A tighter one stays as it is.
bool lower_limit(__rlimit_resource resource, double most) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0 || static_cast<double>(limit.rlim_cur) <= most) return false;
  limit.rlim_cur = static_cast<rlim_t>(most);
  return setrlimit(resource, &limit) == 0;
}

/// Applies the limits. Returns false if the process may take less memory than they allow.
bool confine(const SandboxLimits& limits) {
  const bool all_memory = lower_limit(RLIMIT_AS, mapped_memory() + limits.bytes);
  lower_limit(RLIMIT_CPU, limits.seconds);
  lower_limit(RLIMIT_CORE, 0);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) signal(number, SIG_DFL);  // the parent cleans up
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);  // the parent reports a crash in its own words
  return all_memory;
}

std::string answer_of(const std::function<std::string()>& make, bool all_memory) {
  try {
    return made + make();
  } catch (const InputError& error) {
    return wrong_input + std::string(error.what());
  } catch (const std::bad_alloc&) {
    return all_memory ? std::string(1, too_large) : failed + std::string("not enough memory");
  } catch (const std::exception& error) {
    return failed + std::string(error.what());
  }
}

void write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) _exit(1);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

std::string read_all(int file) {
  std::string bytes;
  std::array<char, 1 << 16> part;
  while (true) {
    const ssize_t count = read(file, part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(part.data(), static_cast<std::size_t>(count));
  }
}

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

std::string made_in_sandbox(const std::function<std::string()>& make, const SandboxLimits& limits) {
  std::array<int, 2> pipe{};
  if (pipe2(pipe.data(), O_CLOEXEC) != 0) throw RunError(std::string("can't make a pipe: ") + std::strerror(errno));
  const pid_t child = fork();
  if (child < 0) throw RunError(std::string("can't start a process: ") + std::strerror(errno));
  if (child == 0) {
    close(pipe[0]);
    const bool all_memory = confine(limits);
    write_all(pipe[1], answer_of(make, all_memory));
    _exit(0);
  }
  close(pipe[1]);
  const std::string answer = read_all(pipe[0]);
  close(pipe[0]);
  const int status = wait_for(child);
  if (WIFSIGNALED(status)) throw SandboxFailure(strsignal(WTERMSIG(status)));
  if (WEXITSTATUS(status) != 0 || answer.empty()) throw SandboxFailure("it ended early");
  const std::string rest = answer.substr(1);
  if (answer.front() == too_large) throw SandboxFailure("it takes more memory than it may");
  if (answer.front() == wrong_input) throw InputError(rest);
  if (answer.front() == failed) throw RunError(rest);
  return rest;
}

}  // namespace tiprub
