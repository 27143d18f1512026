// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "reduce/operators/sector_factor.h"
#include "reduce/operators/speed_samples.h"
#include "reduce/operators/spin_shape.h"

namespace tiprub {

/// A sector's M, its shape under spin, and K at any speed. First K at rest; with its factor, spin() gives the rest.
/// Of a sector that is given by its matrices the shape under spin isn't known, and zero.
class SpinningSector {
 public:
  /// All arguments must outlive the sector.
  SpinningSector(const SectorMesh& mesh, const SectorDofs& dofs, const ReductionParameters& parameters);

  /// The shape under spin; `transform` is that of nodal diameter 0. Returns at which speeds K is to be sampled.
  /// Raises RunError, with the speed.
  const SpeedSamples& spin(const SectorFactor& factor_at_rest, const CyclicTransformation& transform);
  /// K there, and what assembles it released: it is large.
  void sample();

  const SymmetricMatrix& mass() const { return mass_; }
  const SpeedSamples& samples() const { return samples_; }
  /// K at the samples, in their order; only the first, at rest, before sample().
  const std::vector<SymmetricMatrix>& sampled_stiffness() const { return stiffness_; }
  /// K at any fraction of Omega_max.
  SymmetricMatrix stiffness(double fraction) const;
  /// The factor of K at a fraction. Raises RunError, with the speed, if the rotor is unstable there.
  SectorFactor factorize(double fraction) const;
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
  SpinShape shape_;
  std::vector<SymmetricMatrix> stiffness_;
};

}  // namespace tiprub
