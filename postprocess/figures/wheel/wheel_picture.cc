// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/wheel/wheel_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "mesh/cells/cell_kind.h"

namespace tiprub {

namespace {

constexpr int pieces = 3;       // of a face's edge: quadratic faces are drawn by triangles
constexpr int edge_pieces = 4;  // of a line

/// The points at which a face of so many nodes is drawn, and the triangles between them.
struct FaceGrid {
  explicit FaceGrid(int nodes) {
    const bool triangle = nodes == triangle_nodes;
    std::map<std::pair<int, int>, std::size_t> number;
    for (int i = 0; i <= pieces; ++i)
      for (int k = 0; k <= (triangle ? pieces - i : pieces); ++k) {
        number[{i, k}] = shapes.size();
        const double s = static_cast<double>(i) / pieces, t = static_cast<double>(k) / pieces;
        shapes.push_back(triangle ? face_shape(nodes, s, t) : face_shape(nodes, 2 * s - 1, 2 * t - 1));
      }
    for (const auto& [at, first] : number) {
      const auto [i, k] = at;
      const auto beyond = number.find({i + 1, k + 1});
      if (const auto right = number.find({i + 1, k}); right != number.end() && number.contains({i, k + 1})) {
        const std::size_t up = number[{i, k + 1}];
        if (triangle) triangles.push_back({first, right->second, up});
        if (triangle && beyond != number.end()) triangles.push_back({right->second, beyond->second, up});
        if (!triangle) triangles.push_back({first, right->second, beyond->second});
        if (!triangle) triangles.push_back({first, beyond->second, up});
      }
    }
  }

  static constexpr int triangle_nodes = 6, quadrangle_nodes = 8;
  std::vector<Eigen::MatrixX3d> shapes;  // N, dN/ds, dN/dt; nodes x 3
  std::vector<std::array<std::size_t, 3>> triangles;
};

}  // namespace

bool inlet_below(const SectorFields& sector) {
  const std::vector<int>& contact = sector.node_set("contact");
  return sector.nodes(2, contact.front()) <= sector.nodes(2, contact.back());
}

View wheel_view(const FieldStudy& fields, double tilt_deg) {
  const SectorFields& sector = fields.sector;
  const Eigen::Vector3d axis(0, 0, inlet_below(sector) ? -1 : 1);
  const double tilt = tilt_deg * std::numbers::pi / 180;
  View view;
  view.towards_viewer = std::cos(tilt) * axis - std::sin(tilt) * Eigen::Vector3d::UnitY();
  view.up = std::sin(tilt) * axis + std::cos(tilt) * Eigen::Vector3d::UnitY();
  view.seen.resize(3, sector.nodes.cols() * sector.sector_count);
  for (int j = 0; j < sector.sector_count; ++j)
    view.seen.middleCols(j * sector.nodes.cols(), sector.nodes.cols()) = nodes_of_sector(sector, j);
  return view;
}

Eigen::Matrix3Xf even(Eigen::Index nodes, const Rgb& colour) {
  return colour.replicate(1, nodes);
}

void draw_faces(SurfacePicture& picture, const std::vector<SurfaceFace>& faces, const Eigen::Matrix3Xd& nodes,
                const Eigen::Matrix3Xf& colours, CutFaces cut_faces) {
  static const FaceGrid triangle(FaceGrid::triangle_nodes), quadrangle(FaceGrid::quadrangle_nodes);
  std::vector<SurfacePicture::Corner> corners;
  for (const SurfaceFace& face : faces) {
    if (cut_faces == CutFaces::hidden && face.side != SurfaceFace::Side::free) continue;
    const FaceGrid& grid = face.corners() == 3 ? triangle : quadrangle;
    const Eigen::Matrix3Xd place = nodes(Eigen::all, face.nodes);
    const Eigen::Matrix3Xf colour = colours(Eigen::all, face.nodes);
    corners.clear();
    for (const Eigen::MatrixX3d& shape : grid.shapes) {
      const Eigen::Matrix3d at = place * shape;  // the place, and along s and t
      corners.push_back({at.col(0), at.col(1).cross(at.col(2)),
                         (colour * shape.col(0).cast<float>()).cwiseMax(0.0f).cwiseMin(1.0f)});
    }
    for (const auto& [a, b, c] : grid.triangles) picture.triangle(corners[a], corners[b], corners[c]);
  }
}

void draw_wheel(SurfacePicture& picture, const SectorFields& sector, const std::vector<SurfaceFace>& faces,
                const std::function<Eigen::Matrix3Xd(int sector)>& nodes,
                const std::function<Eigen::Matrix3Xf(int sector)>& colours) {
  for (int j = 0; j < sector.sector_count; ++j) draw_faces(picture, faces, nodes(j), colours(j), CutFaces::hidden);
}

void draw_edges(SurfacePicture& picture, const std::vector<SurfaceFace>& faces, const Eigen::Matrix3Xd& nodes,
                const Rgb& colour, double width_px) {
  for (const SurfaceFace& face : faces)
    for (int edge = 0; edge < face.corners(); ++edge) {
      const int first = face.nodes[edge], last = face.nodes[(edge + 1) % face.corners()],
                middle = face.nodes[face.corners() + edge];
      const auto point = [&](double t) -> Eigen::Vector3d {  // t from -1 to 1
        return 0.5 * t * (t - 1) * nodes.col(first) + (1 - t * t) * nodes.col(middle) +
               0.5 * t * (t + 1) * nodes.col(last);
      };
      for (int i = 0; i < edge_pieces; ++i)
        picture.line(point(2.0 * i / edge_pieces - 1), point(2.0 * (i + 1) / edge_pieces - 1), colour, width_px);
    }
}

int in_pixels(double length) {
  constexpr double picture_scale = 1.25;
  return static_cast<int>(std::lround(picture_scale * length));
}

void set_picture(Figure& figure, const SurfacePicture& picture) {
  set_pixels(figure, picture.pixels(), 3);
}

void set_panels(Drawing& drawing, const std::vector<PanelName>& names) {
  Eigen::MatrixXd places(static_cast<Eigen::Index>(names.size()), 2);
  std::vector<std::string> texts;
  for (const PanelName& name : names) {
    places.row(static_cast<Eigen::Index>(texts.size())) << name.x, name.y;
    texts.push_back(name.text);
  }
  drawing.values.emplace_back("panel_title", texts);
  drawing.tables.push_back({"panels", {places}});
}

void set_colour_bar(Drawing& drawing, const Palette& palette, double largest, const std::string& title) {
  drawing.values.insert(
      drawing.values.end(),
      {{"palette_colours", palette.names()}, {"colour", DrawnRange{0, largest}}, {"colour_title", title}});
}

}  // namespace tiprub
