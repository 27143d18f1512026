// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "simulate/march/cache_lines.h"

namespace tiprub {

/// The inverse of the block of W that belongs to the closed nodes, kept from step to step: a node that closes borders
/// it, one that opens leaves it, each a matrix of rank one, and a set's forces are one product. Rounding gathers, and
/// W may be singular: whoever uses it looks at what the forces leave, and clears it where that is no rounding.
class ClosedInverse {
 public:
  /// W [m/N] in columns of `stride` rows, whole vectors long; stays where it is.
  ClosedInverse(const double* compliance, std::size_t stride, double diagonal_shift);

  /// Takes the inverse to this set. Whether it can: false, and empty, if a pivot isn't positive.
  bool follow(const std::vector<int>& closed);
  void clear();
  /// The nodes in the order of values().
  const std::vector<int>& nodes() const { return nodes_; }
  /// -V gap of the nodes' gaps; nodes().size() values, zeros up to whole vectors.
  const double* forces(const double* gap);

 private:
  bool close(int node);
  void open(std::size_t slot);

  const double* compliance_;
  std::size_t stride_;
  double diagonal_;
  kernels::Lines inverse_, column_, product_;
  std::vector<int> nodes_, all_slots_;
  std::vector<char> wanted_;  ///< by node, while the set is followed
};

}  // namespace tiprub
