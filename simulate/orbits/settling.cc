// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/settling.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <utility>

#include "cases/program/text.h"
#include "simulate/motion/attempt.h"
#include "simulate/orbits/recording.h"

namespace tiprub::simulate {

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

/// A line through the logarithms of the last `count` changes.
EvenLine trend(const std::vector<double>& changes, int count) {
  std::vector<double> logarithms;
  const auto fitted = std::min<std::ptrdiff_t>(count, std::ssize(changes));
  for (auto change = changes.end() - fitted; change != changes.end(); ++change)
    logarithms.push_back(std::log(std::max(*change, rounding_floor)));
  return fit_even_line(logarithms);
}

bool falls(const EvenLine& line) {
  return line.slope + 2 * line.uncertainty < 0;
}

constexpr double quiet_motion = 1e-3;      // of the casing's amplitude: a smaller motion counts as rest
constexpr double boundless_motion = 1e6;   // times amplitude and clearance: a larger motion has diverged
constexpr int patience = 4, standing = 2;  // times min_revolutions: marched before wanders(), and judged by it
constexpr int fewest_revolutions = 15;     // in place of min_revolutions there, so that the slope has a meaning
constexpr std::size_t remembered = 24;     // revolutions, for the class of a motion that does not settle

SteadyState make_judge(const Scene& scene, const TimeMarch& march) {
  const double size =
      std::sqrt(static_cast<double>(march.sectors()) * march.node_count() * scene.scope.samples_per_revolution);
  return {scene.parameters.settle_tolerance, quiet_motion * scene.casing.amplitude * size};
}

/// At least the order of the casing's lobes: a band without it would hold nothing of the period of a forced motion.
double highest_resolved_order(const Scene& scene, const TimeMarch& march) {
  const double turns_per_second = 1 / (march.time_step() * march.steps_per_revolution());
  return std::max(scene.parameters.resolved_frequency / turns_per_second, static_cast<double>(scene.casing.lobes));
}

}  // namespace

void SteadyState::add(Eigen::VectorXd revolution) {
  const double norm = std::max(revolution.norm(), quiet_norm_);
  for (std::size_t lag = 1; lag <= std::min<std::size_t>(last_.size(), longest_period); ++lag)
    changes_[lag - 1].push_back(norm > 0 ? (revolution - last_[lag - 1]).norm() / norm : 0.0);
  last_.push_front(std::move(revolution));
  if (last_.size() > longest_period) last_.pop_back();
}

SettlingState SteadyState::judge() const {
  SettlingState state;
  for (int period = 1; period <= longest_period; ++period) {
    const std::vector<double>& changes = changes_[period - 1];
    if (changes.empty()) break;
    const double change = changes.back();
    const double rate = std::exp(trend(changes, window).slope);
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
    return {period, change, rate};
  }
  return state;
}

bool SteadyState::decays() const {
  if (changes_.front().size() < window) return false;
  return falls(trend(changes_.front(), decay_window));
}

bool SteadyState::stands(int count) const {
  if (changes_.front().size() < window) return false;
  const EvenLine line = trend(changes_.front(), count);
  return !falls(line) && line.slope <= std::max(2 * line.uncertainty, std::numbers::ln2 / count);
}

Settling::Settling(const Scene& scene, TimeMarch& march, int min_revolutions, StartMotion start)
    : scene_(scene),
      march_(march),
      band_(scene.scope.samples_per_revolution, highest_resolved_order(scene, march)),
      state_(make_judge(scene, march)),
      bound_(boundless_motion * length_scale(scene)),
      min_revolutions_(min_revolutions),
      start_(start) {}

void Settling::add(Eigen::VectorXd motion) {
  ++revolutions_;
  if (!(motion.cwiseAbs().maxCoeff() <= bound_)) {
    throw NoMotion(text_of("the motion grew beyond ", bound_, " m in revolution ", revolutions_,
                           "; take smaller steps, or look at the model"));
  }
  const Eigen::MatrixXd coefficients = band_.coefficients(motion);
  state_.add(coefficients.reshaped());
  last_.push_back(std::move(motion));
  if (last_.size() > remembered) last_.pop_front();
}

MotionReading Settling::reading() const {
  const SettlingState state = this->state();
  std::deque<Eigen::VectorXd> revolutions = last_;
  Change change = state_.decays() ? Change::decays : Change::stands;
  if (state.settled()) {
    change = Change::settled;
    while (static_cast<int>(revolutions.size()) > state.period_revolutions) revolutions.pop_front();
  }
  const bool jitters = traits_of(scene_.parameters.scheme).jitters;
  return read_motion(revolutions, march_.displacement().size(), band_.orders(), scene_.casing.lobes, change,
                     jitters ? ClassLimits::off_jitter : ClassLimits::off_lines);
}

bool Settling::settled() const {
  return orbit_ || (revolutions_ >= min_revolutions_ && casing_has_grown() && state_.judge().settled());
}

bool Settling::casing_has_grown() const {
  constexpr int turns = 2;  // with the whole distortion, so that each tip has met each crest and answered
  return march_.step_count() >= (scene_.casing.grown_after() + turns) * march_.steps_per_revolution();
}

bool Settling::wanders() const {
  const int unit = std::max(min_revolutions_, fewest_revolutions);
  const int marched = unit * (start_ == StartMotion::wanders ? standing : patience);
  return !settled() && revolutions_ >= marched && casing_has_grown() && state_.stands(standing * unit);
}

void Settling::advance() {
  add(march_revolution(march_, scene_.scope.samples_per_revolution));
}

void Settling::stand_on_orbit(int period_revolutions, double rate) {
  orbit_ = {period_revolutions, 0, rate};
  last_.clear();
}

void Settling::confirm_orbit(double drift) {
  orbit_->change = drift;
}

void Settling::leave_orbit() {
  orbit_.reset();
  state_ = make_judge(scene_, march_);
  last_.clear();
}

}  // namespace tiprub::simulate
