// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "reduce/model/reduced_model.h"
#include "simulate/march/time_march.h"
#include "simulate/motion/motion.h"

namespace tiprub::simulate {

/// The present state of a march. Velocities are increments over the last step: accurate enough to start
/// another march, but not an exact restart.
RotorState state_of(const TimeMarch& march, const ReducedModel& model);

/// Sets the state of a march. The share of modes that the march does not keep is lost.
void put_state(const RotorState& state, const ReducedModel& model, TimeMarch& march);

/// Everything that the next step of a march needs, so that restore() is exact but for rounding, which also depends on
/// the contact nodes that were closed before. Only for contact laws without memory.
class MarchState {
 public:
  explicit MarchState(const TimeMarch& march);
  void restore(TimeMarch& march) const;

 private:
  std::vector<ModalState> waves_;
  std::int64_t step_;
  Eigen::VectorXd gap_before_, gap_;
};

/// The order of the modes of some waves in a vector of real numbers: wave after wave, positions before velocities,
/// and of each the real parts before the imaginary parts.
class StateLayout {
 public:
  struct Wave {
    Eigen::Index modes;
    int parts;  ///< 1: only real parts
  };
  struct Modes {
    Eigen::VectorXcd position, velocity;
  };
  explicit StateLayout(std::vector<Wave> waves);

  Eigen::Index size() const { return size_; }
  /// The modes of one wave.
  Modes read(const Eigen::VectorXd& state, std::size_t wave) const;
  void write(const Modes& modes, std::size_t wave, Eigen::VectorXd& state) const;

 private:
  std::vector<Wave> waves_;
  std::vector<Eigen::Index> first_;
  Eigen::Index size_ = 0;
};

/// The modes with mass of the waves of a march, from `first_wave` on, as a vector whose squared norm is twice their
/// energy: positions times frequencies (at least the speed of rotation), then velocities [m/s sqrt(kg)]. Standing
/// waves have real parts only.
class EnergyState {
 public:
  explicit EnergyState(const TimeMarch& march, std::size_t first_wave = 0);

  const StateLayout& layout() const { return layout_; }
  /// The modes of each wave are multiplied by its entry of `phases`; an empty list stands for 1.
  Eigen::VectorXd of(const TimeMarch& march, const std::vector<std::complex<double>>& phases = {}) const;
  void put(const Eigen::VectorXd& state, TimeMarch& march) const;

 private:
  std::size_t first_wave_;
  std::vector<Eigen::ArrayXd> scale_;  ///< [rad/s] of the positions, by wave
  StateLayout layout_;
};

}  // namespace tiprub::simulate
