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

/// " of the main blade" where contact is on splitters too, for captions that name an edge; else empty.
std::string of_main_blade(const Study& study);

/// [rpm] of all speeds with a response.
Eigen::VectorXd speeds_rpm(const Study& study);
/// [rpm] of others.
Eigen::VectorXd rpm_of(const std::vector<SpeedResponse>& speeds);

/// For each of `columns` pixel columns over the axis the index of the nearest speed, or -1 where a failed one is
/// nearer, or where it lies beyond the ends of the speeds by more than half a step. Speeds need not be even; all in
/// rpm.
Eigen::VectorXi nearest_speeds(const Eigen::VectorXd& speeds, const Eigen::VectorXd& failed, const SpeedAxis& axis,
                               int columns);
/// Of a study, over its own axis.
Eigen::VectorXi nearest_speeds(const Study& study, int columns);

/// Families that are drawn: as many as asked for, and those that the critical speeds' table names.
int drawn_families(const Study& study);

/// Of these, those that there are at a nodal diameter.
int drawn_families(const Study& study, int nodal_diameter);

/// Those of the linear rules' crossings that are on drawn families and engine orders.
std::vector<Crossing> drawn_crossings(const Study& study, const std::vector<Crossing>& crossings);

/// speed_low, speed_high.
void set_speed_axis(Drawing& drawing, const SpeedAxis& axis);

/// engine_order_step, engine_order_last: all engine orders are drawn if they are few, else multiples of the lobes.
void set_engine_orders(Drawing& drawing, const Study& study);

/// Speed [rpm], frequency [Hz] of the waves that make the critical speeds, as the table `critical`; those that lie
/// above the drawing are drawn at its upper edge.
void set_critical_speeds(Drawing& drawing, const Study& study, double frequency_high);

/// nodal_diameters, families and the table `modes` over an axis of speeds: speed [rpm], then the families of nodal
/// diameter 0 [Hz], those of 1, ..; NaN for a family that there isn't.
void set_modes(Drawing& drawing, const Study& study, const SpeedAxis& axis);

}  // namespace tiprub
