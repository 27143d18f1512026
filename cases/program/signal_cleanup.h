// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <filesystem>
#include <string>

namespace tiprub {

/// From here on SIGINT, SIGTERM and SIGHUP print one line on stderr and end the program with 128 + the number of the
/// signal. A signal that was ignored when the program started (nohup) stays ignored.
void announce_signals(const std::string& program);

/// Prints that line, for a stage that handles signals itself. A signal handler may call it.
void tell_interruption();

/// As long as an object of this class lives, these signals remove its file before they end the program. It does not
/// work for folders, because a signal handler can't remove them (see note_interruptions()). At most `most` objects
/// work at a time, and only for names of less than 4096 bytes.
class RemovedOnSignal {
 public:
  static constexpr int most = 8;

  explicit RemovedOnSignal(const std::filesystem::path& file);
  RemovedOnSignal(const RemovedOnSignal&) = delete;
  RemovedOnSignal& operator=(const RemovedOnSignal&) = delete;
  ~RemovedOnSignal() { release(); }

  /// From here on the file stays.
  void release();

 private:
  int slot_ = -1;
};

/// Raised where a run notices that one of these signals came.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// From here on the signals are only remembered, so that the stack unwinds and the owner of a folder removes it. To
/// be called after the OutputFile is made, whose handlers it replaces.
void note_interruptions();

/// Raises Interrupted if a signal has come.
void stop_if_interrupted();

/// The signal that came, or 0.
int interruption();

}  // namespace tiprub
