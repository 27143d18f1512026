// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

namespace tiprub {

/// Y(Omega) = Y0 + Omega^2 Y1 + Omega^4 Y2 through three speeds 0, Omega_max/2, Omega_max (eq. 7 of the paper;
/// Sternchuess and Balmes 2006). Exact for linear and stress-only prestress; for others its misfit in between is to
/// be measured.
struct SpeedPolynomial {
  Eigen::MatrixXcd Y0, Y1, Y2;

  static SpeedPolynomial through(const Eigen::MatrixXcd& at_rest, const Eigen::MatrixXcd& at_half,
                                 const Eigen::MatrixXcd& at_full, double speed_max);
};

}  // namespace tiprub
