// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/field_figures.h"
#include "postprocess/figures/wheel/wheel_picture.h"

namespace tiprub {

namespace {

enum class Side {
  lower_cut,  ///< from beside the lower cut face
  bore        ///< from inside the bore and beside the upper cut face
};

View sector_view(const FieldStudy& fields, Side side) {
  const Eigen::Vector3d axis(0, 0, inlet_below(fields.sector) ? -1 : 1);
  const Eigen::Vector3d middle = fields.sector.nodes.rowwise().mean();
  const Eigen::Vector3d outward = Eigen::Vector3d(middle.x(), middle.y(), 0).normalized();
  const Eigen::Vector3d across = axis.cross(outward);
  View view;
  view.towards_viewer = side == Side::lower_cut ? Eigen::Vector3d(0.6 * axis + 0.75 * across + 0.4 * outward)
                                                : Eigen::Vector3d(0.5 * axis - 0.5 * across - 0.75 * outward);
  view.up = axis;
  view.seen = fields.sector.nodes;
  return view;
}

/// The sector with its node sets.
void draw_sector(SurfacePicture& picture, const SectorFields& sector, const std::vector<SurfaceFace>& faces) {
  constexpr double clamped_radius = 3.2, contact_radius = 5.5;  // [px]
  using namespace surface_colours;
  const Rgb* colours[] = {&metal, &lower_cut, &upper_cut};  // by SurfaceFace::Side
  std::vector<SurfaceFace> by_side[std::size(colours)];
  for (const SurfaceFace& face : faces) by_side[static_cast<int>(face.side)].push_back(face);
  for (std::size_t side = 0; side < std::size(colours); ++side)
    draw_faces(picture, by_side[side], sector.nodes, even(sector.nodes.cols(), *colours[side]), CutFaces::shown);
  draw_edges(picture, faces, sector.nodes, mesh_line, mesh_line_width);
  for (const int node : sector.node_set("clamped")) picture.ball(sector.nodes.col(node), clamped, clamped_radius);
  for (const int node : sector.node_set("contact"))
    picture.ball(sector.nodes.col(node), contact_node, contact_radius);
}

}  // namespace

Figure sector_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  constexpr int width = 1000, half = width / 2, height = 560;
  SurfacePicture picture(in_pixels(width), in_pixels(height));
  for (const Side side : {Side::lower_cut, Side::bore}) {
    picture.begin_panel(in_pixels(side == Side::lower_cut ? 25 : half + 15), in_pixels(55), in_pixels(half - 40),
                        in_pixels(height - 75), sector_view(fields, side));
    draw_sector(picture, fields.sector, faces);
  }
  Figure figure{.drawing = {.name = "sector", .width = width, .height = height, .script = "sector"},
                .title = "One sector and its node sets",
                .caption =
                    "The mesh of sector 0 from both sides. Red: clamped nodes; blue: the contact nodes on the "
                    "tip line, leading to trailing edge; green and violet: the cut faces, where the "
                    "neighbours join.",
                .data = {{"node set", "nodes"}, {}}};
  for (const auto& [name, nodes] : fields.sector.node_sets)
    figure.data.rows.push_back({name, static_cast<int>(nodes.size())});
  set_picture(figure, picture);
  return figure;
}

}  // namespace tiprub
