// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// Reads a gmsh file with the groups `sector` (volume), `cyclic_low`, `cyclic_high`, `clamped` (surfaces) and
/// `contact` (a curve directed from leading to trailing edge, or points in that order), and the volume groups `disc`,
/// `main_blade`, `splitter` where there are any. Without both cut faces it is a whole body, N = 1. `tolerance` is
/// what two partners on the cut faces may differ by, over the largest radius. Raises RunError if the file can't be
/// read, InputError if it is no mesh of gmsh's, a group is missing, cells are not of a kind in cell_kind.h, the faces
/// don't pair, or the contact line doesn't run one way.
SectorMesh read_sector_mesh(const std::filesystem::path& path, double tolerance);

}  // namespace tiprub::reduce
