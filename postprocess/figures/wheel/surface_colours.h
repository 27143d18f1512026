// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

namespace tiprub {

using Rgb = Eigen::Vector3f;  ///< each 0 .. 1

// What the painted surfaces are coloured with; all other colours are in scripts/style.gp.
namespace surface_colours {

inline const Rgb metal(0.80f, 0.82f, 0.85f);
inline const Rgb chosen_sector(0.93f, 0.55f, 0.14f);
inline const Rgb lower_cut(0.55f, 0.80f, 0.58f), upper_cut(0.76f, 0.66f, 0.90f);
inline const Rgb clamped(0.85f, 0.10f, 0.12f), contact_node(0.05f, 0.30f, 0.85f);
inline const Rgb pushed = clamped;  ///< where the casing pushes
inline const Rgb mesh_line(0.42f, 0.44f, 0.47f);
inline constexpr double mesh_line_width = 0.7;  // [px]

}  // namespace surface_colours

/// Colours from small to large.
struct Palette {
  std::vector<int> stops;  ///< 0xrrggbb

  Rgb at(double fraction) const;
  std::vector<std::string> names() const;  ///< "#rrggbb"
};
/// Light is small, so that shape shows by its shading where nothing moves; dark blue is large, or dark red.
const Palette& displacement_palette();
const Palette& stress_palette();

/// Values between 0 and `largest` as colours, by node.
Eigen::Matrix3Xf painted(const Eigen::VectorXd& values, double largest, const Palette& palette);

}  // namespace tiprub
