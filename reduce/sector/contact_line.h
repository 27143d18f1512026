// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reduce/model/reduced_model.h"
#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// Raises InputError where a contact line, of the main blade or of the splitter, stands still or turns back in the
/// meridional plane, and names the place: its points are then out of order, or its curves have opposite directions,
/// and the casing, the surface of revolution of the line, would fold there.
void require_one_way(const SectorMesh& mesh);

/// `count` nodes of each contact line, the main blade's first: the ends and those nearest to equal steps of arc
/// length between them; the defaults follow the paper's ten. Raises InputError if a line has fewer.
std::vector<int> choose_contact_nodes(const SectorMesh& mesh, int count);

/// [m] The arc lengths, from its first node, at which a contact line comes nearest to each of some nodes in the
/// meridional plane. The line goes on straight beyond its ends, because a tip may reach farther than its line.
Eigen::VectorXd arc_lengths_beside(const SectorMesh& mesh, const std::vector<int>& line,
                                   const std::vector<int>& nodes);

/// Where the chosen nodes stand, and the normals of the casing there. The casing is a surface of revolution about the
/// tip line, so a normal lies in the meridional plane, square to the line (tangents by quadratic differences over arc
/// length), and points away from the blade. A splitter's nodes come after the main blade's. Their normals are those
/// of the splitter's own tip line; their arc lengths are those at which the main blade's line comes nearest, because
/// one casing surrounds both. Static shifts are left zero. Raises InputError if these arc lengths don't increase
/// along a splitter.
ContactLine describe_contact(const SectorMesh& mesh, const std::vector<int>& contact);

/// Unit forces along the normals, on the contact dofs; contact dofs x n_c.
Eigen::MatrixXd normal_forces(const ContactLine& line);

/// [1/m] The curvature of the casing along the meridian beside some nodes of the contact lines, at which it has these
/// normals (n_c x 3; r, theta, z): positive where it bends round the blade, so that a tip which moves along the
/// tangent comes nearer. By quadratic differences over arc length; zero on a line of fewer than three nodes.
Eigen::VectorXd meridional_curvature(const SectorMesh& mesh, const std::vector<int>& contact,
                                     const Eigen::MatrixX3d& normals);

}  // namespace tiprub::reduce
