// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/import/cell_mesh.h"

namespace tiprub {

inline constexpr int most_sectors = 1000;

/// Free faces that another free face is, turned about z by 2 pi/N: by number in CellMesh::faces.
struct PeriodicCuts {
  int sector_count = 1;  ///< N; 1 if there are none
  std::vector<int> low, high;
};

/// Looks for the cuts of a sector: faces that look to -theta, and, turned by 2 pi/N, are faces that look to +theta.
/// `sector_count` is N, or 0 to look for it: the smallest N of a pair of faces with the same r and z that more faces
/// have. Places agree to 1e-5 of the largest radius.
PeriodicCuts find_cuts(const CellMesh& mesh, int sector_count);

}  // namespace tiprub
