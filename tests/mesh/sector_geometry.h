// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "mesh/sector/sector_mesher.h"

namespace tiprub::mesh::test {

/// The volume of one sector's shape [m^3], without a mesh: the integral of r times the angle that the part takes,
/// over the meridional section. Gauss quadrature between the stations; exact to about 1e-8.
double geometry_volume(const Wheel& wheel);

/// The nodes on cyclic_low, each with the node of cyclic_high to which a turn by 2 pi/N brings it nearest.
std::vector<std::array<std::size_t, 2>> cyclic_pairs(const MeshedSector& mesh);

/// The largest distance [m] of a node of cyclic_high from its turned partner.
double pairing_mismatch(const MeshedSector& mesh);

/// The nodes of a named surface, each once.
std::set<std::size_t> nodes_on(const MeshedSector& mesh, const std::string& surface);

/// Unit normals of the tip surface at the contact nodes, outward, leading to trailing edge.
std::vector<Eigen::Vector3d> contact_normals(const MeshedSector& mesh);

/// Between a normal and the radius at its place [deg]: 0 radial, 90 along -z, towards the inlet.
double angle_from_radial_deg(const Eigen::Vector3d& normal, const Eigen::Vector3d& at);

}  // namespace tiprub::mesh::test
