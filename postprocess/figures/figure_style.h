// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <string>

#include "postprocess/analysis/study.h"

namespace tiprub::style {

/// Fonts, borders, grid: what every drawing starts with.
std::string base();

/// A perceptually even colour map (viridis) for amplitudes, dark is small.
std::string amplitude_palette();
/// White (never in contact) to dark blue (always).
std::string contact_palette();

/// Grey under a map: seen where there is no response.
std::string missing_background();

/// A colour that stands apart from its neighbours, also for colour-blind eyes (Okabe and Ito).
std::string colour(int index);

/// "set xrange [a:b]".
std::string range(const std::string& axis, double low, double high);

/// A named block of numbers inside a script; columns apart by blanks, NaN where not finite.
std::string block(const std::string& name, const Eigen::MatrixXd& rows);

/// [rpm] the drawn speeds: the simulated range and half a step on both sides.
struct SpeedAxis {
  double low = 0;
  double high = 0;
};
SpeedAxis speed_axis(const Study& study);

/// [rpm] of all speeds with a response.
Eigen::VectorXd speeds_rpm(const Study& study);

/// For each of `columns` pixel columns over the axis the index of the nearest speed, or -1 where a gap between speeds
/// (a failed one) is.
Eigen::VectorXi nearest_speeds(const Study& study, int columns);

/// Engine orders that are drawn: all if they are few, else multiples of the lobes.
std::vector<int> drawn_engine_orders(const Study& study);

/// "set label" commands for the engine orders, where their lines f = k rpm / 60 leave the drawn box.
std::string engine_order_labels(const Study& study, const SpeedAxis& axis, double frequency_max);

/// Frequencies of one nodal diameter over an axis of speeds; rows: rpm, then the first families [Hz].
Eigen::MatrixXd modal_lines(const Study& study, int nodal_diameter, const SpeedAxis& axis);

/// Families that are drawn at a nodal diameter.
int drawn_families(const Study& study, int nodal_diameter);

/// "+4", "-4", "0", with a true minus sign.
std::string signed_name(int nodal_diameter);

}  // namespace tiprub::style
