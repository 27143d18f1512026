// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "cases/program/signal_cleanup.h"

namespace tiprub {

/// One run at a time on an output: held from before the work until the output stands. A lock of the operating system
/// (flock) on ".NAME.lock" beside the output, so that it ends with the process, however that ends. That file names
/// who holds it. Taking it also shows, before the work, that the output's folder exists and can be written.
class OutputLock {
 public:
  /// Raises RunError if another process holds it, or if its file can't be made.
  explicit OutputLock(const std::filesystem::path& output);
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;
  ~OutputLock();

 private:
  std::filesystem::path path_;
  int file_ = -1;
  std::optional<RemovedOnSignal> removed_on_signal_;
};

}  // namespace tiprub
