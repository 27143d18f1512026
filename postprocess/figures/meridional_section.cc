// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/polygon/polygon.hpp>
#include <cmath>
#include <set>

#include "postprocess/fields/field_recovery.h"
#include "postprocess/fields/sector_geometry.h"
#include "postprocess/figures/axes.h"
#include "postprocess/figures/study_figures.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

namespace polygon = boost::polygon;
using Point = polygon::point_data<int>;
using Polygon = polygon::polygon_data<int>;
using Piece = polygon::polygon_with_holes_data<int>;

constexpr double sliver = 1e-4;  // of the largest piece's area
constexpr double steps = 1e7;    // whole numbers, in which unions are exact, along the largest coordinate

/// A face in the plane: corners and middle nodes alternate.
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

constexpr double drawn_gap = 0.02;  // of the outer radius, at least: how wide the mean gap is drawn

/// A line in r, z [m], 2 x points, with the name that is shown.
struct SectionLine {
  std::string name;
  Eigen::Matrix2Xd points;
};

/// Whether the inlet is at the lower end of the axis.
bool inlet_below(const SectorFields& sector) {
  const std::vector<int>& contact = sector.node_set("contact");
  return sector.nodes(2, contact.front()) <= sector.nodes(2, contact.back());
}

/// The outlines of the mesh's parts, or of the whole sector if the mesh does not name its parts.
std::vector<SectionLine> outlines(const SectorFields& sector) {
  std::vector<SectionLine> lines;
  const auto add = [&](const std::string& name, const std::vector<SurfaceFace>& of) {
    for (Eigen::Matrix2Xd& points : meridional_outline(sector.nodes, of)) lines.push_back({name, std::move(points)});
  };
  for (const auto& [part, cells] : sector.parts)
    add(spoken(part), sector_surface(sector, sector.cells(Eigen::all, cells)));
  if (sector.parts.empty()) add("wheel", sector_surface(sector));
  return lines;
}

/// The points of some nodes in the meridional plane; nodes on one circle around the axis are one point.
Eigen::Matrix2Xd distinct(const SectorFields& sector, const std::vector<int>& nodes) {
  const double grid = 1e-6 * outer_radius(sector);
  std::set<std::pair<long, long>> seen;
  std::vector<Eigen::Vector2d> found;
  for (const int node : nodes) {
    const Eigen::Vector2d place = meridional(sector.nodes.col(node));
    if (seen.emplace(std::lround(place[0] / grid), std::lround(place[1] / grid)).second) found.push_back(place);
  }
  Eigen::Matrix2Xd points(2, static_cast<Eigen::Index>(found.size()));
  for (std::size_t i = 0; i < found.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = found[i];
  return points;
}

/// The round casing over the main blade's contact nodes, with its gap `times` as wide.
Eigen::Matrix2Xd casing(const ContactLine& contact, const Eigen::VectorXd& clearance, double times) {
  Eigen::Matrix2Xd points(2, contact.trailing_edge() + 1);
  for (int k = 0; k <= contact.trailing_edge(); ++k) {
    const double gap = times * clearance[k];
    points.col(k) << contact.position(k, 0) + gap * contact.normal(k, 0),
        contact.position(k, 2) + gap * contact.normal(k, 2);
  }
  return points;
}

/// How many times as wide the gap is drawn: at least 1, and a whole number with one digit that is not 0.
double gap_factor(double mean, double radius) {
  if (!(mean > 0)) return 1;
  const double wanted = drawn_gap * radius / mean, tens = std::pow(10.0, std::floor(std::log10(wanted)));
  return wanted > 1 ? std::ceil(wanted / tens) * tens : 1;
}

/// z, r [mm]: as it is drawn.
Eigen::MatrixXd drawn(const Eigen::Matrix2Xd& points) {
  return mm_per_m * points.colwise().reverse().transpose();
}

void set_outlines(Drawing& drawing, const std::vector<SectionLine>& lines) {
  std::vector<std::string> titles;
  ScriptTable sheets{"outlines", {}};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    titles.push_back(i > 0 && lines[i - 1].name == lines[i].name ? "" : lines[i].name);
    sheets.sheets.push_back(drawn(lines[i].points));
  }
  drawing.values.emplace_back("outline_title", titles);
  drawing.tables.push_back(std::move(sheets));
}

Table section_table(const std::vector<SectionLine>& lines) {
  Table table{{"line", "piece", "r [mm]", "z [mm]"}, {}};
  for (std::size_t i = 0, piece = 0; i < lines.size(); ++i) {
    piece = i > 0 && lines[i - 1].name == lines[i].name ? piece + 1 : 0;
    for (const auto& point : lines[i].points.colwise())
      table.rows.push_back({lines[i].name, static_cast<int>(piece), point[0] * mm_per_m, point[1] * mm_per_m});
  }
  return table;
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

Figure meridional_section_figure(const SectorFields& sector, const ContactLine& line,
                                 const Eigen::VectorXd& clearance) {
  const double radius = outer_radius(sector), times = gap_factor(clearance.mean(), radius);
  std::vector<SectionLine> lines = outlines(sector);
  Figure figure =
      listed_figure("meridional_section", {{"of_blade", of_main_blade(line)}, {"times", fixed(times, 0)}});
  figure.drawing.values = {{"inlet_first", inlet_below(sector) ? 1 : 0}};
  set_outlines(figure.drawing, lines);
  const std::vector<int>& tip = sector.node_set("contact");  // a splitter's nodes come last
  const Eigen::Matrix2Xd contact = distinct(sector, {tip.begin(), tip.end() - line.splitter_nodes}),
                         clamped = distinct(sector, sector.node_set("clamped"));
  figure.drawing.tables.push_back({"casing", {drawn(casing(line, clearance, times))}});
  figure.drawing.tables.push_back({"contact", {drawn(contact)}});
  figure.drawing.tables.push_back({"clamped", {drawn(clamped)}});
  for (SectionLine& more : std::vector<SectionLine>{
           {"casing", casing(line, clearance, 1)}, {"contact nodes", contact}, {"clamped nodes", clamped}})
    lines.push_back(std::move(more));
  figure.data = section_table(lines);
  return figure;
}

}  // namespace tiprub::postprocess
