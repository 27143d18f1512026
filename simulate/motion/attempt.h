// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

namespace tiprub {

/// No motion can be computed here, for a reason that lies in the scene or in the numerics: the speed fails, or the
/// branch ends. Unlike RunError it never ends the program, and it never reports a fault of a file or of memory.
class NoMotion : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The result of work that may find no motion, or the reason why there is none.
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
