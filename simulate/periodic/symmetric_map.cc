// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/periodic/symmetric_map.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "simulate/scene/scene_scope.h"

namespace tiprub {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

}  // namespace

SymmetricMap::SymmetricMap(TimeMarch& march, int power) : march_(march) {
  const int lobes = march.scene().obstacle.lobes();
  steps_ = power * (march.steps_per_revolution() / std::lcm(march.sector_count(), lobes));
  const double lowest = two_pi / march.steps_per_revolution() / march.time_step();
  const std::int64_t shift = power * sector_shift(march.sector_count(), lobes);
  for (std::size_t i = 0; i < march.wave_count(); ++i) {
    const MarchedWave& wave = march.wave(i);
    const auto turn = wave.nodal_diameter * shift % march.sector_count();
    frames_.push_back({wave.moving, wave.kind == WaveKind::travelling ? 2 : 1,
                       wave.omega.head(wave.moving).max(lowest),
                       std::polar(1.0, -two_pi * static_cast<double>(turn) / march.sector_count())});
  }
}

Eigen::VectorXd SymmetricMap::state_shifted(Shift shift) const {
  Eigen::Index size = 0;
  for (const WaveFrame& frame : frames_) size += 2 * frame.parts * frame.moving;
  Eigen::VectorXd state(size);
  Eigen::Index offset = 0;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const Eigen::Index count = frames_[i].moving;
    const std::complex<double> phase = shift == Shift::sectors ? frames_[i].phase : 1.0;
    const Eigen::VectorXcd now = march_.coordinates(i).head(count) * phase;
    const Eigen::VectorXcd before = march_.coordinates(i, Instant::before).head(count) * phase;
    const Eigen::VectorXcd velocity = (now - before) / march_.time_step();
    const Eigen::VectorXcd position = (now.array() * frames_[i].scale).matrix();
    for (const Eigen::VectorXcd* values : {&position, &velocity}) {
      state.segment(offset, count) = values->real();
      if (frames_[i].parts == 2) state.segment(offset + count, count) = values->imag();
      offset += frames_[i].parts * count;
    }
  }
  return state;
}

Eigen::VectorXd SymmetricMap::state() const {
  return state_shifted(Shift::none);
}

Eigen::VectorXd SymmetricMap::image() const {
  return state_shifted(Shift::sectors);
}

void SymmetricMap::put(const Eigen::VectorXd& state) {
  Eigen::Index offset = 0;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const WaveFrame& frame = frames_[i];
    const Eigen::Index count = frame.moving;
    const auto part = [&](Eigen::Index which) { return state.segment(offset + which * count, count); };
    Eigen::VectorXcd now = Eigen::VectorXcd::Zero(count), velocity = now;
    now.real() = (part(0).array() / frame.scale).matrix();
    velocity.real() = part(frame.parts);
    if (frame.parts == 2) {
      now.imag() = (part(1).array() / frame.scale).matrix();
      velocity.imag() = part(3);
    }
    march_.set_state(i, now, now - velocity * march_.time_step());
    offset += 2 * frame.parts * count;
  }
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
