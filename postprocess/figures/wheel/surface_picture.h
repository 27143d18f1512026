// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "postprocess/figures/wheel/surface_colours.h"

namespace tiprub {

/// Parallel projection: which way is towards the viewer, what is up, and the box that must be seen.
struct View {
  Eigen::Vector3d towards_viewer = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  Eigen::Matrix3Xd seen;  ///< [m] points that must fit into the panel
};

/// A shaded picture of surfaces, drawn with a depth buffer at several samples a pixel: lit from over the viewer's
/// shoulder, with dark lines where the surface turns sharply or ends before another. Enough for a wheel; no more.
class SurfacePicture {
 public:
  SurfacePicture(int width, int height);

  struct Corner {
    Eigen::Vector3d place;   ///< [m]
    Eigen::Vector3d normal;  ///< of any length and either sense
    Rgb colour;
  };
  /// All that follows goes into this part of the picture [px, from the top left].
  void begin_panel(int left, int top, int width, int height, const View& view);
  void triangle(const Corner& a, const Corner& b, const Corner& c);
  /// A thin line on the surface.
  void line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Rgb& colour, double width_px);
  /// A ball on the surface.
  void ball(const Eigen::Vector3d& place, const Rgb& colour, double radius_px);
  /// Where a point falls [px, from the top left].
  Eigen::Vector2d place_of(const Eigen::Vector3d& point) const;

  /// Red, green, blue 0 .. 255 in turn; rows go up; height x 3 width.
  Eigen::MatrixXf pixels() const;

 private:
  struct Sample {
    float depth;  ///< towards the viewer
    Eigen::Vector3f normal;
    Rgb colour;
  };
  Eigen::Vector3d project(const Eigen::Vector3d& point) const;  ///< x, y [samples], depth [samples]
  Sample& sample(int x, int y) {
    return samples_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + x];
  }
  const Sample& sample(int x, int y) const {
    return samples_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + x];
  }
  Rgb shaded(int x, int y) const;
  void dot(double x, double y, double depth, double radius, const Rgb& colour);

  int width_, height_;  ///< [samples]
  std::vector<Sample> samples_;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();      ///< rows: right, up, towards the viewer
  Eigen::Vector2d middle_ = Eigen::Vector2d::Zero();        ///< [m] of what is seen
  Eigen::Vector2d panel_middle_ = Eigen::Vector2d::Zero();  ///< [samples]
  Eigen::Vector4i panel_ = Eigen::Vector4i::Zero();         ///< left, top, right, bottom [samples]
  double scale_ = 1;                                        ///< [samples/m]
};

}  // namespace tiprub
