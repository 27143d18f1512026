// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/speed_polynomial.h"

#include <Eigen/LU>
#include <cmath>

namespace tiprub {

SpeedPolynomial::SpeedPolynomial(const std::vector<double>& speeds) : speed_max_(speeds.back()) {
  const auto terms = static_cast<Eigen::Index>(speeds.size());
  Eigen::MatrixXd vandermonde(terms, terms);
  for (Eigen::Index row = 0; row < terms; ++row)
    for (Eigen::Index term = 0; term < terms; ++term)
      vandermonde(row, term) = std::pow(speeds[row] / speed_max_, 2.0 * static_cast<double>(term));
  inverse_ = vandermonde.inverse();
}

// eq. 7, for any number of speeds.
std::vector<Eigen::MatrixXcd> SpeedPolynomial::coefficients(const std::vector<Eigen::MatrixXcd>& samples) const {
  std::vector<Eigen::MatrixXcd> result = {samples.front()};  // as it is: the first speed is zero
  for (Eigen::Index term = 1; term < inverse_.rows(); ++term) {
    Eigen::MatrixXcd sum = inverse_(term, 0) * samples.front();
    for (Eigen::Index sample = 1; sample < inverse_.cols(); ++sample) sum += inverse_(term, sample) * samples[sample];
    result.push_back(sum / std::pow(speed_max_, 2.0 * static_cast<double>(term)));
  }
  return result;
}

Eigen::VectorXd SpeedPolynomial::weights(double speed) const {
  Eigen::RowVectorXd powers(inverse_.rows());
  for (Eigen::Index term = 0; term < powers.size(); ++term)
    powers[term] = std::pow(speed / speed_max_, 2.0 * static_cast<double>(term));
  return (powers * inverse_).transpose();
}

}  // namespace tiprub
