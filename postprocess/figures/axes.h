// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/figures/drawing.h"

namespace tiprub::postprocess {

/// What drawings over speed have in common.
struct SpeedFrame {
  DrawnRange axis;                 ///< [rpm] the simulated range and half a step beyond both ends
  Eigen::VectorXd speeds, failed;  ///< [rpm] with and without a response
  Eigen::VectorXd outside;         ///< [rpm] where the motion leaves what a linear gap can say
  SpeedRange range;                ///< [rad/s]
  FrequencyCurves curves;
  int sector_count, lobes;
  int families;  ///< drawn: as many as asked for, and at least all that make critical speeds
  int engine_order_max;
  std::vector<CriticalSpeed> critical;
  std::vector<int> moving;  ///< nodal diameters that can

  int nodal_diameters() const { return sector_count / 2 + 1; }
  /// How many of the drawn families a nodal diameter has.
  int families_at(int nodal_diameter) const;
};
SpeedFrame speed_frame(const Study& study);

/// " of the main blade" for captions that name an edge, where there are splitters; else empty.
std::string of_main_blade(const ContactLine& contact);

/// [rpm]
Eigen::VectorXd rpm_of(const std::vector<SpeedResponse>& speeds);

/// The index of the nearest speed for each of `columns` pixel columns over the axis. It is -1 where a failed speed is
/// nearer, and more than half a step beyond the ends. Speeds [rpm] may be spaced unevenly.
Eigen::VectorXi nearest_speeds(const Eigen::VectorXd& speeds, const Eigen::VectorXd& failed, const DrawnRange& axis,
                               int columns);

/// The crossings on drawn families and engine orders.
std::vector<Crossing> drawn_crossings(const SpeedFrame& frame, const std::vector<Crossing>& crossings);

/// Sets engine_order_step and engine_order_last: all engine orders are drawn if they are few, else multiples of the
/// lobes.
void set_engine_orders(Drawing& drawing, const SpeedFrame& frame);

/// Adds the table `critical`: speed [rpm] and frequency [Hz] of the waves that make the critical speeds. Those above
/// the drawing are drawn at its upper edge.
void set_critical_speeds(Drawing& drawing, const SpeedFrame& frame, double frequency_high);

/// Sets nodal_diameters and families, and adds the table `modes` over an axis of speeds: speed [rpm], the families of
/// nodal diameter 0 [Hz], those of 1, and so on; NaN where a nodal diameter has fewer families.
void set_modes(Drawing& drawing, const SpeedFrame& frame, const DrawnRange& axis);

}  // namespace tiprub::postprocess
