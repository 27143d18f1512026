// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh of a sector: its meridional section, and where its errors come from.
#include <Eigen/Geometry>
#include <algorithm>
#include <boost/polygon/polygon.hpp>
#include <cmath>
#include <set>

#include "mesh/cells/cell_kind.h"
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

/// The share [%] of each cell in the whole.
Eigen::VectorXd shares(const Eigen::VectorXd& errors) {
  const double sum = errors.sum();
  return sum > 0 ? Eigen::VectorXd(errors * (percent / sum)) : Eigen::VectorXd::Zero(errors.size());
}

/// The faces of the surface, one after the other in lines of two points: two edges across from each other, and a line
/// without colour, so that nothing is drawn from face to face. Columns: the axis, around it and outwards through the
/// contact nodes [mm], then the shares of the face's cell [%].
Eigen::MatrixXd coloured_faces(const SectorFields& sector, const Eigen::VectorXd& frequency,
                               const Eigen::VectorXd& compliance) {
  constexpr Eigen::Index rows_of_face = 9;
  const Eigen::Vector3d tip = sector.nodes(Eigen::all, sector.node_set("contact")).rowwise().mean();
  const Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(), outwards = Eigen::Vector3d(tip[0], tip[1], 0).normalized();
  Eigen::Matrix3d directions;
  directions << axis, axis.cross(outwards), outwards;
  const Eigen::Matrix3Xd places = mm_per_m * directions.transpose() * sector.nodes;
  const std::vector<SurfaceFace> faces = sector_surface(sector);
  Eigen::MatrixXd rows =
      Eigen::MatrixXd::Constant(rows_of_face * static_cast<Eigen::Index>(faces.size()), 5, std::nan(""));
  Eigen::Index first = 0;
  for (const SurfaceFace& face : faces) {
    const auto set_corner = [&](Eigen::Index row, int corner) {
      rows.row(first + row) << places.col(face.nodes[static_cast<std::size_t>(corner)]).transpose(),
          frequency[face.cell], compliance[face.cell];
    };
    set_corner(0, 0);
    set_corner(1, 1);
    set_corner(3, face.corners() - 1);
    set_corner(4, 2);  // of a triangle, its last corner once more
    rows.block<2, 3>(first + 6, 0).setZero();
    first += rows_of_face;
  }
  return rows;
}

Table share_table(const SectorFields& sector, const Eigen::VectorXd& frequency, const Eigen::VectorXd& compliance) {
  Table table{{"cell", "x [mm]", "y [mm]", "z [mm]", "share of frequencies [%]", "share of compliances [%]"}, {}};
  for (Eigen::Index cell = 0; cell < sector.cells.cols(); ++cell) {
    const Eigen::Vector3d middle = mm_per_m * sector.nodes(Eigen::all, nodes_of(sector.cells, cell)).rowwise().mean();
    table.rows.push_back(
        {static_cast<int>(cell), middle[0], middle[1], middle[2], frequency[cell], compliance[cell]});
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

Figure mesh_error_figure(const FieldStudy& fields) {
  constexpr double least_of_largest = 1e-4;  // where the colours begin
  const SectorFields& sector = fields.sector;
  const Eigen::VectorXd frequency = shares(fields.mesh_error_of_frequencies),
                        compliance = shares(fields.mesh_error_of_compliances);
  Eigen::Index worst = 0;
  frequency.maxCoeff(&worst);
  const double place = sector.nodes(Eigen::all, nodes_of(sector.cells, worst)).rowwise().mean().head<2>().norm();
  Figure figure = listed_figure("mesh_error", {{"largest", significant(frequency[worst], 2)},
                                               {"radius", fixed(mm_per_m * place, 1)},
                                               {"cells", std::to_string(sector.cells.cols())}});
  const double largest = std::max(frequency.maxCoeff(), compliance.maxCoeff()), least = least_of_largest * largest;
  figure.drawing.values = {{"share", DrawnRange{least, largest}.widened()}};
  figure.drawing.tables = {
      {"faces", {coloured_faces(sector, frequency.cwiseMax(least), compliance.cwiseMax(least))}}};
  figure.data = share_table(sector, frequency, compliance);
  return figure;
}

}  // namespace tiprub::postprocess
