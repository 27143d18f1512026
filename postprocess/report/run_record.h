// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "postprocess/report/verdict.h"

namespace tiprub {

/// When a report was made, of what, and how long it took: the one thing in a report that differs from run to run of
/// the same inputs.
class RunRecord {
 public:
  /// `stages`: what the stages before noted with --times. Raises InputError or RunError if one can't be read.
  RunRecord(std::vector<std::filesystem::path> inputs, const std::vector<std::filesystem::path>& stages);

  /// A part of the work is done: it took the time since the last one.
  void done(const std::string& part);
  /// Version and commit, dates of the inputs, times of the stages before and of the parts.
  std::vector<Answer> in_words() const;

 private:
  std::vector<std::filesystem::path> inputs_;
  std::string stages_;                                 ///< in words
  std::vector<std::pair<std::string, double>> parts_;  ///< [s]
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace tiprub
