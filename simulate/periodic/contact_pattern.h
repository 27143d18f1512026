// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <vector>

namespace tiprub {

/// The sets of closed nodes in consecutive steps of a march. With these sets held fixed, the march is an affine map.
class ContactPattern {
 public:
  static constexpr int open = -1;

  /// Adds a step. `closed`: the indices of the closed nodes, ascending.
  void add(const std::vector<int>& closed);

  /// For each step the index of its set in sets(), or `open`.
  const std::vector<int>& steps() const { return steps_; }
  /// The distinct sets in the order of their first steps; no set is empty.
  const std::vector<std::vector<int>>& sets() const { return sets_; }

 private:
  std::vector<int> steps_;
  std::vector<std::vector<int>> sets_;
  std::map<std::vector<int>, int> places_;
};

}  // namespace tiprub
