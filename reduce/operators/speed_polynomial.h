// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace tiprub {

/// eq. 7: Y(Omega) = Y0 + Omega^2 Y1 + Omega^4 Y2 + ... through as many speeds as it has terms (the paper takes
/// three: 0, Omega_max/2, Omega_max; Sternchuess and Balmes 2006). With three terms exact for linear and stress-only
/// prestress; for others its misfit in between is to be measured.
class SpeedPolynomial {
 public:
  /// Speeds [rad/s], ascending from zero.
  explicit SpeedPolynomial(const std::vector<double>& speeds);

  /// Y0, Y1, ... from Y at the speeds.
  std::vector<Eigen::MatrixXcd> coefficients(const std::vector<Eigen::MatrixXcd>& samples) const;
  /// Y(Omega) as a sum of Y at the speeds: the weight of each.
  Eigen::VectorXd weights(double speed) const;

 private:
  double speed_max_;
  Eigen::MatrixXd inverse_;  // of the Vandermonde matrix in (Omega/Omega_max)^2; terms x speeds
};

}  // namespace tiprub
