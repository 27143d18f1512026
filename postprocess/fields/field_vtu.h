// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "postprocess/fields/field_study.h"

namespace tiprub::postprocess {

/// A mesh of quadratic cells.
struct VtuMesh {
  Eigen::Matrix3Xd points;  ///< [m]
  Eigen::MatrixXi cells;    ///< in VTK's order, then -1 (see nodes_of())
};

/// A field at the points: 1 (number), 3 (vector) or 6 (symmetric tensor: xx, yy, zz, xy, yz, zx) x points; or cells.
struct VtuArray {
  std::string name;
  Eigen::MatrixXd values;
};

/// A number for the whole file (its field data), for instance "speed" in rad/s.
using VtuNumber = std::pair<std::string, double>;

/// Writes a VTK XML file of an unstructured grid; `of_cells` are fields at the cells. Arrays are single-precision,
/// little-endian, compressed, in base 64; the numbers for the whole file are decimal. The DataOut of deal.II 9.4
/// writes neither quadratic wedges nor pyramids.
void write_vtu(const VtuMesh& mesh, const std::vector<VtuArray>& arrays, const std::vector<VtuNumber>& numbers,
               const std::filesystem::path& path, const std::vector<VtuArray>& of_cells = {});

/// The motion at the speed of the contact instant; null if that speed has no cycle.
const MovingWheel* moving_at_instant(const FieldStudy& fields);

/// Writes modes_sector.vtu, modes_wheel.vtu, contact_sector.vtu and contact_wheel.vtu and, if there is a motion,
/// motion_sector.pvd with its frames in motion_sector/.
void write_vtu_files(const FieldStudy& fields, const std::filesystem::path& folder);

}  // namespace tiprub::postprocess
