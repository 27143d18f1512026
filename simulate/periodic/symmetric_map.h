// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <cstdint>
#include <utility>
#include <vector>

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

  /// [m/s sqrt(kg)] the modes at t_q and t_{q-1} as a vector whose square is twice the energy: frequencies times
  /// positions (not below the speed of rotation), then velocities; of a standing wave the real parts only.
  Eigen::VectorXd state() const;
  void put(const Eigen::VectorXd& state);
  /// The state as the next sector has it: what the map gives when the march has done its steps.
  Eigen::VectorXd image() const;

  /// Of the march.
  int steps() const { return steps_; }
  double maps_per_revolution() const { return static_cast<double>(march_.steps_per_revolution()) / steps_; }

 private:
  struct WaveFrame {
    Eigen::Index moving;
    int parts;             ///< real, and of a travelling wave imaginary
    Eigen::ArrayXd scale;  ///< [rad/s]
    std::complex<double> phase;
  };
  enum class Shift { none, sectors };
  Eigen::VectorXd state_shifted(Shift shift) const;

  TimeMarch& march_;
  int steps_;
  std::vector<WaveFrame> frames_;
};

/// All that the next step of a march needs, to the bit; for laws of contact without memory.
class MarchState {
 public:
  explicit MarchState(const TimeMarch& march);
  void restore(TimeMarch& march) const;

 private:
  std::vector<std::pair<Eigen::VectorXcd, Eigen::VectorXcd>> waves_;
  std::int64_t step_;
};

}  // namespace tiprub
