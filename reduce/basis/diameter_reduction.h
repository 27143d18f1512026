// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reduce/basis/craig_bampton.h"
#include "reduce/basis/mode_following.h"
#include "reduce/operators/cyclic_solver.h"
#include "reduce/operators/mesh_error.h"
#include "reduce/operators/spinning_sector.h"

namespace tiprub::reduce {

/// The reduction of one nodal diameter: a Craig-Bampton basis from two speeds, rest and Omega_max, its corrections at
/// the speeds between, and the unreduced frequencies that verify it. It holds a dense factor for each of the two
/// speeds, and a Lanczos or Davidson space while it looks for modes.
class DiameterReduction {
 public:
  /// The factors are those of K at rest and at Omega_max. All arguments must outlive the object. Raises RunError,
  /// with the speed, if the rotor is unstable.
  DiameterReduction(const SpinningSector& sector, const SectorFactor& factor_at_rest,
                    const SectorFactor& factor_at_top, const CyclicTransformation& transform,
                    const ReductionParameters& parameters);

  /// Combines the modes and static shapes of both speeds (eq. 8) in one basis (eq. 9). At Omega_max only the span
  /// of the fixed-interface modes is required, and one inverse iteration of the modes at rest gives it.
  CraigBamptonBasis start_basis() const;
  /// Estimates the errors of the modes at speeds between those of the basis. If an error exceeds [reduce]
  /// frequency_tolerance, the missing shapes are added to the basis. Returns their number.
  int correct(CraigBamptonBasis& basis) const;
  /// [Hz] The unreduced sector's lowest frequencies at the verification speeds, followed from the modes of the basis;
  /// n_s x n_f.
  Eigen::MatrixXd unreduced_frequencies(const CraigBamptonBasis& basis) const;
  /// By how much the mesh makes the frequencies at rest too high; as many as `verification_modes`.
  MeshErrorEstimate::Errors frequency_errors(const MeshErrorEstimate& mesh, const CraigBamptonBasis& basis) const;
  /// By how much the mesh makes the compliance at rest of each contact unknown along its normal too small.
  MeshErrorEstimate::Errors compliance_errors(const MeshErrorEstimate& mesh, const ContactUnknowns& contact) const;
  /// The model's K at the samples (eq. 10).
  std::vector<Eigen::MatrixXcd> sampled_stiffness(const CraigBamptonBasis& basis) const;

 private:
  ModeFollowing modes_between(const CraigBamptonBasis& basis, const std::vector<double>& fractions) const;

  const SpinningSector& sector_;
  const ReductionParameters& parameters_;
  CyclicSolver at_rest_;
  CyclicSolver at_top_;
};

}  // namespace tiprub::reduce
