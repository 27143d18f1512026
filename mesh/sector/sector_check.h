// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "mesh/sector/sector_mesher.h"

namespace tiprub::mesh {

/// Measurements of a meshed sector, for people and for tests.
struct SectorReport {
  double smallest_radius;        ///< [m]
  double largest_radius;         ///< R [m]
  double axial_extent;           ///< [m]
  double worst_scaled_jacobian;  ///< det / product of the columns' lengths, at corners and Gauss points; 1 is a cube
  std::size_t worst_cell;        ///< index of its cell
  double mesh_volume;            ///< of the quadratic cells [m^3]
  std::size_t clamped_nodes;
};

/// Measures the sector. Raises InputError if an element is inverted, with its place and the keys that shape it.
SectorReport measure_sector(const MeshedSector& mesh, const Wheel& wheel);

/// The report in lines for a person: dimensions, counts, quality.
std::string describe(const SectorReport& report, const MeshedSector& mesh, const Wheel& wheel);

}  // namespace tiprub::mesh
