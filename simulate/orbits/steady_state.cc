// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/steady_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tiprub {

namespace {

constexpr int window = 8;                 // changes that the rate is fitted to
constexpr int decay_window = 24;          // changes by which decays() judges
constexpr double recent_margin = 10;      // tolerances: bound of the changes in the last `longest_period` revolutions
constexpr double standing_rate = 0.98;    // delta_1 that falls faster tends to zero: the motion is not subharmonic
constexpr double rounding_floor = 1e-10;  // of the norm: smaller changes are rounding and have no rate

/// A line through evenly spaced values.
struct EvenLine {
  double slope = 0;        ///< per interval; 0 for fewer than two values
  double uncertainty = 0;  ///< standard error of the slope; 0 for fewer than three
};

/// Least squares with two sums, because the mean of the places is known. Boost's simple_ordinary_least_squares would
/// need the places in a container and updates running means, which costs digits.
EvenLine fit_even_line(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  const double middle = (count - 1) / 2;
  double moment = 0, spread = 0, mean = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double offset = static_cast<double>(i) - middle;
    moment += offset * values[i];
    spread += offset * offset;
    mean += values[i] / count;
  }
  if (spread == 0) return {};
  EvenLine line{moment / spread, 0};
  if (count < 3) return line;
  double residual = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double offset = static_cast<double>(i) - middle;
    residual += std::pow(values[i] - mean - line.slope * offset, 2);
  }
  line.uncertainty = std::sqrt(residual / (count - 2) / spread);
  return line;
}

}  // namespace

void SteadyState::add(Eigen::VectorXd revolution) {
  const double norm = std::max(revolution.norm(), quiet_norm_);
  for (std::size_t lag = 1; lag <= std::min<std::size_t>(last_.size(), longest_period); ++lag)
    changes_[lag - 1].push_back(norm > 0 ? (revolution - last_[lag - 1]).norm() / norm : 0.0);
  last_.push_front(std::move(revolution));
  if (last_.size() > longest_period) last_.pop_back();
}

/// exp of the slope of a line through the logarithms of the last changes (least squares).
double SteadyState::decay_rate(const std::vector<double>& changes) const {
  const std::size_t count = std::min<std::size_t>(changes.size(), window);
  std::vector<double> logarithms;
  for (std::size_t i = changes.size() - count; i < changes.size(); ++i)
    logarithms.push_back(std::log(std::max(changes[i], rounding_floor)));
  return std::exp(fit_even_line(logarithms).slope);
}

SettlingState SteadyState::judge() const {
  SettlingState state;
  for (int period = 1; period <= longest_period; ++period) {
    const std::vector<double>& changes = changes_[period - 1];
    if (changes.empty()) break;
    const double change = changes.back();
    const double rate = decay_rate(changes);
    if (period == 1) {
      state.change = change;
      state.rate = rate;
    }
    if (static_cast<int>(changes.size()) < window || change > tolerance_) continue;
    if (*std::max_element(changes.end() - longest_period, changes.end()) > recent_margin * tolerance_) continue;
    if (period > 1 && state.rate < standing_rate) continue;
    const double over_period = std::pow(rate, period);
    const double still_to_come = rate < 1 ? change * over_period / (1 - over_period) : HUGE_VAL;
    if (change > rounding_floor && still_to_come > tolerance_) continue;
    return {SettlingState::Settled::yes, period, change, rate};
  }
  return state;
}

bool SteadyState::decays() const {
  const std::vector<double>& changes = changes_.front();
  if (changes.size() < window) return false;
  const std::size_t count = std::min<std::size_t>(changes.size(), decay_window);
  std::vector<double> logarithms;
  for (std::size_t i = changes.size() - count; i < changes.size(); ++i)
    logarithms.push_back(std::log(std::max(changes[i], rounding_floor)));
  const EvenLine line = fit_even_line(logarithms);
  return line.slope + 2 * line.uncertainty < 0;
}

}  // namespace tiprub
