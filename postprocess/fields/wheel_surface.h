// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "reduce/model/fields_file.h"

namespace tiprub::postprocess {

/// A face that belongs to only one cell, and so lies on the surface.
struct SurfaceFace {
  enum class Side { free, cyclic_low, cyclic_high };

  std::vector<int> nodes;  ///< corners around (3 or 4), then the mid-sides between them
  Side side = Side::free;

  int corners() const { return static_cast<int>(nodes.size() / 2); }
};

/// The surface of a sector; the faces on the cut planes are marked.
std::vector<SurfaceFace> sector_surface(const SectorFields& sector);
/// The surface of some of its cells.
std::vector<SurfaceFace> surface_of_cells(const SectorFields& sector, const std::vector<int>& cells);

}  // namespace tiprub::postprocess
