// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// The same sector with each cell split into eight of its kind. New nodes stand where the shape functions of the
/// cell take them, so that the geometry is the same to the last digit, and each displacement of the given mesh is one
/// of the refined mesh: frequencies fall, and compliances grow. The nodes keep their numbers, and the contact lines
/// their nodes; new nodes come after them. deal.II 9.4 refines no wedges or tetrahedra, so that this is our own.
/// Raises InputError if the cells make no sound mesh, if the mesh has pyramids, or if the cells divide the cut faces
/// differently.
SectorMesh refined(const SectorMesh& mesh);

}  // namespace tiprub::reduce
