// SPDX-License-Identifier: GPL-3.0-or-later
// The wheel at rest and its natural modes.
#include <algorithm>

#include "postprocess/figures/field_figures.h"
#include "postprocess/figures/wheel_picture.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

const Rgb metal(0.80f, 0.82f, 0.85f), orange(0.93f, 0.55f, 0.14f), red(0.85f, 0.10f, 0.12f),
    blue(0.05f, 0.30f, 0.85f), green(0.55f, 0.80f, 0.58f), violet(0.76f, 0.66f, 0.90f),
    grey_line(0.42f, 0.44f, 0.47f);
constexpr double drawn_mode = 0.07;  // of the outer radius: how far a mode's largest displacement is drawn

Eigen::Matrix3Xf even(Eigen::Index nodes, const Rgb& colour) {
  return colour.replicate(1, nodes);
}

/// One view of the sector with its node sets.
void draw_sector(SurfacePicture& picture, const SectorFields& sector, const std::vector<SurfaceFace>& faces) {
  std::vector<SurfaceFace> by_side[3];
  for (const SurfaceFace& face : faces) by_side[static_cast<int>(face.side)].push_back(face);
  const Eigen::Index nodes = sector.nodes.cols();
  draw_faces(picture, by_side[0], sector.nodes, even(nodes, metal), CutFaces::shown);
  draw_faces(picture, by_side[1], sector.nodes, even(nodes, green), CutFaces::shown);
  draw_faces(picture, by_side[2], sector.nodes, even(nodes, violet), CutFaces::shown);
  draw_edges(picture, faces, sector.nodes, grey_line, 0.7);
  for (const int node : sector.node_set("clamped")) picture.ball(sector.nodes.col(node), red, 3.2);
  for (const int node : sector.node_set("contact")) picture.ball(sector.nodes.col(node), blue, 5.5);
}

/// The wheel moved by a mode, coloured by how far.
void draw_mode(SurfacePicture& picture, const SectorFields& sector, const std::vector<SurfaceFace>& faces,
               const ModeField& mode) {
  const WheelField field = on_wheel({mode.wave}, sector.sector_count);
  const double largest = largest_displacement(field), size = drawn_mode * outer_radius(sector) / largest;
  const auto moved = [&](int j) -> const Eigen::Matrix3Xd& {
    return field.displacement[static_cast<std::size_t>(j)];
  };
  draw_wheel(
      picture, sector, faces, [&](int j) -> Eigen::Matrix3Xd { return nodes_of_sector(sector, j) + size * moved(j); },
      [&](int j) { return painted(moved(j).colwise().norm().transpose(), largest, displacement_palette()); });
}

}  // namespace

Figure wheel_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  constexpr int width = 900, height = 620;
  const SectorFields& sector = fields.sector;
  SurfacePicture picture(in_pixels(width), in_pixels(height));
  View view = wheel_view(fields, usual_tilt);
  picture.begin_panel(in_pixels(20), in_pixels(15), in_pixels(width - 40), in_pixels(height - 30), view);
  draw_wheel(
      picture, fields.sector, faces, [&](int j) { return nodes_of_sector(sector, j); },
      [&](int j) { return even(sector.nodes.cols(), j == 0 ? orange : metal); });
  Figure figure = picture_figure("wheel", width, height, picture,
                                 label("sector 0", 0.03, 0.94, "left font ',14' textcolor rgb '#c96f10'"));
  figure.title = "The wheel";
  figure.caption = std::to_string(sector.sector_count) + " sectors; in colour the one that was meshed and reduced (" +
                   std::to_string(sector.nodes.cols()) + " nodes, " + std::to_string(sector.cells.cols()) +
                   " bricks). Seen from the inlet.";
  figure.data = {{"sectors", "nodes a sector", "bricks a sector", "outer radius [m]"},
                 {{sector.sector_count, static_cast<int>(sector.nodes.cols()), static_cast<int>(sector.cells.cols()),
                   outer_radius(sector)}}};
  return figure;
}

Figure sector_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  constexpr int width = 1000, half = width / 2, height = 560;
  const SectorFields& sector = fields.sector;
  SurfacePicture picture(in_pixels(width), in_pixels(height));
  const View wheel = wheel_view(fields, usual_tilt);
  const Eigen::Vector3d axis(0, 0, wheel.towards_viewer.z() > 0 ? 1 : -1);
  const Eigen::Vector3d middle = sector.nodes.rowwise().mean();
  const Eigen::Vector3d outward = Eigen::Vector3d(middle.x(), middle.y(), 0).normalized();
  const Eigen::Vector3d across = axis.cross(outward);
  for (const double side : {1.0, -1.0}) {
    View view;
    // Once from beside the lower cut face, once from inside the bore and beside the upper one.
    view.towards_viewer = side > 0 ? Eigen::Vector3d(0.6 * axis + 0.75 * across + 0.4 * outward)
                                   : Eigen::Vector3d(0.5 * axis - 0.5 * across - 0.75 * outward);
    view.up = axis;
    view.seen = sector.nodes;
    picture.begin_panel(in_pixels(side > 0 ? 25 : half + 15), in_pixels(55), in_pixels(half - 40),
                        in_pixels(height - 75), view);
    draw_sector(picture, sector, faces);
  }
  const auto key = [&](const std::string& words, double x, const char* colour) {
    return label("\xE2\x97\x8F " + words, x, 0.955, "left font ',13' textcolor rgb '" + std::string(colour) + "'");
  };
  Figure figure = picture_figure("sector", width, height, picture,
                                 key("clamped", 0.07, "#d91a1f") + key("contact nodes", 0.24, "#0d4dd9") +
                                     key("lower cut face", 0.47, "#3f8a4c") + key("upper cut face", 0.71, "#7d5fa8"));
  figure.title = "One sector and its node sets";
  figure.caption =
      "The mesh of sector 0 from both sides. Red: clamped nodes; blue: the contact nodes on the tip line, "
      "leading to trailing edge; green and violet: the cut faces, where the neighbours join.";
  figure.data = {{"node set", "nodes"}, {}};
  for (const auto& [name, nodes] : sector.node_sets)
    figure.data.rows.push_back({name, static_cast<int>(nodes.size())});
  return figure;
}

Figure mode_shapes_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  int families = 0;
  for (const ModeField& mode : fields.modes) families = std::max(families, mode.family + 1);
  const int columns = std::max(1, static_cast<int>(fields.modes.size()) / std::max(1, families));
  constexpr int cell = 330, cell_height = 270, bar = 90, top = 10;
  const int width = columns * cell + bar, height = families * cell_height + top;
  SurfacePicture picture(in_pixels(width), in_pixels(height));
  std::string labels;
  Table data{{"nodal diameter", "family", "frequency [Hz]", "speed [rpm]"}, {}};
  for (std::size_t i = 0; i < fields.modes.size(); ++i) {
    const ModeField& mode = fields.modes[i];
    const int n = mode.wave.nodal_diameter, column = static_cast<int>(i) / families, row = mode.family;
    picture.begin_panel(in_pixels(column * cell + 8), in_pixels(top + row * cell_height + 30), in_pixels(cell - 16),
                        in_pixels(cell_height - 34), wheel_view(fields, usual_tilt));
    draw_mode(picture, fields.sector, faces, mode);
    labels +=
        label("nodal diameter " + std::to_string(n) + ", family " + std::to_string(mode.family + 1) + ": " +
                  fixed(mode.frequency, 0) + " Hz",
              (column + 0.5) * cell / width, 1 - (top + row * cell_height + 16.0) / height, "center font ',12'");
    data.rows.push_back({n, mode.family + 1, mode.frequency, fields.speed * rpm_per_rad_s});
  }
  Figure figure = picture_figure("mode_shapes", width, height, picture,
                                 labels + colour_bar(displacement_palette(), 1, "displacement"));
  figure.data = std::move(data);
  figure.title = "Mode shapes";
  figure.caption = "Natural modes at " + rpm_text(fields.speed) +
                   ", of the nodal diameters that the casing's lowest harmonics drive. Largest displacement 1 in "
                   "each, drawn as " +
                   fixed(100 * drawn_mode, 0) +
                   " % of the outer radius. A nodal diameter strictly between 0 and N/2 has this shape at any angle.";
  figure.fields = {"fields/modes_wheel.vtu", "fields/modes_sector.vtu"};
  return figure;
}

}  // namespace tiprub
