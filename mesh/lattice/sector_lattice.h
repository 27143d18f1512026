// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mesh/curves/wheel_geometry.h"
#include "mesh/lattice/sector_plan.h"

namespace tiprub::mesh {

/// Which cells of the box (column, station, layer) exist, and where the blocks begin. A column counts round the
/// sector from cyclic_low, a station from leading to trailing edge, a layer from bore or back face to hub and on to
/// the tip.
class SectorLattice {
 public:
  explicit SectorLattice(const SectorPlan& plan);

  /// Columns, stations, layers, in elements.
  const std::array<int, 3>& size() const { return size_; }
  int hub_layer() const { return disc_layers_; }  ///< the first layer above the hub
  std::optional<Region> region(const std::array<int, 3>& cell) const;
  /// The middle of what carries contact (the main blade, or a bare disc's sector; the splitter), in half columns.
  int contact_half_column(BladeKind blade) const;

  /// Angles of all half columns against the main blade's middle [rad], between the two cuts, or between the sides of
  /// a blade without a disc: even within each block.
  std::vector<double> angles(const SectorPlan& plan, double half_width_main, double half_width_splitter) const;

 private:
  enum class Block { gap, main, splitter };
  struct Columns {
    Block block;
    int count;
  };
  Block block_of(int column) const;

  std::vector<Columns> blocks_;
  std::array<int, 3> size_{};
  int disc_layers_;
  int splitter_first_station_;
};

}  // namespace tiprub::mesh
