// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/contact_drift.h"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace tiprub {

namespace {

constexpr double turn = 2 * std::numbers::pi;

/// N_l times the middle of the contact; NaN if the column is empty or has no middle.
double folded_phase(const Eigen::VectorXd& column, int lobes) {
  constexpr double no_middle = 1e-6;  // of the column's sum
  std::complex<double> sum = 0;
  const auto areas = static_cast<double>(column.size());
  for (Eigen::Index area = 0; area < column.size(); ++area)
    sum += column[area] * std::polar(1.0, lobes * turn * (static_cast<double>(area) + 0.5) / areas);
  return std::abs(sum) > no_middle * column.sum() ? std::arg(sum) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

ContactDrift contact_drift(const ContactMap& map, const Eigen::VectorXd& speeds, int lobes,
                           const ContactLine& contact) {
  ContactDrift drift;
  drift.angle.setConstant(speeds.size(), std::numeric_limits<double>::quiet_NaN());
  double previous = 0, count = 0, mean_speed = 0, mean_angle = 0;
  for (Eigen::Index i = 0; i < speeds.size(); ++i) {
    double phase = folded_phase(map.share.col(i), lobes);
    if (std::isnan(phase)) continue;
    phase += turn * std::round((previous - phase) / turn);  // the nearest to the last one
    previous = phase;
    drift.angle[i] = phase / lobes;
    mean_speed += speeds[i];
    mean_angle += drift.angle[i];
    count += 1;
  }
  constexpr double fewest = 3;
  if (count < fewest) return drift;
  mean_speed /= count;
  mean_angle /= count;
  double speed_square = 0, angle_square = 0, product = 0;
  for (Eigen::Index i = 0; i < speeds.size(); ++i) {
    if (std::isnan(drift.angle[i])) continue;
    const double x = speeds[i] - mean_speed, y = drift.angle[i] - mean_angle;
    speed_square += x * x;
    angle_square += y * y;
    product += x * y;
  }
  drift.slope = product / speed_square;
  drift.intercept = mean_angle - drift.slope * mean_speed;
  if (angle_square > 0) drift.determination = product * product / (speed_square * angle_square);
  const Eigen::VectorXd& arc = contact.arc_length;
  if (drift.slope != 0) drift.implied_wave_speed = (arc[arc.size() - 1] - arc[0]) / std::abs(drift.slope);
  return drift;
}

}  // namespace tiprub
