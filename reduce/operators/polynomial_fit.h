// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "reduce/model/speed_polynomial.h"

namespace tiprub {

/// eq. 7: Y(Omega) = Y0 + Omega^2 Y1 + Omega^4 Y2 + ... through as many speeds as it has terms (the paper takes
/// three: 0, Omega_max/2, Omega_max; Sternchuess and Balmes 2006). With three terms exact for linear and stress-only
/// prestress, with 2m + 1 for a shape under spin of m terms (see SpinShape).
class PolynomialFit {
 public:
  /// Speeds [rad/s], ascending from zero.
  explicit PolynomialFit(const std::vector<double>& speeds);

  /// From Y, matrices or vectors, at the speeds. With many terms the inverse of their matrix loses
  /// digits: what the sum then misses of Y at the speeds is taken for Y once more (iterative refinement).
  template <class Matrix>
  SpeedPolynomial<Matrix, 0> through(const std::vector<Matrix>& samples) const;
  /// Y(Omega) as a sum of Y at the speeds: the weight of each.
  Eigen::VectorXd weights(double speed) const;

 private:
  template <class Matrix>
  std::vector<Matrix> solve(const std::vector<Matrix>& samples) const;

  static constexpr double tolerance = 1e-13;  // of what a refinement may leave
  static constexpr int refinements = 2;       // of 17 terms; three need none
  std::vector<double> speeds_;
  Eigen::MatrixXd vandermonde_;  // in (Omega/Omega_max)^2; speeds x terms
  Eigen::MatrixXd inverse_;
};

template <class Matrix>
std::vector<Matrix> PolynomialFit::solve(const std::vector<Matrix>& samples) const {
  std::vector<Matrix> result = {samples.front()};  // as it is: the first speed is zero
  for (Eigen::Index term = 1; term < inverse_.rows(); ++term) {
    Matrix sum = inverse_(term, 0) * samples.front();
    for (Eigen::Index sample = 1; sample < inverse_.cols(); ++sample) sum += inverse_(term, sample) * samples[sample];
    result.push_back(sum / std::pow(speeds_.back(), 2.0 * static_cast<double>(term)));
  }
  return result;
}

// eq. 7, for any number of speeds.
template <class Matrix>
SpeedPolynomial<Matrix, 0> PolynomialFit::through(const std::vector<Matrix>& samples) const {
  SpeedPolynomial<Matrix, 0> Y{solve(samples)};
  std::vector<Matrix> missed = samples;
  for (int round = 0; round < refinements; ++round) {
    double largest = 0, scale = 0;
    for (std::size_t s = 0; s < samples.size(); ++s) {
      missed[s] = samples[s] - Y(speeds_[s]);
      largest = std::max(largest, missed[s].cwiseAbs().maxCoeff());
      scale = std::max(scale, samples[s].cwiseAbs().maxCoeff());
    }
    if (largest <= tolerance * scale) break;
    const std::vector<Matrix> more = solve(missed);
    for (std::size_t k = 0; k < more.size(); ++k) Y.terms[k] += more[k];
  }
  return Y;
}

}  // namespace tiprub
