// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/sector_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/cells/cell_kind.h"

namespace tiprub::postprocess {

namespace {

constexpr int lines_along = 101;
constexpr double edge_length = 0.1, root_span = 0.1, low_span = 0.35,
                 high_span = 0.65;  // shares at which the words change

/// Points at even shares of a polyline's length.
Eigen::Matrix2Xd even_points(const std::vector<Eigen::Vector2d>& line) {
  std::vector<double> way = {0};
  for (std::size_t k = 1; k < line.size(); ++k) way.push_back(way.back() + (line[k] - line[k - 1]).norm());
  Eigen::Matrix2Xd points(2, lines_along);
  std::size_t k = 0;
  for (int i = 0; i < lines_along; ++i) {
    const double at = way.back() * i / (lines_along - 1);
    while (k + 2 < line.size() && way[k + 1] < at) ++k;
    const double step = way[k + 1] - way[k];
    points.col(i) = line[k] + (step > 0 ? std::min(1.0, (at - way[k]) / step) : 0.0) * (line[k + 1] - line[k]);
  }
  return points;
}

std::string length_words(double length) {
  if (length < edge_length) return " at the leading edge";
  if (length > 1 - edge_length) return " at the trailing edge";
  return " at " + std::to_string(std::lround(100 * length)) + " % of its length";
}

}  // namespace

std::string spoken(std::string part) {
  std::ranges::replace(part, '_', ' ');
  return part;
}

Eigen::Vector2d meridional(const Eigen::Vector3d& place) {
  return {std::hypot(place[0], place[1]), place[2]};
}

const std::vector<int>& tip_line(const SectorFields& sector) {
  const auto known = sector.node_sets.find("contact_line");
  return known != sector.node_sets.end() ? known->second : sector.node_set("contact");
}

BladePlaces::BladePlaces(const SectorFields& sector) : sector_(sector) {
  for (const auto& [part, cells] : sector.parts) {
    std::vector<int>& count = bricks_[part];
    count.resize(static_cast<std::size_t>(sector.nodes.cols()));
    for (const int cell : cells)
      for (const int node : nodes_of(sector.cells, cell)) ++count[static_cast<std::size_t>(node)];
  }
  for (const auto& [part, cells] : sector.parts)
    if (part != disc_part && bricks_of(part, tip_line(sector).front()) > 0) lay_lines(part);
  if (tip_.cols() == 0) return;
  for (const auto& [part, cells] : sector.parts) {
    if (part == disc_part) continue;
    auto& [first, last] = length_ends_[part] = {1, 0};
    for (int node = 0; node < sector.nodes.cols(); ++node) {
      if (bricks_of(part, node) == 0) continue;
      first = std::min(first, share(node).length);
      last = std::max(last, share(node).length);
    }
  }
}

int BladePlaces::bricks_of(const std::string& part, int node) const {
  const auto known = bricks_.find(part);
  return known == bricks_.end() ? 0 : known->second[static_cast<std::size_t>(node)];
}

/// Orders the root's points in the direction from the first to the last point of the tip line.
void BladePlaces::lay_lines(const std::string& blade) {
  std::vector<Eigen::Vector2d> tip, root;
  for (const int node : tip_line(sector_)) tip.push_back(meridional(sector_.nodes.col(node)));
  for (int node = 0; node < sector_.nodes.cols(); ++node)
    if (bricks_of(blade, node) > 0 && bricks_of(disc_part, node) > 0)
      root.push_back(meridional(sector_.nodes.col(node)));
  if (tip.size() < 2 || root.size() < 2) return;
  const Eigen::Vector2d onwards = tip.back() - tip.front();
  std::ranges::sort(root, {}, [&](const Eigen::Vector2d& place) { return place.dot(onwards); });
  root_ = even_points(root);
  tip_ = even_points(tip);
}

/// Reads span and length from the nearest line.
BladePlaces::Share BladePlaces::share(int node) const {
  const Eigen::Vector2d place = meridional(sector_.nodes.col(node));
  double nearest = std::numeric_limits<double>::infinity();
  Share found{};
  for (int i = 0; i < lines_along; ++i) {
    const Eigen::Vector2d up = tip_.col(i) - root_.col(i), from = place - root_.col(i);
    const double span = up.squaredNorm() > 0 ? std::clamp(from.dot(up) / up.squaredNorm(), 0.0, 1.0) : 0.0;
    const double distance = (from - span * up).norm();
    if (distance >= nearest) continue;
    nearest = distance;
    found = {span, static_cast<double>(i) / (lines_along - 1)};
  }
  return found;
}

std::string BladePlaces::part(int node) const {
  std::string best;
  int most = 0;
  for (const auto& [part, count] : bricks_)
    if (bricks_of(part, node) > most) {
      best = part;
      most = bricks_of(part, node);
    }
  return best;
}

std::string BladePlaces::words(int node) const {
  for (const auto& [blade, ends] : length_ends_) {
    if (bricks_of(blade, node) == 0) continue;
    const Share here = share(node);
    const double range = ends.second - ends.first;
    const std::string length = length_words(range > 0 ? (here.length - ends.first) / range : 0);
    if (bricks_of(disc_part, node) > 0 || here.span < root_span) return "root of the " + spoken(blade) + length;
    const char* span = here.span < low_span    ? " near the root"
                       : here.span < high_span ? " at mid-span"
                                               : " near the tip";
    return spoken(blade) + span + "," + length;
  }
  return spoken(part(node));
}

std::vector<SurfaceFace> sector_surface(const SectorFields& sector, const Eigen::MatrixXi& cells) {
  const auto all_in = [&](const SurfaceFace& face, const std::vector<int>& sorted) {
    return std::ranges::all_of(face.nodes, [&](int node) { return std::ranges::binary_search(sorted, node); });
  };
  std::vector<int> low = sector.node_set("cyclic_low"), high = sector.node_set("cyclic_high");
  std::ranges::sort(low);
  std::ranges::sort(high);
  std::vector<SurfaceFace> surface;
  for (FreeFace& found : free_faces(sector.nodes, listed_cells(cells))) {
    SurfaceFace& face = surface.emplace_back(SurfaceFace{std::move(found), SurfaceFace::Side::free});
    if (all_in(face, low)) face.side = SurfaceFace::Side::cyclic_low;
    if (all_in(face, high)) face.side = SurfaceFace::Side::cyclic_high;
  }
  return surface;
}

std::vector<SurfaceFace> sector_surface(const SectorFields& sector) {
  return sector_surface(sector, sector.cells);
}

}  // namespace tiprub::postprocess
