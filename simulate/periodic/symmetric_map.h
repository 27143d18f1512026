// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <vector>

#include "simulate/march/march_state.h"
#include "simulate/march/time_march.h"

namespace tiprub {

/// The march over 1/lcm(N, lobes) of a revolution, then a shift of sectors: an orbit that travels with the casing,
///   u_j(t + T/lcm(N, lobes)) = u_{j+s}(t),
/// is a fixed point, found lcm(N, lobes) times as often a revolution as by the whole one; an orbit that does so after
/// k of these times, of its k-th power. The shift is a phase, e^{-i n s alpha}, for nodal diameter n. Steps a
/// revolution are a multiple of lcm(N, lobes); the casing must have grown to its full height. For laws of contact
/// without memory, whose state is that of the modes at two instants.
class SymmetricMap {
 public:
  explicit SymmetricMap(TimeMarch& march, int power = 1);

  /// The modes as EnergyState has them, of a standing wave the real parts only.
  Eigen::VectorXd state() const { return energy_state_.of(march_); }
  void put(const Eigen::VectorXd& state) { energy_state_.put(state, march_); }
  /// The state as the next sector has it: what the map gives when the march has done its steps.
  Eigen::VectorXd image() const { return energy_state_.of(march_, phases_); }

  const StateLayout& layout() const { return energy_state_.layout(); }
  /// Of the march.
  int steps() const { return steps_; }
  double maps_per_revolution() const { return static_cast<double>(march_.steps_per_revolution()) / steps_; }

 private:
  TimeMarch& march_;
  int steps_;
  EnergyState energy_state_;
  std::vector<std::complex<double>> phases_;  ///< of a shift of sectors, by wave
};

}  // namespace tiprub
