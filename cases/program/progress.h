// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace tiprub {

/// A progress bar with the time left, on stderr if that is a terminal. Any thread may report steps.
class Progress {
 public:
  enum class Shown { on_a_terminal, never };

  Progress(std::string what, std::size_t total, Shown shown);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();  ///< clears the line

  void advance();

 private:
  void draw() const;

  std::string what_;
  std::size_t total_;
  std::size_t done_ = 0;
  bool visible_;
  std::chrono::steady_clock::time_point start_;
  std::mutex mutex_;
};

}  // namespace tiprub
