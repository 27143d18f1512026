// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace tiprub {

/// While one lives, SIGINT, SIGTERM and SIGHUP remove its file and end the program with 128 + the signal's number. A
/// signal handler may remove no folder: a stage that writes one turns signals into exceptions instead. At most
/// `most` live at a time; names of 4096 letters and more are left standing.
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

}  // namespace tiprub
