// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/periodic_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tiprub {

namespace {

/// The weighted harmonic mean of the secants on both sides; zero where they differ in sign (Fritsch and Butland
/// 1984).
double limited_slope(double width_before, double secant_before, double width_after, double secant_after) {
  if (secant_before * secant_after <= 0) return 0.0;
  const double weight_before = 2 * width_after + width_before;
  const double weight_after = width_after + 2 * width_before;
  return (weight_before + weight_after) / (weight_before / secant_before + weight_after / secant_after);
}

}  // namespace

PeriodicTable::PeriodicTable(std::vector<std::array<double, 2>> points, double period)
    : points_(std::move(points)), slopes_(points_.size(), 0.0), period_(period) {
  const std::size_t count = points_.size();
  const auto secant = [&](std::size_t piece) {
    return (points_[(piece + 1) % count][1] - points_[piece][1]) / width(piece);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count;
    slopes_[i] = limited_slope(width(before), secant(before), width(i), secant(i));
  }
}

double PeriodicTable::width(std::size_t piece) const {
  return piece + 1 < points_.size() ? points_[piece + 1][0] - points_[piece][0]
                                    : points_.front()[0] + period_ - points_[piece][0];
}

double PeriodicTable::operator()(double x) const {
  const double start = points_.front()[0];
  double wrapped = x - period_ * std::floor((x - start) / period_);
  if (wrapped >= start + period_) wrapped = start;  // rounding just below a whole period
  const auto after = std::upper_bound(points_.begin(), points_.end(), wrapped,
                                      [](double value, const auto& point) { return value < point[0]; });
  const std::size_t piece = after == points_.begin() ? 0 : static_cast<std::size_t>(after - points_.begin()) - 1;
  const std::size_t next = (piece + 1) % points_.size();
  const double length = width(piece);
  const double t = (wrapped - points_[piece][0]) / length;
  // cubic Hermite polynomial
  return (1 + 2 * t) * (1 - t) * (1 - t) * points_[piece][1] + t * (1 - t) * (1 - t) * length * slopes_[piece] +
         t * t * (3 - 2 * t) * points_[next][1] - t * t * (1 - t) * length * slopes_[next];
}

}  // namespace tiprub
