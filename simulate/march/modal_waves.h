// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

#include "simulate/march/cache_lines.h"
#include "simulate/march/inner_impact.h"
#include "simulate/march/rotor_at_speed.h"
#include "simulate/march/step_coefficients.h"

namespace tiprub::simulate {

/// The data with which one nodal diameter is marched. The arrays hold the modes of the rotor first, then padding
/// modes that never move (r = k = 1, c = 0), so that loops run over whole vectors.
struct MarchedWave {
  int nodal_diameter = 0;
  WaveKind kind = WaveKind::travelling;
  double weight = 0;        ///< w_n: 1 for a standing wave, 2 for a travelling one
  Eigen::Index moving = 0;  ///< number of modes with mass, which come first, padded to whole vectors
  Eigen::ArrayXd omega;     ///< [rad/s]
  StepCoefficients coefficients;

  Eigen::Index modes() const { return omega.size(); }
};

/// [m sqrt(kg)] of one nodal diameter; MarchedWave::modes() values. Valid until the next step.
struct ModalCoordinates {
  Eigen::Map<const Eigen::ArrayXd> real, imaginary;

  /// The first `count` modes.
  Eigen::VectorXcd head(Eigen::Index count) const;
};

/// The modes of all nodal diameters of a march. Only this class knows their memory order, which is that of
/// wave_kernels.h: real and imaginary parts are separate and padded to whole vectors. The forces of a step are
/// applied to the modes together with the next free step, because both read the same rows of Y.
class ModalWaves {
 public:
  /// The order of contact nodes in a vector of the march: sector after sector, each padded to `width` nodes.
  struct Nodes {
    int sector_count, sectors, symmetry, nodes;  ///< N, N/g, g, n_c
    std::size_t width;
  };
  ModalWaves(const RotorAtSpeed& rotor, const SchemeOptions& scheme, double time_step, const Nodes& nodes);

  std::size_t size() const { return waves_.size(); }
  const MarchedWave& operator[](std::size_t wave) const { return waves_[wave]; }
  /// q at t_q, its increment q - q- since t_{q-1}, and that of the step before.
  ModalCoordinates coordinates(std::size_t wave) const;
  ModalCoordinates increments(std::size_t wave) const;
  ModalCoordinates increments_before(std::size_t wave) const;
  /// [N] Lambda_n = (w_n g / N) sum_j lambda_j e^{-i n j alpha} of the forces added last; n_c.
  Eigen::VectorXcd forces(std::size_t wave) const;
  /// [m/N] W = sum over n of Re(Y c Y^H e^{i n (j - j') alpha}) w_n g / N; padded rows zero.
  Eigen::MatrixXd compliance(const RotorAtSpeed& rotor) const;

  /// Of each contact node of a sector and its padding: <r> = (Y r c Y^H)/(Y c Y^H), <k> likewise, summed over n as W.
  /// Only nodal diameters that are multiples of `symmetry` count, so that a symmetric motion is the same with the
  /// others and without.
  std::vector<Recoil> recoils(const RotorAtSpeed& rotor, int symmetry) const;

  void set_state(std::size_t wave, const Eigen::VectorXcd& q, const Eigen::VectorXcd& increment);
  /// The free step and the normal displacements [m] after it.
  void advance(Eigen::VectorXd& displacement);
  /// The normal displacements [m] after a further free step, which is not done.
  void look_ahead(Eigen::VectorXd& displacement);
  /// The normal displacements [m] of the modes as they are, and as they were a step ago.
  void map_to_sectors(Eigen::VectorXd& displacement, Eigen::VectorXd& before);
  /// q+ -= c Y^H Lambda_n of the forces [N] along -normal on the nodes listed, ascending.
  void add_forces(const Eigen::VectorXd& forces, const std::vector<int>& nodes);
  /// Takes c Y^H Lambda_n of impulses [N] over a step from the increments only, as if the nodes had come to q+ with
  /// another velocity.
  void add_impulses(const Eigen::VectorXd& impulses, const std::vector<int>& nodes);
  /// What the last add_impulses() has added to the increments.
  ModalCoordinates jumps(std::size_t wave) const;

 private:
  /// The working arrays of one nodal diameter.
  struct Memory {
    Eigen::VectorXd q, increment, increment_before, jump;  ///< real parts, then imaginary parts
    kernels::Lines shapes;                                 ///< Y in the order of wave_kernels.h
    Eigen::VectorXd forces;                                ///< Lambda_n, real parts, then imaginary parts
    Eigen::VectorXd cosine, sine;                          ///< of n j alpha, by sector
  };
  Memory lay_out(const WaveModes& from, const MarchedWave& wave) const;
  void advance_modes(std::size_t wave);
  /// Computes the share of p_ of one wave from its modes.
  void map_to_nodes(std::size_t wave, const Eigen::VectorXd& modes);
  ModalCoordinates view(std::size_t wave, Eigen::VectorXd Memory::*parts) const;
  void add_sectors(Eigen::VectorXd& displacement) const;
  void settle_forces() const;
  /// Finds Lambda_n of forces.
  void gather(const Eigen::VectorXd& forces, const std::vector<int>& nodes);
  void add_waiting_forces(std::size_t wave) const { take_forces(wave, memory_[wave].q); }
  /// Takes the effect of Lambda_n from the increments, and from `other`.
  void take_forces(std::size_t wave, Eigen::VectorXd& other) const;

  Nodes nodes_;
  std::vector<MarchedWave> waves_;
  mutable std::vector<Memory> memory_;
  mutable bool forces_wait_ = false;       ///< the last forces are not in the modes yet
  Eigen::VectorXd ahead_;                  ///< [m sqrt(kg)] of one nodal diameter, after a further step
  Eigen::VectorXd p_;                      ///< Y q, for each wave real parts, then imaginary parts
  std::vector<double> phases_of_sectors_;  ///< for each sector and wave, the cosine and the sine of n j alpha
  std::vector<int> forced_nodes_;          ///< nodes with a force in any sector
  std::vector<int> forced_sectors_;        ///< sectors with a force at any node
  std::vector<char> node_has_force_;
};

}  // namespace tiprub::simulate
