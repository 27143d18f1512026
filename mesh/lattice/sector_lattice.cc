// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/lattice/sector_lattice.h"

#include <cassert>

namespace tiprub::mesh {

SectorLattice::SectorLattice(const SectorPlan& plan)
    : disc_layers_(plan.elements.disc), splitter_first_station_(plan.elements.upstream) {
  const ElementCounts& elements = plan.elements;
  const int passage = elements.between_blades;
  switch (plan.blades) {
    case Blades::none:
      blocks_ = {{Block::gap, passage}};
      break;
    case Blades::main:
      blocks_ = {{Block::main, elements.blade}};
      if (plan.has_disc())
        blocks_ = {{Block::gap, passage / 2}, {Block::main, elements.blade}, {Block::gap, passage / 2}};
      break;
    case Blades::main_and_splitter:
      blocks_ = {{Block::gap, passage / 2},
                 {Block::main, elements.blade},
                 {Block::gap, passage},
                 {Block::splitter, elements.splitter},
                 {Block::gap, passage / 2}};
      break;
  }
  size_ = {0, elements.chord, elements.disc + (plan.blades == Blades::none ? 0 : elements.span)};
  for (const Columns& columns : blocks_) size_[0] += columns.count;
}

SectorLattice::Block SectorLattice::block_of(int column) const {
  for (const Columns& columns : blocks_) {
    if (column < columns.count) return columns.block;
    column -= columns.count;
  }
  assert(false);
  return Block::gap;
}

std::optional<Region> SectorLattice::region(const std::array<int, 3>& cell) const {
  for (int d = 0; d < 3; ++d)
    if (cell[d] < 0 || cell[d] >= size_[d]) return std::nullopt;
  const auto [column, station, layer] = cell;
  if (layer < disc_layers_) return Region::disc;
  const Block block = block_of(column);
  if (block == Block::main) return Region::main_blade;
  if (block == Block::splitter && station >= splitter_first_station_) return Region::splitter;
  return std::nullopt;
}

int SectorLattice::contact_half_column(BladeKind blade) const {
  const Block wanted = blade == BladeKind::main ? Block::main : Block::splitter;
  int first = 0;
  for (const Columns& columns : blocks_) {
    if (columns.block == wanted) return 2 * first + columns.count;
    first += columns.count;
  }
  return size_[0];
}

std::vector<double> SectorLattice::angles(const SectorPlan& plan, double half_width_main,
                                          double half_width_splitter) const {
  const bool has_splitter = plan.blades == Blades::main_and_splitter;
  const double splitter = plan.splitter_pitch * plan.pitch();
  // The cut halves the passage between this main blade and the splitter, or the main blade, of the sector before.
  const double low = 0.5 * (has_splitter ? splitter - plan.pitch() : -plan.pitch());
  std::vector<double> borders;
  if (plan.has_disc()) borders.push_back(low);
  if (plan.blades != Blades::none) borders.insert(borders.end(), {-half_width_main, half_width_main});
  if (has_splitter) borders.insert(borders.end(), {splitter - half_width_splitter, splitter + half_width_splitter});
  if (plan.has_disc()) borders.push_back(low + plan.pitch());

  std::vector<double> angles = {borders.front()};
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const int halves = 2 * blocks_[b].count;
    for (int half = 1; half <= halves; ++half)
      angles.push_back(borders[b] + (borders[b + 1] - borders[b]) * half / halves);
  }
  return angles;
}

}  // namespace tiprub::mesh
