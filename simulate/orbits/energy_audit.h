// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "simulate/march/time_march.h"
#include "simulate/motion/motion.h"

namespace tiprub::simulate {

/// The energy of the whole wheel in the discrete sense of the scheme. A step (StepCoefficients, with the modified
/// mass m_h), multiplied by (q+ - q-)/2, is the exact balance
///   E(q+, q) - E(q, q-) = -sum_j,k lambda ((p+ - p-) + mu tau . (u+ - u-))/2 - eta |q+ - q-|^2/(4 h),
///   E(q+, q) = m_h |q+ - q|^2/(2 h^2) + omega^2 Re(q+ conj q)/2,
/// with the normal displacement p and, with friction of the coefficient mu, the displacement u along the casing. With
/// a gap of second order, p gains G y (SecondOrderTerms). The work is summed over the contact nodes and the other
/// terms over the modes. The closing error is therefore due to rounding only, and tests the maps between nodes and
/// modes.
///
/// On a wall at rest with complementarity and a linear gap, the work of the normal force is -lambda g-/2 <= 0, so
/// that contact without friction never adds energy. Friction can add energy, because rotation drives it. The impulse
/// of an impact within a step (InnerImpact) changes the increment at t_{q+1}, and the change of E counts as work. If
/// another node rebounds beside it, this step and the next may gain energy; less than 1e-6 of it has been seen.
class EnergyAudit {
 public:
  /// Starts the ledger at the present state of the march.
  explicit EnergyAudit(const TimeMarch& march);
  /// Adds the last step to the ledger; to be called after each step.
  void observe(const TimeMarch& march);
  EnergyLedger ledger(const TimeMarch& march) const;
  /// [1] The elastic energy of the modes that have no mass or are dropped, over that of all modes; from means over
  /// the observed steps.
  double left_out_share() const;
  /// [J] The energy E between the last two instants.
  double energy(const TimeMarch& march) const;

 private:
  struct Terms {
    double ring;                ///< N / w_n, the factor from modal energy to that of the wheel
    Eigen::ArrayXd inertia;     ///< m_h / (2 h^2) [1/s^2]; zero for padding
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
