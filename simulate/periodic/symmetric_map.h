// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <vector>

#include "simulate/march/march_state.h"
#include "simulate/march/time_march.h"

namespace tiprub {

/// The march over 1/lcm(N, lobes) of a revolution, followed by a shift of sectors. Its fixed points are the orbits
/// that travel with the casing,
///   u_j(t + T/lcm(N, lobes)) = u_{j+s}(t).
/// Orbits that do so after k such intervals are fixed points of its k-th power. The map costs lcm(N, lobes) times
/// less than a revolution. For nodal diameter n the shift is the phase e^{-i n s alpha}. The number of steps in a
/// revolution must be a multiple of lcm(N, lobes), and the casing must be fully grown. Only for contact laws without
/// memory, for which the modes at two instants are the whole state.
class SymmetricMap {
 public:
  explicit SymmetricMap(TimeMarch& march, int power = 1);

  /// The modes as in EnergyState; of a standing wave only the real parts.
  Eigen::VectorXd state() const { return energy_state_.of(march_); }
  void put(const Eigen::VectorXd& state) { energy_state_.put(state, march_); }
  /// The state after the shift of sectors: the image of the map once the march has done its steps.
  Eigen::VectorXd image() const { return energy_state_.of(march_, phases_); }

  const StateLayout& layout() const { return energy_state_.layout(); }
  /// Steps of the march in one map.
  int steps() const { return steps_; }
  double maps_per_revolution() const { return static_cast<double>(march_.steps_per_revolution()) / steps_; }

 private:
  TimeMarch& march_;
  int steps_;
  EnergyState energy_state_;
  std::vector<std::complex<double>> phases_;  ///< of the shift of sectors, by wave
};

}  // namespace tiprub
