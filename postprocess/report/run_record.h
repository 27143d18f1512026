// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "postprocess/report/verdict.h"

namespace tiprub::postprocess {

/// When, from what and in how much time a report was made. This is the only part of a report that differs between
/// runs with the same inputs.
class RunRecord {
 public:
  /// `stages`: files that the stages before wrote with --times. Raises InputError or RunError if one can't be read.
  RunRecord(std::vector<std::filesystem::path> inputs, const std::vector<std::filesystem::path>& stages);

  /// Records the end of a part of the work, which took the time since the last call, and the peak of the memory.
  void done(const std::string& part);
  /// Version and commit, dates of the inputs, times of the stages before and of the parts, the most memory.
  std::vector<Answer> in_words() const;

 private:
  std::vector<std::filesystem::path> inputs_;
  std::string stages_;                                 ///< in words
  std::vector<std::pair<std::string, double>> parts_;  ///< [s]
  double memory_ = 0;                                  ///< [bytes] the most that the process had
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace tiprub::postprocess
