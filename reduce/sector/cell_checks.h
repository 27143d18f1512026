// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// Raises InputError if the cells don't make a mesh (neighbours with different mid-side nodes, a face of three cells,
/// or a quadrangle that meets triangles), or if a cell is inverted or flat at a node, with its number, part and
/// place.
void require_sound_cells(const SectorMesh& mesh);

/// Raises InputError: a cell is inverted or flat at this place.
[[noreturn]] void refuse_inverted(const SectorMesh& mesh, int cell, const Eigen::Vector3d& at);

}  // namespace tiprub::reduce
