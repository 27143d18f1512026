// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "mesh/sector/sector_file.h"

namespace tiprub::mesh {

/// A drawing (SVG) of the surface of a mesh from two sides, which together show both cuts, the tip and a clamped
/// bore: each face in the colour of its group, or else of its part, with its curved edges, and the lines of contact
/// nodes. Faces are drawn from the farthest to the nearest, without those that look away.
std::string picture_of(const NamedMesh& mesh);

}  // namespace tiprub::mesh
