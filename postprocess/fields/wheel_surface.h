// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "reduce/model/fields_file.h"

namespace tiprub {

/// A face that one brick alone has: what is seen of a body.
struct SurfaceFace {
  enum class Side { free, cyclic_low, cyclic_high };

  std::array<int, 8> nodes;  ///< corners around, then the mid-sides between them
  Side side = Side::free;
};

/// The surface of a sector; the faces on the cut planes are marked.
std::vector<SurfaceFace> sector_surface(const SectorFields& sector);

/// The eight-node shape functions of a face at (s, t) in [-1, 1]^2, and their derivatives.
struct FaceShape {
  Eigen::Matrix<double, 8, 1> value, along_s, along_t;
};
FaceShape face_shape(double s, double t);

}  // namespace tiprub
