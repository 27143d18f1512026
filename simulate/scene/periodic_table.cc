// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/periodic_table.h"

#include <math.h>  // isnan, which Boost 1.74's pchip takes from the global scope

#include <boost/math/interpolators/pchip.hpp>
#include <cmath>
#include <utility>

namespace tiprub {

/// Slopes depend on the neighbours at both sides, so that one point of the period before and two of the period after
/// are added. This also gives pchip the four points that it needs if there is only one.
PeriodicTable::PeriodicTable(const std::vector<std::array<double, 2>>& points, double period)
    : start_(points.front()[0]), period_(period) {
  std::vector<double> xs, ys;
  const auto add = [&](const std::array<double, 2>& point, int periods) {
    xs.push_back(point[0] + periods * period);
    ys.push_back(point[1]);
  };
  add(points.back(), -1);
  for (const std::array<double, 2>& point : points) add(point, 0);
  add(points.front(), 1);
  add(points.size() > 1 ? points[1] : points.front(), points.size() > 1 ? 1 : 2);
  cubic_ = boost::math::interpolators::pchip<std::vector<double>>(std::move(xs), std::move(ys));
}

double PeriodicTable::operator()(double x) const {
  const double wrapped = x - period_ * std::floor((x - start_) / period_);
  return cubic_(wrapped >= start_ + period_ ? start_ : wrapped);  // rounding just below a whole period
}

}  // namespace tiprub
