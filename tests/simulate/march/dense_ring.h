// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "reduce/model/reduced_model.h"
#include "simulate/march/contact_impulses.h"
#include "simulate/scene/casing.h"

namespace tiprub::simulate::testing {

/// The paper's eq. 13, eq. 14 and eq. 15 as they stand, on the matrices of its eq. 11 and eq. 12: physical
/// coordinates of the whole wheel, dense matrices. Slow, and written without a line of the march; what it is measured
/// against.
class DenseRing {
 public:
  DenseRing(const ReducedModel& model, const Casing& casing, double speed, double damping_ratio,
            int steps_per_revolution, ContactRule rule);

  void step();

  /// [m] after the last step: gaps, and displacements along the normals; sector by sector.
  const Eigen::VectorXd& gap() const { return gap_; }
  Eigen::VectorXd normal_displacement() const { return C_.transpose() * u_; }
  /// [N] of the last step.
  const Eigen::VectorXd& multipliers() const { return lambda_; }

 private:
  void close_penetrating();
  void complement();

  const ReducedModel& model_;
  const Casing& casing_;
  int steps_;
  ContactRule rule_;
  long step_ = 0;
  Eigen::MatrixXd C_;                     ///< normals; dofs x contacts
  Eigen::MatrixXd onto_u_, onto_before_;  ///< the two matrices of eq. 13
  Eigen::MatrixXd push_;                  ///< [M/h^2 + D/2h]^-1 C
  Eigen::MatrixXd W_;                     ///< C^T push
  Eigen::VectorXd clearance_, u_, before_, gap_, lambda_;
};

}  // namespace tiprub::simulate::testing
