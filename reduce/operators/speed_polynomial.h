// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace tiprub {

/// eq. 7: Y(Omega) = Y0 + Omega^2 Y1 + Omega^4 Y2 + ... through as many speeds as it has terms (the paper takes
/// three: 0, Omega_max/2, Omega_max; Sternchuess and Balmes 2006). With three terms exact for linear and stress-only
/// prestress, with 2m + 1 for a shape under spin of m terms (see SpinShape).
class SpeedPolynomial {
 public:
  /// Speeds [rad/s], ascending from zero.
  explicit SpeedPolynomial(const std::vector<double>& speeds);

  /// Y0, Y1, ... from Y, matrices or vectors, at the speeds. With many terms the inverse of their matrix loses
  /// digits: what the sum then misses of Y at the speeds is taken for Y once more (iterative refinement).
  template <class Matrix>
  std::vector<Matrix> coefficients(const std::vector<Matrix>& samples) const;
  /// Y(Omega) as a sum of Y at the speeds: the weight of each.
  Eigen::VectorXd weights(double speed) const;

 private:
  template <class Matrix>
  std::vector<Matrix> solve(const std::vector<Matrix>& samples) const;
  template <class Matrix>
  Matrix sum(const std::vector<Matrix>& terms, double speed) const;

  static constexpr double tolerance = 1e-13;  // of what a refinement may leave
  static constexpr int refinements = 2;       // of 17 terms; three need none
  std::vector<double> speeds_;
  Eigen::MatrixXd vandermonde_;  // in (Omega/Omega_max)^2; speeds x terms
  Eigen::MatrixXd inverse_;
};

template <class Matrix>
std::vector<Matrix> SpeedPolynomial::solve(const std::vector<Matrix>& samples) const {
  std::vector<Matrix> result = {samples.front()};  // as it is: the first speed is zero
  for (Eigen::Index term = 1; term < inverse_.rows(); ++term) {
    Matrix sum = inverse_(term, 0) * samples.front();
    for (Eigen::Index sample = 1; sample < inverse_.cols(); ++sample) sum += inverse_(term, sample) * samples[sample];
    result.push_back(sum / std::pow(speeds_.back(), 2.0 * static_cast<double>(term)));
  }
  return result;
}

template <class Matrix>
Matrix SpeedPolynomial::sum(const std::vector<Matrix>& terms, double speed) const {
  Matrix sum = terms.front();
  for (std::size_t k = 1; k < terms.size(); ++k) sum += std::pow(speed, 2.0 * static_cast<double>(k)) * terms[k];
  return sum;
}

// eq. 7, for any number of speeds.
template <class Matrix>
std::vector<Matrix> SpeedPolynomial::coefficients(const std::vector<Matrix>& samples) const {
  std::vector<Matrix> terms = solve(samples), missed = samples;
  for (int round = 0; round < refinements; ++round) {
    double largest = 0, scale = 0;
    for (std::size_t s = 0; s < samples.size(); ++s) {
      missed[s] = samples[s] - sum(terms, speeds_[s]);
      largest = std::max(largest, missed[s].cwiseAbs().maxCoeff());
      scale = std::max(scale, samples[s].cwiseAbs().maxCoeff());
    }
    if (largest <= tolerance * scale) break;
    const std::vector<Matrix> more = solve(missed);
    for (std::size_t k = 0; k < terms.size(); ++k) terms[k] += more[k];
  }
  return terms;
}

}  // namespace tiprub
