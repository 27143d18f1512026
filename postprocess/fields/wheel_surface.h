// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "mesh/cells/free_faces.h"
#include "reduce/model/fields_file.h"

namespace tiprub::postprocess {

/// A face on the surface, and on which side of the sector it lies.
struct SurfaceFace : FreeFace {
  enum class Side { free, cyclic_low, cyclic_high };

  Side side = Side::free;

  int corners() const { return static_cast<int>(FreeFace::corners()); }
};

/// The surface of a sector; the faces on the cut planes are marked.
std::vector<SurfaceFace> sector_surface(const SectorFields& sector);
/// The surface of some of its cells.
std::vector<SurfaceFace> surface_of_cells(const SectorFields& sector, const std::vector<int>& cells);

}  // namespace tiprub::postprocess
