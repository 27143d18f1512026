// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <filesystem>
#include <string>
#include <vector>

namespace tiprub {

/// Quadratic cells for ParaView and its like.
struct VtuMesh {
  Eigen::Matrix3Xd points;  ///< [m]
  Eigen::MatrixXi cells;    ///< in VTK's order, then -1 (see nodes_of())
};

/// A field at the points: 1 (number), 3 (vector) or 6 (symmetric tensor: xx, yy, zz, xy, yz, zx) x points.
struct VtuArray {
  std::string name;
  Eigen::MatrixXd values;
};

/// A number of all the file (its field data), as "speed" in rad/s.
struct VtuNumber {
  std::string name;
  double value = 0;
};

/// Writes a VTK XML file of an unstructured grid (quadratic cells): XML throughout, the numbers single-precision
/// in base 64, little-endian; those of all the file in decimals.
void write_vtu(const VtuMesh& mesh, const std::vector<VtuArray>& arrays, const std::vector<VtuNumber>& numbers,
               const std::filesystem::path& path);

/// A file of an animation, by its path from where the collection lies.
struct VtuFrame {
  double time = 0;  ///< [s]
  std::string file;
};

/// Writes a collection of VTK XML files over time (.pvd), as ParaView opens it.
void write_pvd(const std::vector<VtuFrame>& frames, const std::filesystem::path& path);

}  // namespace tiprub
