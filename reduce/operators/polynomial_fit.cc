// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/polynomial_fit.h"

#include <Eigen/LU>

namespace tiprub {

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

}  // namespace tiprub
