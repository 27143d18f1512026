// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/march_state.h"

#include <numbers>

namespace tiprub::simulate {

namespace {

double angle_of_step(const TimeMarch& march) {
  return 2 * std::numbers::pi / march.steps_per_revolution();
}

std::vector<StateLayout::Wave> waves_with_mass(const TimeMarch& march, std::size_t first_wave) {
  std::vector<StateLayout::Wave> waves;
  for (std::size_t i = first_wave; i < march.wave_count(); ++i)
    waves.push_back({march.wave(i).moving, march.wave(i).kind == WaveKind::standing ? 1 : 2});
  return waves;
}

}  // namespace

RotorState state_of(const TimeMarch& march, const ReducedModel& model) {
  RotorState state;
  state.displacement.resize(model.nodal_diameters.size());
  state.velocity.resize(model.nodal_diameters.size());
  for (std::size_t i = 0; i < march.wave_count(); ++i) {
    const Eigen::MatrixXcd& shapes = march.rotor().waves[i].shapes;
    const Eigen::VectorXcd now = march.coordinates(i).head(shapes.cols());
    const Eigen::VectorXcd increment = march.increments(i).head(shapes.cols());
    const auto n = static_cast<std::size_t>(march.wave(i).nodal_diameter);
    state.displacement[n] = shapes * now;
    state.velocity[n] = shapes * increment / angle_of_step(march);
  }
  return state;
}

void put_state(const RotorState& state, const ReducedModel& model, TimeMarch& march) {
  for (std::size_t i = 0; i < march.wave_count(); ++i) {
    const WaveModes& wave = march.rotor().waves[i];
    const auto n = static_cast<std::size_t>(wave.nodal_diameter);
    if (n >= state.displacement.size() || state.displacement[n].size() == 0) continue;
    const Eigen::MatrixXcd onto_modes = wave.shapes.adjoint() * model.nodal_diameters[n].M;
    const Eigen::VectorXcd now = onto_modes * state.displacement[n];
    march.set_state(i, now, onto_modes * state.velocity[n] * angle_of_step(march));
  }
}

MarchState::MarchState(const TimeMarch& march)
    : step_(march.step_count()), gap_before_(march.gaps().now), gap_(march.gap()) {
  for (std::size_t i = 0; i < march.wave_count(); ++i) {
    const Eigen::Index modes = march.wave(i).modes();
    waves_.push_back({march.coordinates(i).head(modes), march.increments(i).head(modes)});
  }
}

void MarchState::restore(TimeMarch& march) const {
  march.set_states(waves_);
  march.set_step(step_);
  march.set_gaps(gap_before_, gap_);
}

StateLayout::StateLayout(std::vector<Wave> waves) : waves_(std::move(waves)) {
  for (const Wave& wave : waves_) {
    first_.push_back(size_);
    size_ += 2 * wave.parts * wave.modes;
  }
}

StateLayout::Modes StateLayout::read(const Eigen::VectorXd& state, std::size_t wave) const {
  const auto [modes, parts] = waves_[wave];
  const auto values = [&, count = modes](Eigen::Index place) {
    return state.segment(first_[wave] + place * count, count);
  };
  Modes read{Eigen::VectorXcd::Zero(modes), Eigen::VectorXcd::Zero(modes)};
  read.position.real() = values(0);
  read.velocity.real() = values(parts);
  if (parts == 1) return read;
  read.position.imag() = values(1);
  read.velocity.imag() = values(3);
  return read;
}

void StateLayout::write(const Modes& modes, std::size_t wave, Eigen::VectorXd& state) const {
  Eigen::Index place = first_[wave];
  for (const Eigen::VectorXcd* values : {&modes.position, &modes.velocity}) {
    const Eigen::Index count = waves_[wave].modes;
    state.segment(place, count) = values->real();
    if (waves_[wave].parts == 2) state.segment(place + count, count) = values->imag();
    place += waves_[wave].parts * count;
  }
}

EnergyState::EnergyState(const TimeMarch& march, std::size_t first_wave)
    : first_wave_(first_wave), layout_(waves_with_mass(march, first_wave)) {
  for (std::size_t i = first_wave; i < march.wave_count(); ++i)
    scale_.emplace_back(march.wave(i).omega.head(march.wave(i).moving).max(march.rotor().speed));
}

Eigen::VectorXd EnergyState::of(const TimeMarch& march, const std::vector<std::complex<double>>& phases) const {
  Eigen::VectorXd state(layout_.size());
  for (std::size_t i = 0; i < scale_.size(); ++i) {
    const Eigen::Index count = scale_[i].size();
    Eigen::VectorXcd now = march.coordinates(first_wave_ + i).head(count);
    Eigen::VectorXcd increment = march.increments(first_wave_ + i).head(count);
    if (!phases.empty()) {
      now *= phases[i];
      increment *= phases[i];
    }
    layout_.write({(now.array() * scale_[i]).matrix(), increment / march.time_step()}, i, state);
  }
  return state;
}

void EnergyState::put(const Eigen::VectorXd& state, TimeMarch& march) const {
  std::vector<ModalState> waves;
  for (std::size_t i = 0; i < scale_.size(); ++i) {
    const StateLayout::Modes modes = layout_.read(state, i);
    Eigen::VectorXcd now = modes.position;
    now.real().array() /= scale_[i];
    now.imag().array() /= scale_[i];
    waves.push_back({now, modes.velocity * march.time_step()});
  }
  march.set_states(waves, first_wave_);
}

}  // namespace tiprub::simulate
