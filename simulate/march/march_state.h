// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "reduce/model/reduced_model.h"
#include "simulate/march/time_march.h"
#include "simulate/motion/rotor_state.h"

namespace tiprub {

/// What a march is at. Backward difference over the last step: a start for the next settling, no restart.
RotorState state_of(const TimeMarch& march, const ReducedModel& model);

/// Puts a state into a march; the modes that it doesn't keep lose their part.
void put_state(const RotorState& state, const ReducedModel& model, TimeMarch& march);

/// All that the next step of a march needs, to the bit; for laws of contact without memory.
class MarchState {
 public:
  explicit MarchState(const TimeMarch& march);
  void restore(TimeMarch& march) const;

 private:
  std::vector<std::pair<Eigen::VectorXcd, Eigen::VectorXcd>> waves_;
  std::int64_t step_;
};

/// How the modes of some waves stand in a vector of real numbers: wave after wave, positions before velocities, of
/// each the real parts before the imaginary ones.
class StateLayout {
 public:
  struct Wave {
    Eigen::Index modes;
    int parts;  ///< 1: real parts alone
  };
  struct Modes {
    Eigen::VectorXcd position, velocity;
  };
  explicit StateLayout(std::vector<Wave> waves);

  Eigen::Index size() const { return size_; }
  /// Those of one wave.
  Modes read(const Eigen::VectorXd& state, std::size_t wave) const;
  void write(const Modes& modes, std::size_t wave, Eigen::VectorXd& state) const;

 private:
  std::vector<Wave> waves_;
  std::vector<Eigen::Index> first_;
  Eigen::Index size_ = 0;
};

/// The modes with mass of a march, from one of its waves on, at t_q and t_{q-1} as a vector whose square is twice
/// their energy: frequencies (not below the speed of rotation) times positions, then velocities [m/s sqrt(kg)].
class EnergyState {
 public:
  enum class StandingWaves {
    real,     ///< without the imaginary parts, which are zero
    complex,  ///< as all others
  };
  EnergyState(const TimeMarch& march, std::size_t first_wave, StandingWaves standing);

  const StateLayout& layout() const { return layout_; }
  /// `phases`: what the modes of each wave are multiplied with; empty: 1.
  Eigen::VectorXd of(const TimeMarch& march, const std::vector<std::complex<double>>& phases = {}) const;
  void put(const Eigen::VectorXd& state, TimeMarch& march) const;

 private:
  std::size_t first_wave_;
  std::vector<Eigen::ArrayXd> scale_;  ///< [rad/s] of the positions, by wave
  StateLayout layout_;
};

}  // namespace tiprub
