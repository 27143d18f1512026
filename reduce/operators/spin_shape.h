// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reduce/model/speed_polynomial.h"
#include "reduce/operators/spin_equilibrium.h"
#include "reduce/sector/reduction_parameters.h"

namespace tiprub {

/// The shape that a sector takes under spin, at every speed:
///     u(Omega) = Omega^2 s_1 + Omega^4 s_2 + ... + Omega^2m s_m.
/// Linear and stress-only prestress: s_1 alone, exactly. Nonlinear: through the equilibria at m speeds.
///
/// Why a polynomial of the shape, and not of K through its own samples: a thin blade that turns takes its stiff
/// directions with it. Entry by entry, a polynomial through K is as wrong between its speeds as these directions
/// turn, by a part of the membrane's stiffness that may be many times the bending stiffness. The tangent of a shape
/// has its stiff directions where the shape has turned them, whichever shape it is. And it is quadratic in the shape
/// (St Venant-Kirchhoff), so that K at all of these shapes is K0 + Omega^2 K1 + ... of 2m + 1 terms, exactly: eq. 7,
/// which has three, is the case of m = 1.
struct SpinShape {
  SpeedPolynomial<Eigen::VectorXd, 1> displacement;  ///< u; s_1, s_2, ... [m s^2, m s^4, ...]; sector dofs
  double imbalance = 0;   ///< [1] see spin_imbalance(); largest in the middle between its speeds
  SpinShapes equilibria;  ///< at the verification speeds, and at those that it goes through
};

/// As many terms as `polynomial_speeds` says or, with 0, as it takes: 1, 2, 4 or 8, the first that leaves less than
/// `polynomial_tolerance` of the load out of balance, or 8. Their speeds are Chebyshev's of Omega^2 on 0 ..
/// Omega_max, of which each choice keeps those of the one before. `at_rest` is K(0) of nodal diameter 0. Raises
/// RunError, with the speed, where there is no equilibrium.
SpinShape spin_shape(const RotatingElasticity& elasticity, const SectorMesh& mesh, const CyclicSolver& at_rest,
                     const ReductionParameters& parameters);

}  // namespace tiprub
