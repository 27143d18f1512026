// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

namespace tiprub {

/// There is no motion here, for a reason that lies in the scene or in the numbers: a speed fails by it, or a branch
/// ends. It never ends the program, as RunError does, and never stands for a file or for memory that can't be had.
class NoMotion : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What came of work that may find no motion, or why nothing did.
template <class Result>
struct Attempt {
  std::optional<Result> result;
  std::string failure;  ///< empty with a result
};

template <class Work>
auto attempt(const Work& work) -> Attempt<decltype(work())> {
  try {
    return {work(), ""};
  } catch (const NoMotion& error) {
    return {std::nullopt, error.what()};
  }
}

}  // namespace tiprub
