// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/wheel_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>

namespace tiprub {

namespace {

constexpr int pieces = 3;       // of a face's edge: quadratic faces are drawn by triangles
constexpr int edge_pieces = 4;  // of a line

Rgb rgb(int number) {
  return Rgb(static_cast<float>(number >> 16 & 255), static_cast<float>(number >> 8 & 255),
             static_cast<float>(number & 255)) /
         255.0f;
}

struct Grid {
  std::vector<FaceShape> points;  // (pieces + 1)^2
};

Grid face_grid() {
  Grid grid;
  for (int i = 0; i <= pieces; ++i)
    for (int k = 0; k <= pieces; ++k) grid.points.push_back(face_shape(2.0 * i / pieces - 1, 2.0 * k / pieces - 1));
  return grid;
}

}  // namespace

Rgb Palette::at(double fraction) const {
  const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const auto share = static_cast<float>(place - static_cast<double>(below));
  return (1 - share) * stops[below] + share * stops[below + 1];
}

std::string Palette::commands() const {
  std::string text = "set palette defined (";
  for (std::size_t i = 0; i < stops.size(); ++i) {
    char colour[32];
    std::snprintf(colour, sizeof colour, "%zu '#%02x%02x%02x'", i, static_cast<int>(std::lround(255 * stops[i][0])),
                  static_cast<int>(std::lround(255 * stops[i][1])), static_cast<int>(std::lround(255 * stops[i][2])));
    text += (i > 0 ? ", " : "") + std::string(colour);
  }
  return text + ")\n";
}

const Palette& displacement_palette() {
  static const Palette palette{{rgb(0xe6eaee), rgb(0xc7e9b4), rgb(0x7fcdbb), rgb(0x41b6c4), rgb(0x1d91c0),
                                rgb(0x225ea8), rgb(0x253494), rgb(0x081d58)}};
  return palette;
}

const Palette& stress_palette() {
  static const Palette palette{{rgb(0xe9edf2), rgb(0xc9dcea), rgb(0xa3d1c8), rgb(0xc5e08b), rgb(0xf6e45f),
                                rgb(0xf9b13f), rgb(0xee6f30), rgb(0xcf2f28), rgb(0x8c0d20)}};
  return palette;
}

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

void draw_faces(SurfacePicture& picture, const std::vector<SurfaceFace>& faces, const Eigen::Matrix3Xd& nodes,
                const Eigen::Matrix3Xf& colours, CutFaces cut_faces) {
  static const Grid grid = face_grid();
  Eigen::Matrix<double, 3, 8> place;
  Eigen::Matrix<float, 3, 8> colour;
  std::vector<SurfacePicture::Corner> corners(grid.points.size());
  for (const SurfaceFace& face : faces) {
    if (cut_faces == CutFaces::hidden && face.side != SurfaceFace::Side::free) continue;
    for (int k = 0; k < 8; ++k) {
      place.col(k) = nodes.col(face.nodes[k]);
      colour.col(k) = colours.col(face.nodes[k]);
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const FaceShape& shape = grid.points[i];
      const Eigen::Vector3d along = place * shape.along_s, across = place * shape.along_t;
      corners[i] = {place * shape.value, along.cross(across),
                    (colour * shape.value.cast<float>()).cwiseMax(0.0f).cwiseMin(1.0f)};
    }
    for (int i = 0; i < pieces; ++i)
      for (int k = 0; k < pieces; ++k) {
        const auto corner = [&](int a, int b) -> const SurfacePicture::Corner& {
          return corners[static_cast<std::size_t>((i + a) * (pieces + 1) + k + b)];
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

Eigen::Matrix3Xf painted(const Eigen::VectorXd& values, double largest, const Palette& palette) {
  Eigen::Matrix3Xf colours(3, values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i) colours.col(i) = palette.at(values[i] / largest);
  return colours;
}

void draw_edges(SurfacePicture& picture, const std::vector<SurfaceFace>& faces, const Eigen::Matrix3Xd& nodes,
                const Rgb& colour, double width_px) {
  for (const SurfaceFace& face : faces)
    for (int edge = 0; edge < 4; ++edge) {
      const int first = face.nodes[edge], last = face.nodes[(edge + 1) % 4], middle = face.nodes[4 + edge];
      const auto at = [&](double t) -> Eigen::Vector3d {  // t from -1 to 1
        return 0.5 * t * (t - 1) * nodes.col(first) + (1 - t * t) * nodes.col(middle) +
               0.5 * t * (t + 1) * nodes.col(last);
      };
      for (int i = 0; i < edge_pieces; ++i)
        picture.line(at(2.0 * i / edge_pieces - 1), at(2.0 * (i + 1) / edge_pieces - 1), colour, width_px);
    }
}

int in_pixels(double length) {
  constexpr double picture_scale = 1.6;
  return static_cast<int>(std::lround(picture_scale * length));
}

Figure picture_figure(const std::string& name, int width, int height, const SurfacePicture& picture,
                      const std::string& commands) {
  Figure figure;
  figure.pixels.push_back({name + ".pixels", picture.pixels()});
  const Eigen::MatrixXf& values = figure.pixels.back().values;
  std::ostringstream out;
  out << "unset border\nunset tics\nunset key\nset lmargin at screen 0\nset rmargin at screen 1\nset tmargin at "
         "screen 1\nset bmargin at screen 0\nset xrange [0:"
      << values.cols() / 3 << "]\nset yrange [0:" << values.rows() << "]\n"
      << commands << "plot '" << figure.pixels.back().file << "' binary array=(" << values.cols() / 3 << ","
      << values.rows() << ") format='%float32%float32%float32' origin=(0.5,0.5) with rgbimage"
      << (commands.find("colorbox") != std::string::npos ? ", '+' using (-1):(-1):(0) with points palette" : "")
      << "\n";
  figure.drawing = {name, width, height, out.str()};
  return figure;
}

std::string label(const std::string& text, double x, double y, const std::string& look) {
  std::ostringstream out;
  out << "set label " << gnuplot_quoted(text) << " at screen " << x << "," << y << " " << look << " front\n";
  return out.str();
}

std::string colour_bar(const Palette& palette, double largest, const std::string& title) {
  std::ostringstream out;
  out << palette.commands() << "set cbrange [0:" << largest
      << "]\nset cbtics nomirror out scale 0.5\nset colorbox user origin screen 0.905,0.14 size screen 0.02,0.7\n"
      << label(title, 0.925, 0.9, "center font ',12'");
  return out.str();
}

}  // namespace tiprub
