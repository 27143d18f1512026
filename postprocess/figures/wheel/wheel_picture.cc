// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/wheel/wheel_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tiprub {

namespace {

constexpr int pieces = 3;       // of a face's edge: quadratic faces are drawn by triangles
constexpr int edge_pieces = 4;  // of a line

/// (pieces + 1)^2 points of a face.
std::vector<FaceShape> face_grid() {
  std::vector<FaceShape> grid;
  for (int i = 0; i <= pieces; ++i)
    for (int k = 0; k <= pieces; ++k) grid.push_back(face_shape(2.0 * i / pieces - 1, 2.0 * k / pieces - 1));
  return grid;
}

}  // namespace

View wheel_view(const FieldStudy& fields, double tilt_deg) {
  const SectorFields& sector = fields.sector;
  const std::vector<int>& contact = sector.node_set("contact");
  const bool inlet_below = sector.nodes(2, contact.front()) <= sector.nodes(2, contact.back());
  const Eigen::Vector3d axis(0, 0, inlet_below ? -1 : 1);
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
  static const std::vector<FaceShape> grid = face_grid();
  Eigen::Matrix<double, 3, 8> place;
  Eigen::Matrix<float, 3, 8> colour;
  std::vector<SurfacePicture::Corner> corners(grid.size());
  for (const SurfaceFace& face : faces) {
    if (cut_faces == CutFaces::hidden && face.side != SurfaceFace::Side::free) continue;
    for (int k = 0; k < 8; ++k) {
      place.col(k) = nodes.col(face.nodes[k]);
      colour.col(k) = colours.col(face.nodes[k]);
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const FaceShape& shape = grid[i];
      const Eigen::Vector3d along = place * shape.along_s, across = place * shape.along_t;
      corners[i] = {place * shape.value, along.cross(across),
                    (colour * shape.value.cast<float>()).cwiseMax(0.0f).cwiseMin(1.0f)};
    }
    for (std::size_t i = 0; i < pieces; ++i)
      for (std::size_t k = 0; k < pieces; ++k) {
        const auto corner = [&](std::size_t a, std::size_t b) -> const SurfacePicture::Corner& {
          return corners[(i + a) * (pieces + 1) + k + b];
        };
        picture.triangle(corner(0, 0), corner(1, 0), corner(1, 1));
        picture.triangle(corner(0, 0), corner(1, 1), corner(0, 1));
      }
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
    for (int edge = 0; edge < 4; ++edge) {
      const int first = face.nodes[edge], last = face.nodes[(edge + 1) % 4], middle = face.nodes[4 + edge];
      const auto point = [&](double t) -> Eigen::Vector3d {  // t from -1 to 1
        return 0.5 * t * (t - 1) * nodes.col(first) + (1 - t * t) * nodes.col(middle) +
               0.5 * t * (t + 1) * nodes.col(last);
      };
      for (int i = 0; i < edge_pieces; ++i)
        picture.line(point(2.0 * i / edge_pieces - 1), point(2.0 * (i + 1) / edge_pieces - 1), colour, width_px);
    }
}

int in_pixels(double length) {
  constexpr double picture_scale = 1.6;
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
