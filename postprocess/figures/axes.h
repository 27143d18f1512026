// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/figures/drawing/drawing.h"

namespace tiprub {

/// [rpm] the drawn speeds: the simulated range and half a step on both sides.
using SpeedAxis = DrawnRange;
SpeedAxis speed_axis(const Study& study);

/// [rpm] of all speeds with a response.
Eigen::VectorXd speeds_rpm(const Study& study);
/// [rpm] of others.
Eigen::VectorXd rpm_of(const std::vector<SpeedResponse>& speeds);

/// For each of `columns` pixel columns over the axis the index of the nearest speed, or -1 where a failed one is
/// nearer. Speeds need not be even.
Eigen::VectorXi nearest_speeds(const Study& study, int columns);

/// Families that are drawn at a nodal diameter.
int drawn_families(const Study& study, int nodal_diameter);

/// Those of the linear rules' crossings that are on drawn families and engine orders.
std::vector<Crossing> drawn_crossings(const Study& study, const std::vector<Crossing>& crossings);

/// speed_low, speed_high.
void set_speed_axis(Drawing& drawing, const SpeedAxis& axis);

/// engine_order_step, engine_order_last: all engine orders are drawn if they are few, else multiples of the lobes.
void set_engine_orders(Drawing& drawing, const Study& study);

/// nodal_diameters, families and the table `modes` over an axis of speeds: speed [rpm], then the families of nodal
/// diameter 0 [Hz], those of 1, ..; NaN for a family that there isn't.
void set_modes(Drawing& drawing, const Study& study, const SpeedAxis& axis);

}  // namespace tiprub
