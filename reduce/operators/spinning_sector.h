// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "reduce/operators/sector_factor.h"
#include "reduce/operators/speed_samples.h"
#include "reduce/operators/spin_equilibrium.h"

namespace tiprub {

/// A sector's M, its shape under spin, and K at any speed. First K at rest; with its factor, spin() gives the rest.
class SpinningSector {
 public:
  /// All arguments must outlive the sector.
  SpinningSector(const SectorMesh& mesh, const SectorDofs& dofs, const ReductionParameters& parameters,
                 const SpeedSamples& samples);

  /// The shape at every sample, K there, and what assembles them released: it is large. `transform`
  /// is that of nodal diameter 0. Raises RunError, with the speed.
  void spin(const SectorFactor& factor_at_rest, const CyclicTransformation& transform);

  const SymmetricMatrix& mass() const { return mass_; }
  /// K at the samples, in their order; only the first, at rest, before spin().
  const std::vector<SymmetricMatrix>& sampled_stiffness() const { return stiffness_; }
  /// K at any fraction of Omega_max.
  SymmetricMatrix stiffness(double fraction) const;
  /// The factor of K at a sample. Raises RunError, with the speed, if the rotor is unstable there.
  SectorFactor factorize(std::size_t sample) const;
  /// s_1, s_2 [m s^2, m s^4] of the shape Omega^2 s_1 + Omega^4 s_2 through Omega_max/2 and Omega_max; s_2 is zero
  /// unless prestress is nonlinear.
  std::array<Eigen::VectorXcd, 2> static_shift() const;
  /// The shapes under spin and what Newton's method took.
  const SpinShapes& shapes() const { return shapes_; }

 private:
  double speed(double fraction) const { return fraction * parameters_.speed_max; }
  SymmetricMatrix assemble_stiffness(double fraction) const;

  const SectorMesh& mesh_;
  const SectorDofs& dofs_;
  const ReductionParameters& parameters_;
  const SpeedSamples& samples_;
  std::optional<RotatingElasticity> elasticity_;  // until spin() is done
  SymmetricMatrix mass_;
  SpinShapes shapes_;
  std::vector<SymmetricMatrix> stiffness_;
};

}  // namespace tiprub
