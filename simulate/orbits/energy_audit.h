// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "simulate/march/time_march.h"
#include "simulate/motion/motion.h"

namespace tiprub::simulate {

/// The energy of the whole wheel in the discrete sense of the scheme (see StepCoefficients): multiplied with
/// (q+ - q-)/2, a step is the exact balance
///   E(q+, q) - E(q, q-) = sum_j,k -lambda ((p+ - p-) + mu tau . (s+ - s-))/2 - eta |q+ - q-|^2/(4 h),
///   E(q+, q) = 1/2 mu |q+ - q|^2/h^2 + 1/2 omega^2 Re(q+ conj q),
/// with the normal displacement p and, if there is friction, the displacement s along the casing. The work is summed
/// at the contact nodes and the other terms in modes. The closing error is therefore rounding, and also tests the
/// maps between nodes and modes. On a wall at rest with complementarity the normal force's work is -lambda g-/2 <= 0:
/// without friction, contact never adds energy. Friction can, because the rotation drives it. The impulse of an
/// impact within a step (InnerImpact) changes the increment at t_{q+1}; the change of E is work. Beside another node
/// that rebounds, this step and the next may gain energy; less than 1e-6 of it has been seen.
class EnergyAudit {
 public:
  /// Starts the ledger at the present state of the march.
  explicit EnergyAudit(const TimeMarch& march);
  /// To be called after each step.
  void observe(const TimeMarch& march);
  EnergyLedger ledger(const TimeMarch& march) const;
  /// [1] the elastic energy of the modes that have no mass or are dropped over that of all modes, from means over the
  /// observed steps.
  double left_out_share() const;
  /// [J] between the last two instants.
  double energy(const TimeMarch& march) const;

 private:
  struct Terms {
    double ring;                ///< N / w_n: modal energy to that of the wheel
    Eigen::ArrayXd inertia;     ///< mu / (2 h^2) [1/s^2]; zero for padding
    Eigen::ArrayXd stiffness;   ///< omega^2 / 2 [1/s^2]
    Eigen::ArrayXd damping;     ///< eta / (4 h) [1/s^2]
    Eigen::MatrixXcd residual;  ///< [m/N] compliance of the modes without mass or dropped; may be empty
  };
  using Modes = Eigen::Map<const Eigen::ArrayXd>;
  static double jump_work(const Terms& terms, const Modes& q, const Modes& increment, const Modes& jump);
  void observe_left_out(const TimeMarch& march);
  void observe_drag(const TimeMarch& march);

  std::vector<Terms> terms_;
  double start_ = 0;
  double work_ = 0;
  double drag_work_ = 0;
  double dissipated_ = 0;
  double left_out_ = 0;  ///< [J] summed over steps
  double elastic_ = 0;   ///< [J] of the modes with mass, summed over steps
};

}  // namespace tiprub::simulate
