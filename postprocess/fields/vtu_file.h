// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <filesystem>
#include <string>
#include <vector>

namespace tiprub {

/// Quadratic bricks for ParaView and its like.
struct VtuMesh {
  Eigen::Matrix3Xd points;  ///< [m]
  Eigen::MatrixXi cells;    ///< in VTK's order, 20 or 27 x cells
};

/// A field at the points: 1 (number), 3 (vector) or 6 (symmetric tensor: xx, yy, zz, xy, yz, zx) x points.
struct VtuArray {
  std::string name;
  Eigen::MatrixXd values;
};

/// Writes a VTK XML file of an unstructured grid (cell types 25 and 29): XML throughout, the numbers single-precision
/// in base 64, little-endian.
void write_vtu(const VtuMesh& mesh, const std::vector<VtuArray>& arrays, const std::filesystem::path& path);

}  // namespace tiprub
