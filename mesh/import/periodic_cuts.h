// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
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

/// Two cuts that the case names, exchanged if the first does not lead to the second. `sector_count` is N, or 0 to
/// take it from the angle between the centres of the cuts.
PeriodicCuts named_cuts(const CellMesh& mesh, const std::vector<int>& low, const std::vector<int>& high,
                        int sector_count);

/// The whole patches of the surface to which the faces of these pairs belong.
PeriodicCuts whole_cuts(const CellMesh& mesh, const PeriodicCuts& pairs);

/// The faces of two cuts of which the first, turned by 2 pi/N, is the second; pair by pair.
PeriodicCuts pairs_of(const CellMesh& mesh, const PeriodicCuts& cuts);

/// Whether at least 90 % of the faces of the smaller cut pair.
bool mostly_pair(const CellMesh& mesh, const PeriodicCuts& cuts);

/// Whether an axis and a number of sectors other than the case's are worth a suggestion: the cuts have at least two
/// faces, most of them pair, and not by a half turn, which exchanges the cuts of every symmetric sector.
bool could_be_meant(const CellMesh& mesh, const PeriodicCuts& cuts);

/// For a message, why the faces of two named cuts do not pair, or what to do: the angle between them is not 2 pi/N,
/// they are not at the same r and z, or they are meshed differently.
std::string why_unpaired(const CellMesh& mesh, const PeriodicCuts& cuts);

/// Raises InputError where only a part of a cut pairs. A cut is a whole patch of the surface: free faces that
/// continue it without an edge belong to it.
void require_whole(const CellMesh& mesh, const PeriodicCuts& cuts);

/// Raises InputError unless each face of one cut, turned by 2 pi/N, is one of the other.
void require_pairs(const CellMesh& mesh, const PeriodicCuts& cuts);

}  // namespace tiprub::mesh
