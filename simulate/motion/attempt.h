// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cases/program/errors.h"

namespace tiprub {

/// What came of some work that may find no motion, or why nothing did.
template <class Result>
struct Attempt {
  std::optional<Result> result;
  std::string failure;  ///< empty with a result
};

template <class Work>
auto attempt(const Work& work) -> Attempt<decltype(work())> {
  try {
    return {work(), ""};
  } catch (const RunError& error) {
    return {std::nullopt, error.what()};
  }
}

}  // namespace tiprub
