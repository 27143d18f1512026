// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/figures/drawing.h"

namespace tiprub {

/// What drawings over speed share: the axis, and what stands behind the curves.
struct SpeedFrame {
  DrawnRange axis;                 ///< [rpm] the simulated range and half a step on both sides
  Eigen::VectorXd speeds, failed;  ///< [rpm] with and without a response
  SpeedRange range;                ///< [rad/s]
  FrequencyCurves curves;
  int sector_count, lobes;
  int families;  ///< that are drawn: as many as asked for, and those that the critical speeds' table names
  int engine_order_max;
  std::vector<CriticalSpeed> critical;

  int nodal_diameters() const { return sector_count / 2 + 1; }
  /// Of the drawn families, those that there are at a nodal diameter.
  int families_at(int nodal_diameter) const;
};
SpeedFrame speed_frame(const Study& study);

/// " of the main blade" where contact is on splitters too, for captions that name an edge; else empty.
std::string of_main_blade(const ContactLine& contact);

/// [rpm]
Eigen::VectorXd rpm_of(const std::vector<SpeedResponse>& speeds);

/// For each of `columns` pixel columns over the axis the index of the nearest speed, or -1 where a failed one is
/// nearer, or where it lies beyond the ends of the speeds by more than half a step. Speeds need not be even; all in
/// rpm.
Eigen::VectorXi nearest_speeds(const Eigen::VectorXd& speeds, const Eigen::VectorXd& failed, const DrawnRange& axis,
                               int columns);

/// Those of the linear rules' crossings that are on drawn families and engine orders.
std::vector<Crossing> drawn_crossings(const SpeedFrame& frame, const std::vector<Crossing>& crossings);

/// speed_low, speed_high.
void set_speed_axis(Drawing& drawing, const DrawnRange& axis);

/// engine_order_step, engine_order_last: all engine orders are drawn if they are few, else multiples of the lobes.
void set_engine_orders(Drawing& drawing, const SpeedFrame& frame);

/// Speed [rpm], frequency [Hz] of the waves that make the critical speeds, as the table `critical`; those that lie
/// above the drawing are drawn at its upper edge.
void set_critical_speeds(Drawing& drawing, const SpeedFrame& frame, double frequency_high);

/// nodal_diameters, families and the table `modes` over an axis of speeds: speed [rpm], then the families of nodal
/// diameter 0 [Hz], those of 1, ..; NaN for a family that there isn't.
void set_modes(Drawing& drawing, const SpeedFrame& frame, const DrawnRange& axis);

}  // namespace tiprub
