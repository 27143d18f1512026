// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/symmetric_map.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "simulate/scene/scene_scope.h"

namespace tiprub {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// (1 - phase S^steps)^-1, S the free step of (q_q, q_{q-1}).
Eigen::Matrix2cd lift_of(double a, double b, int steps, std::complex<double> phase) {
  Eigen::Matrix2cd step, power = Eigen::Matrix2cd::Identity();
  step << a, -b, 1, 0;
  for (int left = steps; left > 0; left /= 2) {
    if (left % 2 == 1) power = (power * step).eval();
    step = (step * step).eval();
  }
  return (Eigen::Matrix2cd::Identity() - phase * power).inverse();
}

}  // namespace

SymmetricMap::SymmetricMap(TimeMarch& march, int lobes)
    : march_(march), maps_(std::lcm(march.sector_count(), lobes)) {
  const double lowest = two_pi / march.steps_per_revolution() / march.time_step();
  const int shift = sector_shift(march.sector_count(), lobes);
  for (std::size_t i = 0; i < march.wave_count(); ++i) {
    const MarchedWave& wave = march.wave(i);
    const auto turn = static_cast<std::int64_t>(wave.nodal_diameter) * shift % march.sector_count();
    frames_.push_back({wave.moving,
                       wave.omega.head(wave.moving).max(lowest),
                       std::polar(1.0, -two_pi * static_cast<double>(turn) / march.sector_count()),
                       {}});
    const int steps = march.steps_per_revolution() / maps_;
    for (Eigen::Index m = 0; m < wave.moving; ++m)
      frames_.back().lift.push_back(
          lift_of(wave.coefficients.a[m], wave.coefficients.b[m], steps, frames_.back().phase));
  }
}

Eigen::VectorXd SymmetricMap::state_shifted(Shift shift) const {
  Eigen::Index size = 0;
  for (const WaveFrame& frame : frames_) size += 4 * frame.moving;
  Eigen::VectorXd state(size);
  Eigen::Index offset = 0;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const Eigen::Index count = frames_[i].moving;
    const std::complex<double> phase = shift == Shift::sectors ? frames_[i].phase : 1.0;
    const Eigen::VectorXcd now = march_.coordinates(i).head(count) * phase;
    const Eigen::VectorXcd before = march_.coordinates(i, Instant::before).head(count) * phase;
    const Eigen::VectorXcd velocity = (now - before) / march_.time_step();
    const Eigen::VectorXcd position = (now.array() * frames_[i].scale).matrix();
    for (const Eigen::VectorXcd* part : {&position, &velocity}) {
      state.segment(offset, count) = part->real();
      state.segment(offset + count, count) = part->imag();
      offset += 2 * count;
    }
  }
  return state;
}

Eigen::VectorXd SymmetricMap::state() const {
  return state_shifted(Shift::none);
}

void SymmetricMap::put(const Eigen::VectorXd& state) {
  Eigen::Index offset = 0;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const Eigen::Index count = frames_[i].moving;
    Eigen::VectorXcd now(count), velocity(count);
    now.real() = (state.segment(offset, count).array() / frames_[i].scale).matrix();
    now.imag() = (state.segment(offset + count, count).array() / frames_[i].scale).matrix();
    velocity.real() = state.segment(offset + 2 * count, count);
    velocity.imag() = state.segment(offset + 3 * count, count);
    march_.set_state(i, now, now - velocity * march_.time_step());
    offset += 4 * count;
  }
}

Eigen::VectorXd SymmetricMap::operator()(const Eigen::VectorXd& state) {
  const std::int64_t start = march_.step_count();
  put(state);
  for (int i = 0; i < march_.steps_per_revolution() / maps_; ++i) march_.step();
  Eigen::VectorXd image = state_shifted(Shift::sectors);
  march_.set_step(start);
  return image;
}

Eigen::VectorXd SymmetricMap::lifted(const Eigen::VectorXd& change) const {
  Eigen::VectorXd result(change.size());
  const double h = march_.time_step();
  Eigen::Index offset = 0;
  for (const WaveFrame& frame : frames_) {
    const Eigen::Index count = frame.moving;
    for (Eigen::Index m = 0; m < count; ++m, ++offset) {
      const std::complex<double> now = std::complex(change[offset], change[offset + count]) / frame.scale[m];
      const std::complex<double> velocity(change[offset + 2 * count], change[offset + 3 * count]);
      const Eigen::Vector2cd up = frame.lift[m] * Eigen::Vector2cd(now, now - h * velocity);
      result[offset] = frame.scale[m] * up[0].real();
      result[offset + count] = frame.scale[m] * up[0].imag();
      const std::complex<double> speed = (up[0] - up[1]) / h;
      result[offset + 2 * count] = speed.real();
      result[offset + 3 * count] = speed.imag();
    }
    offset += 3 * count;
  }
  return result;
}

MarchState::MarchState(const TimeMarch& march) : step_(march.step_count()) {
  for (std::size_t i = 0; i < march.wave_count(); ++i) {
    const Eigen::Index modes = march.wave(i).modes();
    waves_.emplace_back(march.coordinates(i).head(modes), march.coordinates(i, Instant::before).head(modes));
  }
}

void MarchState::restore(TimeMarch& march) const {
  for (std::size_t i = 0; i < waves_.size(); ++i) march.set_state(i, waves_[i].first, waves_[i].second);
  march.set_step(step_);
}

}  // namespace tiprub
