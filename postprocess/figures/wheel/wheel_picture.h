// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "postprocess/fields/field_study.h"
#include "postprocess/fields/wheel_surface.h"
#include "postprocess/figures/figure.h"
#include "postprocess/figures/wheel/surface_picture.h"

namespace tiprub {

/// Whether the inlet is at the lower end of the axis.
bool inlet_below(const SectorFields& sector);

/// The usual look at a wheel: from its inlet's side, the axis tilted by so many degrees towards the viewer's right.
View wheel_view(const FieldStudy& fields, double tilt_deg);
inline constexpr double usual_tilt = 42;  ///< [deg]

/// One colour for so many nodes.
Eigen::Matrix3Xf even(Eigen::Index nodes, const Rgb& colour);

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

/// Gives a figure a picture that fills it (scripts/picture.gp).
void set_picture(Figure& figure, const SurfacePicture& picture);
/// Pixels of the picture along so many of the figure's.
int in_pixels(double length);

/// Gives a figure its panels' names, each with its middle in shares of the figure's width and height from the bottom
/// left, and a colour bar from 0 to `largest` (scripts/panels.gp).
struct PanelName {
  std::string text;
  double x, y;
};
void set_panels(Drawing& drawing, const std::vector<PanelName>& names);
void set_colour_bar(Drawing& drawing, const Palette& palette, double largest, const std::string& title);

}  // namespace tiprub
