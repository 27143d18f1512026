// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "cases/program/errors.h"
#include "cases/program/units.h"
#include "reduce/model/speed_polynomial.h"
#include "reduce/sector/reduction_parameters.h"

namespace tiprub::reduce {

/// "at 9000 rpm", of a speed in rad/s.
inline std::string name_of_speed(double speed) {
  return "at " + std::to_string(std::lround(speed * rpm_per_rad_s)) + " rpm";
}

/// Calls `body`, and adds the speed [rad/s] to the message of a RunError.
template <class Body>
auto at_speed(double speed, const Body& body) {
  try {
    return body();
  } catch (const RunError& error) {
    throw RunError(name_of_speed(speed) + ": " + error.what());
  }
}

/// eq. 7: Y(Omega) = Y0 + Omega^2 Y1 + Omega^4 Y2 + ... through as many speeds as it has terms (the paper takes
/// three: 0, Omega_max/2, Omega_max; Sternchuess and Balmes 2006). With three terms exact for linear and stress-only
/// prestress, with 2m + 1 for a shape under spin of m terms (see SpinShape).
class PolynomialFit {
 public:
  /// Speeds [rad/s], ascending from zero.
  explicit PolynomialFit(const std::vector<double>& speeds);

  /// The polynomial through Y, matrices or vectors, at the speeds. With many terms the inverse of the Vandermonde
  /// matrix loses digits, so that the misfit at the speeds is fitted again (iterative refinement).
  template <class Matrix>
  SpeedPolynomial<Matrix, 0> through(const std::vector<Matrix>& samples) const;
  /// The weights w with which Y(Omega) is the sum of w_s Y(Omega_s) over the speeds Omega_s.
  Eigen::VectorXd weights(double speed) const;

 private:
  template <class Matrix>
  std::vector<Matrix> solve(const std::vector<Matrix>& samples) const;

  static constexpr double tolerance = 1e-13;  // of the misfit that ends the refinement
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

/// The speeds, as fractions of Omega_max, at which the basis is corrected: between rest and Omega_max, and at
/// Omega_max itself, where the modes come from one inverse iteration only.
inline constexpr std::array corrected_speeds = {0.25, 0.5, 0.75, 1.0};

/// Speeds [rad/s] from fractions of Omega_max.
std::vector<double> speeds_at(std::vector<double> fractions, double speed_max);

/// The `steps` + 1 fractions 0 .. 1 of Omega_max whose squares are Chebyshev points, ascending. The points for
/// twice as many steps include all of them.
std::vector<double> chebyshev_fractions(int steps);

/// The speeds, as fractions of Omega_max, at which a sector's K is assembled. The polynomial of eq. 7 goes through
/// the first of them. It is exact for the K of a SpinShape, so that any speeds may be chosen. With nonlinear
/// prestress, the speeds at which K of the equilibrium itself is required come after them.
class SpeedSamples {
 public:
  /// `shape_terms` of the SpinShape.
  SpeedSamples(const ReductionParameters& parameters, int shape_terms);

  const std::vector<double>& fractions() const { return fractions_; }
  /// The number of speeds that eq. 7 goes through: the first ones, from zero to one.
  int polynomial_terms() const { return terms_; }
  std::vector<double> polynomial_fractions() const { return {fractions_.begin(), fractions_.begin() + terms_}; }
  /// The weights with which K at any fraction is a sum of K at the samples. At a sample only that sample has a
  /// weight; K of the equilibrium is preferred if it is known there.
  Eigen::VectorXd weights(double fraction) const;
  /// This sum for a model's small matrices.
  Eigen::MatrixXcd combine(const std::vector<Eigen::MatrixXcd>& samples, double fraction) const;

 private:
  std::vector<double> fractions_;
  int terms_;
};

}  // namespace tiprub::reduce
