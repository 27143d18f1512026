// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// Finds N from the angle between the cut faces, and orders cyclic_high like cyclic_low. Partners may differ by
/// `tolerance` over the largest radius. Raises InputError where they don't pair, and says whether they would with
/// their names exchanged, by another angle, about another axis, or shifted; else by how much they miss.
void pair_cut_faces(SectorMesh& mesh, double tolerance);

/// Raises InputError where free faces continue a cut face without an edge and do not belong to it: a wheel whose
/// sectors are joined by a part of their cuts has frequencies that are wrong by percents.
void require_whole_cuts(const SectorMesh& mesh);

/// Whether the cells have a face on one cut for each on the other, with the partners of its corners. The cuts must be
/// paired.
bool cut_faces_are_equal(const SectorMesh& mesh);

}  // namespace tiprub::reduce
