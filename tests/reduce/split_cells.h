// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce::test {

/// A mesh of 27-node bricks as one of another kind: six tetrahedra along a diagonal, two wedges, six pyramids about
/// the centre, or the brick itself without its centres. Nodes stand where the brick's own map takes them. `mixed`:
/// bricks and, of every other brick, pyramids; `bricks_and_wedges`: of every other brick, wedges.
enum class Split { tet10, wedge15, pyramid13, hex20, mixed, bricks_and_wedges };
SectorMesh split(const SectorMesh& bricks, Split into);

/// Turns a brick's axes, by a third of a turn about a diagonal and quarters of one about an axis. The cell stays as
/// it is, but neighbours then see their edges and faces in different directions.
void turn_axes(SectorMesh& mesh, int cell, int quarters);

}  // namespace tiprub::reduce::test
