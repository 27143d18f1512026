// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/wheel/meridional_outline.h"

#include <algorithm>
#include <boost/polygon/polygon.hpp>
#include <cmath>

#include "postprocess/fields/blade_place.h"

namespace tiprub {

namespace {

namespace polygon = boost::polygon;
using Point = polygon::point_data<int>;
using Polygon = polygon::polygon_data<int>;
using Piece = polygon::polygon_with_holes_data<int>;

constexpr double sliver = 1e-4;  // of the largest piece's area
constexpr double steps = 1e7;    // of the whole numbers that unions are exact in, along the largest place

/// A face in the plane: corners and middles in turn.
Polygon projected(const Eigen::Matrix3Xd& nodes, const SurfaceFace& face, double step) {
  const auto corners = static_cast<std::size_t>(face.corners());
  std::vector<Point> around;
  for (std::size_t k = 0; k < face.nodes.size(); ++k) {
    const Eigen::Vector2d place = meridional(nodes.col(face.nodes[k % 2 == 0 ? k / 2 : corners + k / 2])) / step;
    around.emplace_back(static_cast<int>(std::lround(place[0])), static_cast<int>(std::lround(place[1])));
  }
  return Polygon(around.begin(), around.end());
}

Eigen::Matrix2Xd as_line(const Piece& piece, double step) {
  Eigen::Matrix2Xd line(2, static_cast<Eigen::Index>(piece.size()));
  Eigen::Index column = 0;
  for (const Point& point : piece) line.col(column++) << step * point.x(), step * point.y();
  return line;
}

}  // namespace

std::vector<Eigen::Matrix2Xd> meridional_outline(const Eigen::Matrix3Xd& nodes,
                                                 const std::vector<SurfaceFace>& faces) {
  double extent = 0;
  for (const SurfaceFace& face : faces)
    for (const int node : face.nodes)
      extent = std::max(extent, meridional(nodes.col(node)).lpNorm<Eigen::Infinity>());
  const double step = extent / steps;
  polygon::polygon_set_data<int> covered;
  for (const SurfaceFace& face : faces) covered.insert(projected(nodes, face, step));
  std::vector<Piece> pieces;
  covered.get(pieces);
  double largest = 0;
  for (const Piece& piece : pieces) largest = std::max(largest, static_cast<double>(polygon::area(piece)));
  std::vector<Eigen::Matrix2Xd> lines;
  for (const Piece& piece : pieces)
    if (polygon::area(piece) > sliver * largest) lines.push_back(as_line(piece, step));
  return lines;
}

}  // namespace tiprub
