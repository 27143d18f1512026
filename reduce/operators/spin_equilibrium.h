// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <map>
#include <set>

#include "reduce/operators/cyclic_solver.h"

namespace tiprub::reduce {

/// A sector, and the factor that its loaded shapes are found with.
struct SpinProblem {
  const RotatingElasticity& elasticity;
  const SectorMesh& mesh;
  const CyclicSolver& nearby;  ///< K of nodal diameter 0 at some speed, usually rest
};

/// The shape that a sector takes under spin, large displacements included.
struct SpinEquilibrium {
  Eigen::VectorXd displacement;  ///< [m] sector dofs
  int iterations = 0;            ///< Newton's
  double residual = 0;           ///< [1] see spin_equilibrium()
};

/// Solves int B(F)' S(E) = Omega^2 int rho N (X + u)_perp for u (total Lagrangian, St Venant-Kirchhoff, load at the
/// displaced radius), the same in every sector, by Newton's method
///     K_T du = r,  K_T = material stiffness at F + K_S of the second Piola-Kirchhoff stress - Omega^2 M_perp,
/// from `guess` (sector dofs) [m] at `speed` [rad/s]. The nearby K preconditions the conjugate gradients for K_T, so
/// that a speed requires no factor of its own, and defines the energy norm of the residual: iteration ends when
/// sqrt(r' K^-1 r) / sqrt(f' K^-1 f) <= 1e-10 with the load f, which means a relative error of the shape of about
/// 1e-10. Steps that would increase the residual are halved. Costs four to six steps, each with an assembly and some
/// ten solves. Raises RunError if K_T is not positive definite on the way (the rotor is unstable) or if it doesn't
/// converge.
SpinEquilibrium spin_equilibrium(const SpinProblem& problem, double speed, const Eigen::VectorXd& guess);

/// The share of the load at a speed [rad/s] that a shape (sector dofs) [m] leaves out of balance: the residual of
/// spin_equilibrium(). Costs the forces and two solves.
double spin_imbalance(const SpinProblem& problem, double speed, const Eigen::VectorXd& shape);

/// A known shape from which the search for another one starts.
struct KnownShape {
  double speed = 0;             ///< [rad/s]
  Eigen::VectorXd over_square;  ///< [m s^2] displacement over Omega^2; sector dofs
};

/// Runs spin_equilibrium() from the shape at a lower speed, scaled with Omega^2. If Newton's method doesn't
/// converge, one or more speeds are inserted in between. Raises RunError with the first speed that isn't reached.
SpinEquilibrium climb(const SpinProblem& problem, const KnownShape& from, double speed, int halvings = 3);

/// [m s^2] The linear static shape over Omega^2, K(0)^-1 f; sector dofs. The nearby K must be that at rest.
Eigen::VectorXd linear_shape(const SpinProblem& problem);

/// Static shapes at some speeds.
struct SpinShapes {
  std::map<double, Eigen::VectorXd> at;  ///< [m] sector dofs, by speed [rad/s]
  int newton_steps = 0;                  ///< most of all speeds; none unless nonlinear
  double newton_residual = 0;            ///< [1] largest of all speeds
};

/// The shapes under spin at these speeds [rad/s]. Linear and stress-only prestress: Omega^2 K(0)^-1 f. Nonlinear:
/// climb(), each from the one before it. The nearby K must be that at rest. Raises RunError, with the speed.
SpinShapes shapes_under_spin(const SpinProblem& problem, const std::set<double>& speeds, Prestress prestress);

}  // namespace tiprub::reduce
