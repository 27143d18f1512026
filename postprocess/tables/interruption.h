// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>

namespace tiprub {

/// Raised where a run notices that SIGINT, SIGTERM or SIGHUP came.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// From here on the three signals only leave a note, so that the stack unwinds and a folder of many files is removed
/// by its owner (a signal handler may remove one file, but no folder). To be made after the OutputFile, whose
/// handlers it replaces.
void note_interruptions();

/// Raises Interrupted if a signal has come.
void stop_if_interrupted();

/// The signal that came, or 0.
int interruption();

}  // namespace tiprub
