// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/sector/sector_mesher.h"

namespace tiprub::mesh {

/// Measurements of a meshed sector, for people and for tests.
struct SectorReport {
  double smallest_radius;        ///< [m]
  double largest_radius;         ///< R [m]
  double axial_extent;           ///< [m]
  double worst_scaled_jacobian;  ///< det / product of the columns' lengths, at corners and Gauss points; 1 is a cube
  std::size_t worst_cell;        ///< index of its cell
  double pairing_mismatch;       ///< largest distance of a cyclic_high node from its turned partner, over R
  double mesh_volume;            ///< of the quadratic cells [m^3]
  double geometry_volume;        ///< of the exact shape, see geometry_volume() [m^3]
  std::size_t clamped_nodes;
  std::size_t clamped_cyclic_nodes;  ///< of these on cyclic_low or cyclic_high; the clamp wins there
  double normal_angle_leading_deg;   ///< contact normal at the leading edge: 0 radial, 90 along -z, towards the inlet
  double normal_angle_trailing_deg;  ///< at the trailing edge
};

/// Measures the sector. Raises InputError if an element is inverted, with its place and the keys that shape it.
SectorReport measure_sector(const MeshedSector& mesh, const Wheel& wheel);

/// Unit normals of the tip surface at the contact nodes, outward, leading to trailing edge.
std::vector<Eigen::Vector3d> contact_normals(const MeshedSector& mesh);

/// The report in lines for a person: dimensions, counts, quality.
std::string describe(const SectorReport& report, const MeshedSector& mesh, const Wheel& wheel);

/// The volume of one sector's shape [m^3], without a mesh: the integral of r times the angle that the part takes,
/// over the meridional section. Gauss quadrature between the stations; exact to about 1e-8.
double geometry_volume(const Wheel& wheel);

}  // namespace tiprub::mesh
