// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "reduce/sector/reduction_parameters.h"

namespace tiprub {

/// Where, over Omega_max, the basis is corrected by modes that it may miss: between the speeds that made it,
/// and at full speed, whose modes it has from one inverse iteration.
inline constexpr std::array corrected_speeds = {0.25, 0.5, 0.75, 1.0};

/// [rad/s] of fractions of Omega_max.
std::vector<double> speeds_at(std::vector<double> fractions, double speed_max);

/// Fractions 0 .. 1 of Omega_max whose squares are Chebyshev's points, `steps` + 1 of them, ascending. Twice as many
/// steps keep all of them.
std::vector<double> chebyshev_fractions(int steps);

/// The speeds, as fractions of Omega_max, at which a sector's K is assembled. First those that eq. 7 goes through: it
/// is exact for K of the shapes that a SpinShape has, so that any speeds do. Then, with nonlinear prestress, those at
/// which K of the equilibrium itself is wanted beside.
class SpeedSamples {
 public:
  /// `shape_terms` of the SpinShape.
  SpeedSamples(const ReductionParameters& parameters, int shape_terms);

  const std::vector<double>& fractions() const { return fractions_; }
  /// Those that eq. 7 goes through are the first, from zero to one.
  int polynomial_terms() const { return terms_; }
  std::vector<double> polynomial_fractions() const { return {fractions_.begin(), fractions_.begin() + terms_}; }
  /// K at any fraction as a sum of K at the samples: the weight of each. At a sample, that one alone; at an
  /// equilibrium, K of the equilibrium.
  Eigen::VectorXd weights(double fraction) const;
  /// That sum for a model's small matrices.
  Eigen::MatrixXcd combine(const std::vector<Eigen::MatrixXcd>& samples, double fraction) const;

 private:
  std::vector<double> fractions_;
  int terms_;
};

}  // namespace tiprub
