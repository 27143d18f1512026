// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// The same sector with displacements of the third degree, FE_Q(3), on the geometry of its cells. Bricks of 20 and of
/// 27 nodes then have the same displacements. The basis is that of reduce/theory.md, section 1: the values at the
/// nodes of the file, mid-side nodes included, remain unknowns, and contact nodes and fields are what they are with
/// quadratic cells. New nodes follow those of the file: first points, in the middle of the faces and cells of a
/// 20-node brick; then the functions that are odd along one axis or more. An odd function stands in the middle of the
/// edge, face or cell that it belongs to. It changes its sign with the direction of its axis, which goes out from the
/// corner that comes first among those of the edge, face or cell. A corner of cyclic_high has the place of its
/// partner in this order, so that the functions of both cuts are partners too.
///
/// Raises InputError if the mesh has other cells than bricks, or if the cells divide the cut faces differently.
SectorMesh with_cubic_bricks(const SectorMesh& mesh);

/// The functions of a brick or a quadrangle at a point of [-1, 1]^3 or [-1, 1]^2; 64 or 16. The first axis is the
/// fastest, and along an axis they are in the order of reduce/theory.md.
Eigen::VectorXd cubic_shape(const Eigen::VectorXd& at);

}  // namespace tiprub::reduce
