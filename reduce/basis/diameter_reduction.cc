// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/basis/diameter_reduction.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reduce/basis/cyclic_modes.h"
#include "reduce/model/dense_eigen.h"
#include "reduce/operators/speed_samples.h"

namespace tiprub::reduce {

namespace {

// The residual of 1/omega^2. The error of a frequency is proportional to its square, and the basis requires only
// the span of the modes.
constexpr double mode_tolerance = 1e-2;
// The fraction of Omega_max below which K, which changes with Omega^2, is nearer to K at rest than to K at full
// speed.
constexpr double nearer_to_rest = 0.7;
constexpr int most_rounds = 10;        // of corrections
constexpr double squared_away = 1e-3;  // error of omega^2 of which one round leaves about the square

}  // namespace

DiameterReduction::DiameterReduction(const SpinningSector& sector, const SectorFactor& factor_at_rest,
                                     const SectorFactor& factor_at_top, const CyclicTransformation& transform,
                                     const ReductionParameters& parameters)
    : sector_(sector),
      parameters_(parameters),
      at_rest_(at_speed(0.0, [&] { return CyclicSolver(factor_at_rest, transform); })),
      at_top_(at_speed(parameters.speed_max, [&] { return CyclicSolver(factor_at_top, transform); })) {}

CraigBamptonBasis DiameterReduction::start_basis() const {
  const CyclicTransformation& transform = at_rest_.transform();
  const SymmetricMatrix& mass = sector_.mass();
  // eq. 8: Psi_co(0), the fixed-interface modes at rest
  const Eigen::MatrixXcd modes = at_speed(0.0, [&] {
    return lowest_modes(at_rest_, mass, ContactNodes::fixed, parameters_.fixed_interface_modes, mode_tolerance).shape;
  });
  std::vector<const SymmetricMatrix*> samples;
  for (const SymmetricMatrix& sample : sector_.sampled_stiffness()) samples.push_back(&sample);
  // eq. 8: Psi_s(0), the constraint modes at rest
  const Eigen::MatrixXcd constraint_modes = at_rest_.constraint_modes();
  // eq. 9: the constraint modes as they are, all else orthonormal
  CraigBamptonBasis basis(transform, mass, samples, constraint_modes);
  basis.append(modes);
  basis.append(at_top_.solve(transform.apply(mass, modes), ContactNodes::fixed));  // span of Psi_co(Omega_max)
  basis.append(at_top_.constraint_modes() - constraint_modes);                     // Psi_s(Omega_max) - Psi_s(0)
  basis.orthonormalise();
  return basis;
}

int DiameterReduction::correct(CraigBamptonBasis& basis) const {
  // The tolerance is applied to omega^2, whose error is twice that of omega: half of it is left for the error of the
  // estimate.
  const double tolerance = parameters_.frequency_tolerance;
  int added = 0;
  for (int round = 0; round < most_rounds; ++round) {
    ModeFollowing modes = modes_between(basis, {corrected_speeds.begin(), corrected_speeds.end()});
    if (!modes.correct(tolerance)) break;
    basis.append(modes.corrections());
    basis.orthonormalise();
    added += static_cast<int>(modes.corrections().cols());
    double largest = 0;
    for (const FollowedModes& at_speed : modes.modes()) largest = std::max(largest, at_speed.error.maxCoeff());
    if (largest <= std::max(std::sqrt(tolerance), squared_away)) break;
  }
  return added;
}

Eigen::MatrixXd DiameterReduction::unreduced_frequencies(const CraigBamptonBasis& basis) const {
  const std::vector<double>& fractions = parameters_.verification_speeds;
  Eigen::MatrixXd table(static_cast<Eigen::Index>(fractions.size()), parameters_.verification_modes);
  ModeFollowing following = modes_between(basis, fractions);
  following.converge(parameters_.verification_tolerance);
  Eigen::Index row = 0;
  for (const FollowedModes& modes : following.modes()) table.row(row++) = modes.frequencies().transpose();
  return table;
}

MeshErrorEstimate::Errors DiameterReduction::frequency_errors(const MeshErrorEstimate& mesh,
                                                              const CraigBamptonBasis& basis) const {
  const auto [squares, vectors] = eigenpairs(basis.stiffness(0), basis.mass());
  const int count = parameters_.verification_modes;
  return mesh.of_frequencies(at_rest_, squares.head(count), basis.combine(vectors.leftCols(count)));
}

MeshErrorEstimate::Errors DiameterReduction::compliance_errors(const MeshErrorEstimate& mesh,
                                                               const ContactUnknowns& contact) const {
  return mesh.of_compliances(at_rest_, contact);
}

std::vector<Eigen::MatrixXcd> DiameterReduction::sampled_stiffness(const CraigBamptonBasis& basis) const {
  std::vector<Eigen::MatrixXcd> stiffness;
  for (std::size_t s = 0; s < sector_.sampled_stiffness().size(); ++s) stiffness.push_back(basis.stiffness(s));
  return stiffness;
}

ModeFollowing DiameterReduction::modes_between(const CraigBamptonBasis& basis,
                                               const std::vector<double>& fractions) const {
  const std::vector<Eigen::MatrixXcd> samples = sampled_stiffness(basis);
  std::vector<SpeedToFollow> speeds;
  for (const double fraction : fractions)
    speeds.push_back({name_of_speed(fraction * parameters_.speed_max), sector_.samples().weights(fraction),
                      sector_.samples().combine(samples, fraction),
                      fraction < nearer_to_rest ? &at_rest_ : &at_top_});
  return {basis, sector_.mass(), sector_.sampled_stiffness(), std::move(speeds), parameters_.verification_modes};
}

}  // namespace tiprub::reduce
