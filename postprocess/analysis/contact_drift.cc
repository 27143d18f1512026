// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/contact_drift.h"

#include <boost/math/statistics/linear_regression.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <tuple>
#include <vector>

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

/// The middle of each column's contact [rad], NaN without one; each the nearest to the one before, modulo a lobe.
Eigen::VectorXd followed_angles(const ContactMap& map, int lobes) {
  Eigen::VectorXd angles = Eigen::VectorXd::Constant(map.share.cols(), std::numeric_limits<double>::quiet_NaN());
  double previous = 0;
  for (Eigen::Index i = 0; i < angles.size(); ++i) {
    const double phase = folded_phase(map.share.col(i), lobes);
    if (std::isnan(phase)) continue;
    previous = phase + turn * std::round((previous - phase) / turn);
    angles[i] = previous / lobes;
  }
  return angles;
}

}  // namespace

ContactDrift contact_drift(const ContactMap& map, const Eigen::VectorXd& speeds, int lobes,
                           const ContactLine& contact) {
  constexpr std::size_t fewest = 3;
  ContactDrift drift;
  drift.angle = followed_angles(map, lobes);
  std::vector<double> x, y;
  for (Eigen::Index i = 0; i < speeds.size(); ++i) {
    if (std::isnan(drift.angle[i])) continue;
    x.push_back(speeds[i]);
    y.push_back(drift.angle[i]);
  }
  if (x.size() < fewest) return drift;
  std::tie(drift.intercept, drift.slope, drift.determination) =
      boost::math::statistics::simple_ordinary_least_squares_with_R_squared(x, y);
  if (drift.slope == 0) return drift;
  const Eigen::VectorXd& arc = contact.arc_length;
  drift.implied_wave_speed = (arc[arc.size() - 1] - arc[0]) / std::abs(drift.slope);
  return drift;
}

}  // namespace tiprub
