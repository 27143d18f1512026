// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/import/cell_mesh.h"

namespace tiprub::mesh {

inline constexpr int most_sectors = 1000;

/// Pairs of free faces of which the first, turned about z by 2 pi/N, is the second; by number in CellMesh::faces.
struct PeriodicCuts {
  int sector_count = 1;  ///< N; 1 if there are none
  std::vector<int> low, high;
};

/// Finds the cuts of a sector: faces whose normal points towards -theta and which, turned by 2 pi/N, coincide with
/// faces whose normal points towards +theta. `sector_count` is N, or 0 to find it; then N is the smallest for which
/// at least two pairs of faces have the same r and z. Places agree to 1e-5 of the largest radius.
PeriodicCuts find_cuts(const CellMesh& mesh, int sector_count);

/// Raises InputError where only a part of a cut pairs. A cut is a whole patch of the surface: free faces that
/// continue it without an edge belong to it.
void require_whole(const CellMesh& mesh, const PeriodicCuts& cuts);

/// Raises InputError unless each face of one cut, turned by 2 pi/N, is one of the other.
void require_pairs(const CellMesh& mesh, const PeriodicCuts& cuts);

}  // namespace tiprub::mesh
