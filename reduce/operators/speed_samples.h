// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <optional>
#include <vector>

#include "reduce/sector/reduction_parameters.h"

namespace tiprub {

/// Where, over Omega_max, the basis is corrected by modes that it may miss: between the speeds that made it,
/// and at full speed, whose modes it has from one inverse iteration.
inline constexpr std::array corrected_speeds = {0.25, 0.5, 0.75, 1.0};

/// [rad/s] of fractions of Omega_max.
std::vector<double> speeds_at(std::vector<double> fractions, double speed_max);

/// The speeds, as fractions of Omega_max, at which a sector's K is assembled. Linear and stress-only prestress: those
/// that eq. 7 takes, for it is exact and gives all others. Nonlinear prestress: every speed that is looked at.
class SpeedSamples {
 public:
  explicit SpeedSamples(const ReductionParameters& parameters);

  /// Ascending from zero to one, or beyond if verification speeds lie there.
  const std::vector<double>& fractions() const { return fractions_; }
  /// Which sample a fraction is, if it is one.
  std::optional<std::size_t> find(double fraction) const;
  /// The numbers of speeds that eq. 7 may take, the first of them first.
  const std::vector<int>& polynomial_choices() const { return polynomial_choices_; }
  /// K at any fraction as a sum of K at the samples: the weight of each. At a sample, that one alone.
  Eigen::VectorXd weights(double fraction) const;
  /// That sum for a model's small matrices.
  Eigen::MatrixXcd combine(const std::vector<Eigen::MatrixXcd>& samples, double fraction) const;

  /// Equal steps from zero to one.
  static std::vector<double> polynomial_fractions(int speeds);

 private:
  std::vector<double> fractions_;
  std::vector<int> polynomial_choices_;
};

}  // namespace tiprub
