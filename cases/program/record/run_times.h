// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace tiprub {

/// How long a program ran, noted for people: one row of CSV, "program", "wall time [s]", "processor time [s]" (its
/// own and that of what it started) and "processors" (that it might run on). Under MPI they are one process's.
class RunTimes {
 public:
  /// Writes the note. Raises RunError if the file can't be written.
  void write(const std::string& program, const std::filesystem::path& path) const;

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace tiprub
