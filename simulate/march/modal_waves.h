// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

#include "simulate/march/cache_lines.h"
#include "simulate/march/rotor_at_speed.h"
#include "simulate/march/step_coefficients.h"

namespace tiprub {

/// What one nodal diameter is marched with. Arrays over its modes: those of the rotor first, then some that never
/// move (a = b = c = 0), so that loops run over whole vectors.
struct MarchedWave {
  int nodal_diameter = 0;
  WaveKind kind = WaveKind::travelling;
  double weight = 0;        ///< w_n
  Eigen::Index moving = 0;  ///< modes with mass come first; so many, in whole vectors
  Eigen::ArrayXd omega;     ///< [rad/s]
  StepCoefficients coefficients;

  Eigen::Index modes() const { return omega.size(); }
};

/// The instants that a march holds: t_q, t_{q-1}, t_{q-2}.
enum class Instant { now, before, two_before };

/// [m sqrt(kg)] q of one nodal diameter at an instant, over MarchedWave::modes(). Valid until the march goes on.
struct ModalCoordinates {
  Eigen::Map<const Eigen::ArrayXd> real, imaginary;

  /// The first `count` modes.
  Eigen::VectorXcd head(Eigen::Index count) const;
};

/// The modes of all nodal diameters of a march, in the memory order of wave_kernels.h, which nobody else knows: real
/// and imaginary parts apart, padded to whole vectors, and with forces that wait for the next free step, because it
/// needs the same rows of Y.
class ModalWaves {
 public:
  /// The contact nodes as the march stands them in a vector: sector after sector, each padded to `width` nodes.
  struct Nodes {
    int sector_count, sectors, symmetry, nodes;  ///< N, N/g, g, n_c
    std::size_t width;
  };
  ModalWaves(const RotorAtSpeed& rotor, const SchemeOptions& scheme, double time_step, const Nodes& nodes);

  std::size_t size() const { return waves_.size(); }
  const MarchedWave& operator[](std::size_t wave) const { return waves_[wave]; }
  ModalCoordinates coordinates(std::size_t wave, Instant instant) const;
  /// [N] Lambda_n = (w_n g / N) sum_j lambda_j e^{-i n j alpha} of the last forces; n_c.
  Eigen::VectorXcd forces(std::size_t wave) const;
  /// [m/N] W = sum over n of Re(Y c Y^H e^{i n (j - j') alpha}) w_n g / N; padded rows zero.
  Eigen::MatrixXd compliance(const RotorAtSpeed& rotor) const;

  void set_state(std::size_t wave, const Eigen::VectorXcd& q, const Eigen::VectorXcd& before);
  /// The free step, q+ = a q - b q-, and the normal displacements [m] after it.
  void advance(Eigen::VectorXd& displacement);
  /// The normal displacements [m] of the modes as they are.
  void map_to_sectors(Eigen::VectorXd& displacement);
  /// q+ -= c Y^H Lambda_n of the forces [N] along -normal on the nodes listed, ascending.
  void add_forces(const Eigen::VectorXd& forces, const std::vector<int>& nodes);

 private:
  /// Of one nodal diameter.
  struct Memory {
    Eigen::VectorXd q, before, two_before;  ///< real parts, then imaginary parts, at t_q, t_{q-1}, t_{q-2}
    kernels::Lines shapes;                  ///< Y in the order of wave_kernels.h
    Eigen::VectorXd forces;                 ///< Lambda_n, real parts, then imaginary parts
    Eigen::VectorXd cosine, sine;           ///< of n j alpha, by sector
  };
  Memory lay_out(const WaveModes& from, const MarchedWave& wave) const;
  void advance_modes(std::size_t wave);
  /// p_ from a wave's modes.
  void map_to_nodes(std::size_t wave);
  void add_sectors(Eigen::VectorXd& displacement) const;
  void settle_forces() const;
  void add_waiting_forces(std::size_t wave) const;

  Nodes nodes_;
  std::vector<MarchedWave> waves_;
  mutable std::vector<Memory> memory_;
  mutable bool forces_wait_ = false;       ///< the last forces are not in the modes yet
  Eigen::VectorXd p_;                      ///< Y q, for each wave real parts, then imaginary parts
  std::vector<double> phases_of_sectors_;  ///< for each sector, of each wave the cosine, then the sine of n j alpha
  std::vector<int> forced_nodes_, forced_sectors_;  ///< that have a force in any sector, at any node
  std::vector<char> node_has_force_;
};

}  // namespace tiprub
