// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/speed_samples.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tiprub::reduce {

PolynomialFit::PolynomialFit(const std::vector<double>& speeds) : speeds_(speeds) {
  const auto terms = static_cast<Eigen::Index>(speeds.size());
  vandermonde_.resize(terms, terms);
  for (Eigen::Index row = 0; row < terms; ++row)
    for (Eigen::Index term = 0; term < terms; ++term)
      vandermonde_(row, term) = std::pow(speeds[row] / speeds.back(), 2.0 * static_cast<double>(term));
  inverse_ = vandermonde_.inverse();
}

Eigen::VectorXd PolynomialFit::weights(double speed) const {
  Eigen::RowVectorXd powers(inverse_.rows());
  for (Eigen::Index term = 0; term < powers.size(); ++term)
    powers[term] = std::pow(speed / speeds_.back(), 2.0 * static_cast<double>(term));
  Eigen::RowVectorXd weights = powers * inverse_;
  for (int round = 0; round < refinements; ++round) {
    const Eigen::RowVectorXd missed = powers - weights * vandermonde_;
    if (missed.cwiseAbs().maxCoeff() <= tolerance * powers.maxCoeff()) break;
    weights += missed * inverse_;
  }
  return weights.transpose();
}

std::vector<double> speeds_at(std::vector<double> fractions, double speed_max) {
  for (double& fraction : fractions) fraction *= speed_max;
  return fractions;
}

// (1 - cos(a)) / 2 = sin(a/2)^2
std::vector<double> chebyshev_fractions(int steps) {
  std::vector<double> fractions;
  for (int k = 0; k <= steps; ++k)
    fractions.push_back(std::sin(static_cast<double>(k) / steps * std::numbers::pi / 2));
  return fractions;
}

SpeedSamples::SpeedSamples(const ReductionParameters& parameters, int shape_terms)
    : fractions_(shape_terms == 1 ? std::vector{0.0, 0.5, 1.0}  // the paper's
                                  : chebyshev_fractions(2 * shape_terms)),
      terms_(static_cast<int>(fractions_.size())) {
  if (parameters.prestress != Prestress::nonlinear) return;
  for (const double fraction : parameters.verification_speeds)
    if (fraction != 0.0 && fraction != 1.0) fractions_.push_back(fraction);  // there the shape is the equilibrium's
}

Eigen::VectorXd SpeedSamples::weights(double fraction) const {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(fractions_.size()));
  const auto sample = std::find(fractions_.rbegin(), fractions_.rend(), fraction);  // equilibria first
  if (sample != fractions_.rend())
    weights[fractions_.rend() - sample - 1] = 1;
  else
    weights.head(terms_) = PolynomialFit(polynomial_fractions()).weights(fraction);
  return weights;
}

Eigen::MatrixXcd SpeedSamples::combine(const std::vector<Eigen::MatrixXcd>& samples, double fraction) const {
  const Eigen::VectorXd weight = weights(fraction);
  Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(samples.front().rows(), samples.front().cols());
  for (Eigen::Index s = 0; s < weight.size(); ++s)
    if (weight[s] != 0) sum += weight[s] * samples[s];
  return sum;
}

}  // namespace tiprub::reduce
