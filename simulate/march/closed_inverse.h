// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "simulate/march/cache_lines.h"

namespace tiprub {

/// The inverse V of the block of W that belongs to the closed nodes, kept from step to step. A node that closes or
/// opens changes it by a matrix of rank one, and the forces of a set are one product. Rounding errors accumulate, and
/// W may be singular. The caller must therefore check the gaps that remain under the forces, and call clear() where
/// they are larger than rounding.
class ClosedInverse {
 public:
  /// W [m/N] in columns of `stride` rows, a whole number of vectors. W must outlive this object.
  ClosedInverse(const double* compliance, std::size_t stride, double diagonal_shift);

  /// Updates the inverse to this set. Returns false, and leaves the inverse empty, if a pivot is not positive.
  bool follow(const std::vector<int>& closed);
  void clear();
  /// The nodes in the order of forces().
  const std::vector<int>& nodes() const { return nodes_; }
  /// [N] -V g, with the gaps g [m] of the closed nodes; nodes().size() values, then zeros up to a whole vector.
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
