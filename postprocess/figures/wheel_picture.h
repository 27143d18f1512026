// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "postprocess/fields/field_study.h"
#include "postprocess/fields/wheel_surface.h"
#include "postprocess/figures/figure.h"
#include "postprocess/figures/surface_picture.h"

namespace tiprub {

/// Colours from small to large.
struct Palette {
  std::vector<Rgb> stops;

  Rgb at(double fraction) const;
  std::string commands() const;  ///< gnuplot's "set palette"
};
/// Light is small, so that shape shows by its shading where nothing moves; dark blue is large, or dark red.
const Palette& displacement_palette();
const Palette& stress_palette();

/// The usual look at a wheel: from its inlet's side, the axis tilted by so many degrees towards the viewer's right.
View wheel_view(const FieldStudy& fields, double tilt_deg);
inline constexpr double usual_tilt = 42;  ///< [deg]

/// Draws the faces of one sector; colours by node.
enum class CutFaces { hidden, shown };
void draw_faces(SurfacePicture& picture, const std::vector<SurfaceFace>& faces, const Eigen::Matrix3Xd& nodes,
                const Eigen::Matrix3Xf& colours, CutFaces cut_faces);
/// The edges of the bricks on it.
void draw_edges(SurfacePicture& picture, const std::vector<SurfaceFace>& faces, const Eigen::Matrix3Xd& nodes,
                const Rgb& colour, double width_px);

/// All sectors, where `nodes` says that theirs are, in the colours that `colours` gives those.
void draw_wheel(SurfacePicture& picture, const SectorFields& sector, const std::vector<SurfaceFace>& faces,
                const std::function<Eigen::Matrix3Xd(int sector)>& nodes,
                const std::function<Eigen::Matrix3Xf(int sector)>& colours);

/// Values between 0 and `largest` as colours, by node.
Eigen::Matrix3Xf painted(const Eigen::VectorXd& values, double largest, const Palette& palette);

/// A figure that shows a picture, with room for labels; `commands` are gnuplot's, in units of the screen.
Figure picture_figure(const std::string& name, int width, int height, const SurfacePicture& picture,
                      const std::string& commands);
/// Pixels of the picture along so many of the figure's.
int in_pixels(double length);

/// "set label" at a place of the screen, from 0,0 at the bottom left to 1,1.
std::string label(const std::string& text, double x, double y, const std::string& look = "center");
/// A colour bar from 0 to a value, upright, at the right of the figure.
std::string colour_bar(const Palette& palette, double largest, const std::string& title);

}  // namespace tiprub
