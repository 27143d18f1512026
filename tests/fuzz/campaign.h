// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "tests/fuzz/inputs.h"

namespace tiprub::fuzz {

struct Campaign {
  std::uint64_t seed = 0, count = 0;
  double seconds = 0;            ///< no input begins later; 0: none is left out
  std::filesystem::path folder;  ///< where inputs are written; those that a reader fails on stay there
};

struct Tally {
  std::uint64_t inputs = 0;
  std::uint64_t accepted = 0;
  std::uint64_t refused = 0;  ///< with one line that names the file
  std::uint64_t crashes = 0;  ///< signals and sanitizer reports
  std::uint64_t hangs = 0;    ///< above a minute
  std::uint64_t wrong = 0;    ///< refused in any other way

  bool sound() const { return crashes + hangs + wrong == 0; }
};

/// Lets a reader read changed inputs, in child processes that may die. Raises std::runtime_error if it doesn't
/// accept a base as it is.
Tally run(const Reader& reader, const std::vector<Base>& bases, const Campaign& campaign);

}  // namespace tiprub::fuzz
