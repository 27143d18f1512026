// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reduce/split_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "mesh/cells/cell_kind.h"

namespace tiprub::reduce::test {

namespace {

// Corners by number in the brick, 8 its centre.
using Corners = std::vector<std::vector<int>>;

Corners corners_of(Split into) {
  if (into == Split::tet10)
    return {{0, 1, 2, 6}, {0, 5, 1, 6}, {0, 4, 5, 6}, {0, 7, 4, 6}, {0, 3, 7, 6}, {0, 2, 3, 6}};
  if (into == Split::wedge15) return {{0, 1, 2, 4, 5, 6}, {0, 2, 3, 4, 6, 7}};
  if (into == Split::hex20) return {{0, 1, 2, 3, 4, 5, 6, 7}};
  Corners pyramids;
  for (const std::vector<int>& face : cell_kind(20).faces)  // seen from the apex
    pyramids.push_back({face[3], face[2], face[1], face[0], 8});
  return pyramids;
}

const CellKind& kind_with(std::size_t corners) {
  return cell_kind(corners == 4 ? 10 : corners == 5 ? 13 : corners == 6 ? 15 : 20);
}

class Splitting {
 public:
  explicit Splitting(const SectorMesh& bricks) : bricks_(bricks) {}

  SectorMesh run(Split into) {
    std::vector<std::vector<int>> cells;
    std::vector<std::vector<int>> children(bricks_.cells.cols());
    for (int brick = 0; brick < bricks_.cell_count(); ++brick) {
      const Split now = of_brick(brick, into);
      for (const std::vector<int>& corners : corners_of(now)) {
        children[brick].push_back(static_cast<int>(cells.size()));
        cells.push_back(cell(brick, corners));
      }
    }
    return mesh(cells, children);
  }

 private:
  static Split of_brick(int brick, Split into) {
    if (into != Split::mixed && into != Split::bricks_and_wedges) return into;
    return brick % 2 == 0 ? Split::hex20 : into == Split::mixed ? Split::pyramid13 : Split::wedge15;
  }

  std::vector<int> cell(int brick, const std::vector<int>& corners) {
    const CellKind &whole = cell_kind(27), &kind = kind_with(corners.size());
    std::vector<Eigen::Vector3d> places;
    for (const int corner : corners) places.push_back(corner == 8 ? Eigen::Vector3d::Zero() : whole.places[corner]);
    for (const auto& [a, b] : kind.edges) places.push_back((places[a] + places[b]) / 2);
    Eigen::Matrix3Xd nodes(3, whole.nodes());
    for (int k = 0; k < whole.nodes(); ++k) nodes.col(k) = bricks_.nodes.col(bricks_.cells(k, brick));
    std::vector<int> numbers(places.size());
    for (std::size_t k = 0; k < places.size(); ++k) numbers[k] = number(nodes * whole.shape(places[k]));
    return numbers;
  }

  static std::array<long, 3> key(const Eigen::Vector3d& place) {
    constexpr double step = 1e-9;
    return {std::lround(place[0] / step), std::lround(place[1] / step), std::lround(place[2] / step)};
  }

  /// Neighbours come to the same place to within rounding.
  int number(const Eigen::Vector3d& place) {
    const std::array<long, 3> at = key(place);
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k)
          if (const auto known = numbers_.find({at[0] + i, at[1] + j, at[2] + k}); known != numbers_.end())
            return known->second;
    places_.push_back(place);
    return numbers_[at] = static_cast<int>(places_.size()) - 1;
  }

  std::vector<int> kept(const std::vector<int>& nodes) {
    std::vector<int> found;
    const std::size_t count = places_.size();
    for (const int node : nodes) {
      const int now = number(bricks_.nodes.col(node));
      if (static_cast<std::size_t>(now) < count) found.push_back(now);
    }
    return found;
  }

  SectorMesh mesh(const std::vector<std::vector<int>>& cells, const std::vector<std::vector<int>>& children) {
    SectorMesh made;
    made.sector_count = bricks_.sector_count;
    made.nodes.resize(3, static_cast<Eigen::Index>(places_.size()));
    for (std::size_t k = 0; k < places_.size(); ++k) made.nodes.col(static_cast<Eigen::Index>(k)) = places_[k];
    std::size_t most = 0;
    for (const std::vector<int>& nodes : cells) most = std::max(most, nodes.size());
    made.cells =
        Eigen::MatrixXi::Constant(static_cast<Eigen::Index>(most), static_cast<Eigen::Index>(cells.size()), -1);
    for (std::size_t c = 0; c < cells.size(); ++c)
      std::copy(cells[c].begin(), cells[c].end(), made.cells.col(static_cast<Eigen::Index>(c)).begin());
    made.cyclic_low = kept(bricks_.cyclic_low);
    made.cyclic_high = kept(bricks_.cyclic_high);
    made.clamped = kept(bricks_.clamped);
    made.contact_line = kept(bricks_.contact_line);
    for (const auto& [part, members] : bricks_.parts)
      for (const int brick : members)
        made.parts[part].insert(made.parts[part].end(), children[brick].begin(), children[brick].end());
    return made;
  }

  const SectorMesh& bricks_;
  std::vector<Eigen::Vector3d> places_;
  std::map<std::array<long, 3>, int> numbers_;
};

}  // namespace

SectorMesh split(const SectorMesh& bricks, Split into) {
  return Splitting(bricks).run(into);
}

void turn_axes(SectorMesh& mesh, int cell, int quarters) {
  const std::vector<Eigen::Vector3d>& places = cell_kind(static_cast<int>(mesh.cells.rows())).places;
  const Eigen::VectorXi given = mesh.cells.col(cell);
  for (std::size_t n = 0; n < places.size(); ++n) {
    Eigen::Vector3d at(places[n][1], places[n][2], places[n][0]);
    for (int k = 0; k < quarters; ++k) at = Eigen::Vector3d(-at[1], at[0], at[2]);
    const auto same = std::find_if(places.begin(), places.end(), [&](const auto& other) { return other == at; });
    mesh.cells(static_cast<Eigen::Index>(n), cell) = given[same - places.begin()];
  }
}

}  // namespace tiprub::reduce::test
