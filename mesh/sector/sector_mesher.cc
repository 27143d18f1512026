// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sector/sector_mesher.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

namespace tiprub::mesh {

namespace {

/// Which cells of the box (column, station, layer) exist, and where the blocks begin. A column counts round the
/// sector from cyclic_low, a station from leading to trailing edge, a layer from bore or back face to hub and on to
/// the tip.
class SectorLattice {
 public:
  explicit SectorLattice(const SectorPlan& plan)
      : disc_layers_(plan.elements.disc), splitter_first_station_(plan.elements.upstream) {
    const ElementCounts& elements = plan.elements;
    const Columns half_passage{std::nullopt, elements.between_blades / 2}, main{BladeKind::main, elements.blade};
    const Columns passage{std::nullopt, elements.between_blades}, splitter{BladeKind::splitter, elements.splitter};
    switch (plan.blades) {
      case Blades::none:
        blocks_ = {passage};
        break;
      case Blades::main:
        blocks_ = {main};
        if (plan.has_disc()) blocks_ = {half_passage, main, half_passage};
        break;
      case Blades::main_and_splitter:
        blocks_ = {half_passage, main, passage, splitter, half_passage};
        break;
    }
    size_ = {0, elements.chord, elements.disc + (plan.blades == Blades::none ? 0 : elements.span)};
    for (const Columns& columns : blocks_) size_[0] += columns.count;
  }

  /// Columns, stations, layers, in elements.
  const std::array<int, 3>& size() const { return size_; }
  int hub_layer() const { return disc_layers_; }  ///< the first layer above the hub

  std::optional<Region> region(const std::array<int, 3>& cell) const {
    for (int d = 0; d < 3; ++d)
      if (cell[d] < 0 || cell[d] >= size_[d]) return std::nullopt;
    const auto [column, station, layer] = cell;
    if (layer < disc_layers_) return Region::disc;
    const std::optional<BladeKind> blade = blade_of(column);
    if (blade == BladeKind::main) return Region::main_blade;
    if (blade == BladeKind::splitter && station >= splitter_first_station_) return Region::splitter;
    return std::nullopt;
  }

  /// The middle of what carries contact (the main blade, or a bare disc's sector; the splitter), in half columns.
  int contact_half_column(BladeKind blade) const {
    int first = 0;
    for (const Columns& columns : blocks_) {
      if (columns.blade == blade) return 2 * first + columns.count;
      first += columns.count;
    }
    return size_[0];
  }

  /// Angles of all half columns against the main blade's middle [rad], between the two cuts, or between the sides of
  /// a blade without a disc: even within each block.
  std::vector<double> angles(const SectorPlan& plan, double half_width_main, double half_width_splitter) const {
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

 private:
  struct Columns {
    std::optional<BladeKind> blade;  ///< none in a gap
    int count;
  };

  std::optional<BladeKind> blade_of(int column) const {
    auto block = blocks_.begin();
    for (; column >= block->count; ++block) column -= block->count;
    return block->blade;
  }

  std::vector<Columns> blocks_;
  std::array<int, 3> size_{};
  int disc_layers_;
  int splitter_first_station_;
};

using Index = std::array<int, 3>;  // column, station, layer; in elements for cells, in half elements for nodes

constexpr std::size_t no_node = std::numeric_limits<std::size_t>::max();

Index operator+(const Index& a, const Index& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

enum class Side { low, high };

// The face of a cell on one side of one direction, outward normal, as the lattice offsets of its 9 nodes.
std::array<Index, 9> face_offsets(int direction, Side side) {
  Index first{0, 0, 0}, second{0, 0, 0}, start{0, 0, 0};
  first[(direction + 1) % 3] = 1;
  second[(direction + 2) % 3] = 1;
  if (side == Side::low) std::swap(first, second);
  if (side == Side::high) start[direction] = 2;
  const auto at = [&](int a, int b) {
    Index offset = start;
    for (int d = 0; d < 3; ++d) offset[d] += a * first[d] + b * second[d];
    return offset;
  };
  return {at(0, 0), at(2, 0), at(2, 2), at(0, 2), at(1, 0), at(2, 1), at(1, 2), at(0, 1), at(1, 1)};
}

class Mesher {
 public:
  explicit Mesher(const Wheel& wheel) : wheel_(wheel), lattice_(wheel.plan) {
    for (int d = 0; d < 3; ++d) nodes_across_[d] = 2 * lattice_.size()[d] + 1;
    number_.assign(std::size_t(nodes_across_[0]) * nodes_across_[1] * nodes_across_[2], no_node);
    mesh_.element = wheel.plan.element;
    mesh_.sector_count = wheel.plan.sector_count;
  }

  MeshedSector run() {
    mark_nodes();
    place_nodes();
    for_each_cell([&](const Index& cell, Region region) { add_cell(cell, region); });
    add_surfaces();
    mesh_.contact = tip_line(BladeKind::main);
    if (wheel_.plan.contact_on_splitters) mesh_.contact_splitter = tip_line(BladeKind::splitter);
    return std::move(mesh_);
  }

 private:
  template <class Visit>
  void for_each_cell(Visit visit) const {
    const auto [columns, stations, layers] = lattice_.size();
    for (int k = 0; k < layers; ++k)
      for (int i = 0; i < stations; ++i)
        for (int j = 0; j < columns; ++j)
          if (const auto region = lattice_.region({j, i, k})) visit(Index{j, i, k}, *region);
  }

  std::size_t slot(const Index& node) const {
    return (std::size_t(node[2]) * nodes_across_[1] + node[1]) * nodes_across_[0] + node[0];
  }
  /// The node at a place in the reference cell.
  static Index node_of(const Index& cell, const Eigen::Vector3d& place) {
    const Eigen::Vector3i step = place.cast<int>();
    return {2 * cell[0] + 1 + step[0], 2 * cell[1] + 1 + step[1], 2 * cell[2] + 1 + step[2]};
  }

  void mark_nodes() {
    for_each_cell([&](const Index& cell, Region) {
      for (const Eigen::Vector3d& place : mesh_.kind().places) number_[slot(node_of(cell, place))] = 0;
    });
  }

  void place_nodes() {
    for (int k = 0; k < nodes_across_[2]; ++k)
      for (int i = 0; i < nodes_across_[1]; ++i) place_row(i, k);
  }

  // All nodes of one station and one layer: a circle's arc, since radius and z don't depend on the angle.
  void place_row(int i, int k) {
    const WheelGeometry& geometry = *wheel_.geometry;
    const double station = wheel_.plan.station(i);
    const int hub = 2 * lattice_.hub_layer();
    const bool in_disc = wheel_.plan.has_disc() && k <= hub;
    const double span = in_disc ? 0.0 : wheel_.plan.span(k - hub, geometry.fillet_end(station));
    const MeridionalPoint at =
        in_disc ? geometry.disc_point(station, static_cast<double>(k) / hub) : geometry.blade_point(station, span);
    const double middle = geometry.theta(station, span);
    const std::vector<double> angles = row_angles(station, span);
    for (int j = 0; j < nodes_across_[0]; ++j) {
      std::size_t& number = number_[slot({j, i, k})];
      if (number == no_node) continue;
      number = mesh_.nodes.size();
      const bool on_cut = in_disc && j == nodes_across_[0] - 1;
      mesh_.nodes.push_back(on_cut ? partner_on_high(i, k) : on_circle(at, middle + angles[j]));
    }
  }

  std::vector<double> row_angles(double station, double span) const {
    const auto half_width = [&](BladeKind blade, bool there) {
      return there ? wheel_.geometry->half_width(blade, station, span) : 0.0;
    };
    return lattice_.angles(wheel_.plan, half_width(BladeKind::main, wheel_.plan.blades != Blades::none),
                           half_width(BladeKind::splitter, wheel_.plan.blades == Blades::main_and_splitter));
  }

  static Eigen::Vector3d on_circle(MeridionalPoint at, double theta) {
    return {at.r * std::cos(theta), at.r * std::sin(theta), at.z};
  }

  // The partner is turned, not computed anew, so that both agree to round-off.
  Eigen::Vector3d partner_on_high(int i, int k) const {
    const double c = std::cos(wheel_.plan.pitch()), s = std::sin(wheel_.plan.pitch());
    const Eigen::Vector3d& x = mesh_.nodes[number_[slot({0, i, k})]];
    return {c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]};
  }

  void add_cell(const Index& cell, Region region) {
    SectorCell added{region, cell[1], cell[0], cell[2], {}};
    for (const Eigen::Vector3d& place : mesh_.kind().places)
      added.nodes.push_back(number_[slot(node_of(cell, place))]);
    mesh_.cells.push_back(std::move(added));
  }

  // The faces on one side of the cells that are chosen and have no neighbour there.
  template <class Chosen>
  void add_faces(SectorSurface& surface, int direction, Side side, Chosen chosen) {
    const std::array<Index, 9> offsets = face_offsets(direction, side);
    Index step{0, 0, 0};
    step[direction] = side == Side::low ? -1 : 1;
    for_each_cell([&](const Index& cell, Region region) {
      if (!chosen(cell, region) || lattice_.region(cell + step)) return;
      for (int n = 0; n < mesh_.nodes_per_face(); ++n) {
        const Index corner = {2 * cell[0], 2 * cell[1], 2 * cell[2]};
        surface.face_nodes.push_back(number_[slot(corner + offsets[n])]);
      }
    });
  }

  void add_surfaces() {
    constexpr int round = 0, along = 1, up = 2;
    const auto is = [](Region wanted) { return [wanted](const Index&, Region region) { return region == wanted; }; };
    const auto at_cut = [&](int column) {
      return [column](const Index& cell, Region region) { return cell[round] == column && region == Region::disc; };
    };
    const auto add = [&](const char* name, int direction, Side side, auto chosen) {
      SectorSurface surface{name, {}};
      add_faces(surface, direction, side, chosen);
      if (!surface.face_nodes.empty()) mesh_.surfaces.push_back(std::move(surface));
    };
    add("cyclic_low", round, Side::low, at_cut(0));
    add("cyclic_high", round, Side::high, at_cut(lattice_.size()[round] - 1));
    add_clamp(along, up);
    add("hub", up, Side::high, is(Region::disc));
    add("blade_tip", up, Side::high, is(Region::main_blade));
    add("splitter_tip", up, Side::high, is(Region::splitter));
  }

  void add_clamp(int along, int up) {
    const ClampedSurface clamped = wheel_.plan.clamped;
    const int bore = wheel_.plan.elements.bore;
    SectorSurface surface{"clamped", {}};
    if (clamped == ClampedSurface::root)
      add_faces(surface, up, Side::low, [](const Index&, Region region) { return region == Region::main_blade; });
    if (clamped == ClampedSurface::bore || clamped == ClampedSurface::bore_and_front_face)
      add_faces(surface, up, Side::low,
                [&](const Index& cell, Region region) { return region == Region::disc && cell[along] < bore; });
    if (clamped == ClampedSurface::front_face || clamped == ClampedSurface::bore_and_front_face)
      add_faces(surface, along, Side::low,
                [&](const Index& cell, Region region) { return region == Region::disc && cell[along] == 0; });
    mesh_.surfaces.push_back(std::move(surface));
  }

  std::vector<std::size_t> tip_line(BladeKind blade) const {
    std::vector<std::size_t> line;
    const int middle = lattice_.contact_half_column(blade);
    for (int i = 0; i < nodes_across_[1]; ++i) {
      const std::size_t number = number_[slot({middle, i, nodes_across_[2] - 1})];
      if (number != no_node) line.push_back(number);
    }
    return line;
  }

  const Wheel& wheel_;
  SectorLattice lattice_;
  Index nodes_across_{};
  std::vector<std::size_t> number_;  // of each lattice node, no_node where none is
  MeshedSector mesh_;
};

}  // namespace

const SectorSurface& MeshedSector::surface(const std::string& name) const {
  const auto found = std::ranges::find(surfaces, name, &SectorSurface::name);
  assert(found != surfaces.end());
  return *found;
}

int MeshedSector::nodes_per_face() const {
  return element == ElementKind::hex20 ? 8 : 9;
}

MeshedSector mesh_sector(const Wheel& wheel) {
  return Mesher(wheel).run();
}

}  // namespace tiprub::mesh
