// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "reduce/model/speed_polynomial.h"
#include "reduce/operators/sector_factor.h"
#include "reduce/operators/speed_samples.h"
#include "reduce/operators/spin_equilibrium.h"
#include "reduce/sector/reduction_parameters.h"

namespace tiprub::reduce {

/// The shape that a sector takes under spin, at every speed:
///     u(Omega) = Omega^2 s_1 + Omega^4 s_2 + ... + Omega^2m s_m.
/// With linear and stress-only prestress s_1 is the only term, and exact. With nonlinear prestress the polynomial
/// goes through the equilibria at m speeds.
///
/// The shape is interpolated, not K, because a thin blade that rotates under spin rotates its stiff directions too
/// (see reduce/theory.md). The tangent stiffness is quadratic in the shape (St Venant-Kirchhoff), so that K at all of
/// these shapes is exactly K0 + Omega^2 K1 + ... with 2m + 1 terms. Eq. 7, which has three terms, is the case m = 1.
struct SpinShape {
  SpeedPolynomial<Eigen::VectorXd, 1> displacement;  ///< u; s_1, s_2, ... [m s^2, m s^4, ...]; sector dofs
  double imbalance = 0;   ///< [1] see spin_imbalance(); largest in the middle between its speeds
  SpinShapes equilibria;  ///< at the verification speeds, and at those that it goes through
};

/// Its number of terms follows from `polynomial_speeds`. If that is 0, it is the first of 1, 2, 4 and 8 that leaves
/// less than `polynomial_tolerance` of the load out of balance, or 8. The polynomial goes through the equilibria at
/// Chebyshev's points of Omega^2 on 0 .. Omega_max; each number of terms keeps the points of the one before.
/// The nearby K must be that at rest. Raises RunError, with the speed, where there is no equilibrium.
SpinShape spin_shape(const SpinProblem& problem, const ReductionParameters& parameters);

/// A sector's M, its shape under spin, and K at any speed. K at rest is assembled at once; spin() and sample() need
/// its factor. The shape under spin of a sector that is given by its matrices isn't known; it is taken to be zero.
class SpinningSector {
 public:
  /// All arguments must outlive the sector.
  SpinningSector(const SectorMesh& mesh, const SectorDofs& dofs, const ReductionParameters& parameters);

  /// Finds the shape under spin; `transform` is that of nodal diameter 0. Returns the speeds at which K is to be
  /// sampled. Raises RunError, with the speed.
  const SpeedSamples& spin(const SectorFactor& factor_at_rest, const CyclicTransformation& transform);
  /// Assembles K at these speeds, and releases the elements' data, which are large.
  void sample();

  const SectorMesh& mesh() const { return mesh_; }
  const SectorDofs& dofs() const { return dofs_; }
  const SymmetricMatrix& mass() const { return mass_; }
  /// Null where matrices are given, and after sample().
  const RotatingElasticity* elasticity() const { return elasticity_ ? &*elasticity_ : nullptr; }
  /// [kg] Of all nodes, the clamped ones included.
  double total_mass() const { return total_mass_; }
  const SpeedSamples& samples() const { return samples_; }
  /// K at the samples, in their order; only the first, at rest, before sample().
  const std::vector<SymmetricMatrix>& sampled_stiffness() const { return stiffness_; }
  /// K at any fraction of Omega_max.
  SymmetricMatrix stiffness(double fraction) const;
  /// The factor of K at a fraction. Raises RunError, with the speed, if the rotor is unstable there.
  SectorFactor factorize(double fraction, const FactorChoice& choice = {}) const;
  /// The shape under spin and what Newton's method took.
  const SpinShape& shape() const { return shape_; }

 private:
  double speed(double fraction) const { return fraction * parameters_.speed_max; }
  SymmetricMatrix assemble_stiffness(double fraction, const Eigen::VectorXd& shape) const;

  const SectorMesh& mesh_;
  const SectorDofs& dofs_;
  const ReductionParameters& parameters_;
  SpeedSamples samples_;
  std::optional<RotatingElasticity> elasticity_;  // until sample() is done; none where matrices are given
  SymmetricMatrix mass_;
  double total_mass_;
  SpinShape shape_;
  std::vector<SymmetricMatrix> stiffness_;
};

}  // namespace tiprub::reduce
