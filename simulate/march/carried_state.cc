// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/carried_state.h"

#include <numbers>

namespace tiprub {

namespace {

double angle_of_step(const TimeMarch& march) {
  return 2 * std::numbers::pi / march.steps_per_revolution();
}

}  // namespace

RotorState state_of(const TimeMarch& march, const ReducedModel& model) {
  RotorState state;
  state.displacement.resize(model.nodal_diameters.size());
  state.velocity.resize(model.nodal_diameters.size());
  for (std::size_t i = 0; i < march.rotor().waves.size(); ++i) {
    const Eigen::MatrixXcd& shapes = march.rotor().waves[i].shapes;
    const Eigen::VectorXcd now = march.coordinates(i).head(shapes.cols());
    const Eigen::VectorXcd before = march.coordinates(i, Instant::before).head(shapes.cols());
    const auto n = static_cast<std::size_t>(march.wave(i).nodal_diameter);
    state.displacement[n] = shapes * now;
    state.velocity[n] = shapes * (now - before) / angle_of_step(march);
  }
  return state;
}

void put_state(const RotorState& state, const ReducedModel& model, TimeMarch& march) {
  for (std::size_t i = 0; i < march.rotor().waves.size(); ++i) {
    const auto n = static_cast<std::size_t>(march.rotor().waves[i].nodal_diameter);
    if (n >= state.displacement.size() || state.displacement[n].size() == 0) continue;
    const Eigen::MatrixXcd onto_modes = march.rotor().waves[i].shapes.adjoint() * model.nodal_diameters[n].M;
    const Eigen::VectorXcd now = onto_modes * state.displacement[n];
    march.set_state(i, now, now - onto_modes * state.velocity[n] * angle_of_step(march));
  }
}

}  // namespace tiprub
