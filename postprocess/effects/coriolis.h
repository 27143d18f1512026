// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "reduce/model/fields_file.h"
#include "reduce/model/reduced_model.h"

namespace tiprub {

/// How much Coriolis' terms, which the model leaves out, move a natural frequency: M q'' + 2 Omega G q' + K q = 0 in
/// the lowest modes of its nodal diameter, u* G u the integral of rho conj(u) . (e_z x u), their shapes recovered on
/// the sector.
class CoriolisTerms {
 public:
  CoriolisTerms(const FieldsReader& reader, const ReducedModel& model);

  /// [1] relative, the larger one of both directions of the wave; `family` from 0, at a speed [rad/s].
  double change(int nodal_diameter, int family, double speed) const;

 private:
  const FieldsReader& reader_;
  const ReducedModel& model_;
  Eigen::VectorXd masses_;  // of the sector's nodes
};

/// [rad/s] Frequencies with Coriolis' terms, ascending: those below zero are waves that run the other way. `modes`
/// [rad/s] without them, above zero; `coupling` the integral of rho conj(u_i) . (e_z x u_j) for modes of unit modal
/// mass, skew-Hermitian. They solve (-omega^2 + 2 i Omega omega G + diag(modes^2)) q = 0, which with H = i G is the
/// Hermitian eigenproblem of [0 W; W 2 Omega H], W = diag(modes).
Eigen::VectorXd gyroscopic_frequencies(const Eigen::VectorXd& modes, const Eigen::MatrixXcd& coupling, double speed);

/// [m^3] so much of the volume stands for each node in the integral of what is quadratic over a cell: exact in
/// parallelepipeds (corners of 20-node bricks and of 10-node tetrahedra count negative). By sector node.
Eigen::VectorXd node_volumes(const SectorFields& sector);

/// Coupling of shapes of unit modal mass (3 nodes x shapes; r, theta, z of node 0, then of node 1, ...), with the
/// masses [kg] that stand for the nodes. They are not scaled here: of what waves within a cell, masses below zero
/// leave none.
Eigen::MatrixXcd coriolis_coupling(const Eigen::MatrixXcd& shapes, const Eigen::VectorXd& masses);

}  // namespace tiprub
