// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/speed_polynomial.h"

namespace tiprub {

SpeedPolynomial SpeedPolynomial::through(const Eigen::MatrixXcd& at_rest, const Eigen::MatrixXcd& at_half,
                                         const Eigen::MatrixXcd& at_full, double speed_max) {
  const double square = speed_max * speed_max;
  return {at_rest, (16 * at_half - at_full - 15 * at_rest) / (3 * square),
          4 * (at_full - 4 * at_half + 3 * at_rest) / (3 * square * square)};
}

}  // namespace tiprub
