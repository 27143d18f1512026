// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <vector>

namespace tiprub {

/// Which nodes are closed in each step of a stretch of march. With these sets held, the march is an affine map.
class ContactPattern {
 public:
  static constexpr int open = -1;

  /// One step more; indices of the closed nodes, ascending.
  void add(const std::vector<int>& closed);

  /// For each step its place among sets(), or `open`.
  const std::vector<int>& steps() const { return steps_; }
  /// All that differ, each once, in the order in which they came; none is empty.
  const std::vector<std::vector<int>>& sets() const { return sets_; }

 private:
  std::vector<int> steps_;
  std::vector<std::vector<int>> sets_;
  std::map<std::vector<int>, int> places_;
};

}  // namespace tiprub
