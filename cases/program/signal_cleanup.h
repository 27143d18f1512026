// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <filesystem>
#include <string>

namespace tiprub {

/// From here on SIGINT, SIGTERM and SIGHUP say so in one line on stderr, and end the program with 128 + the signal's
/// number. A signal that the program was started to ignore (nohup) stays ignored.
void announce_signals(const std::string& program);

/// That line, for whoever handles signals itself. A signal handler may call it.
void tell_interruption();

/// While one lives, these signals remove its file, and end the program. A signal handler may remove no folder: a
/// stage that writes one turns signals into exceptions instead (note_interruptions()). At most `most` live at a time;
/// names of 4096 letters and more are left standing.
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
