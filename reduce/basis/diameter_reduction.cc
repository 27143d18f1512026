// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/basis/diameter_reduction.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cases/program/errors.h"
#include "cases/program/text.h"
#include "reduce/basis/craig_bampton.h"
#include "reduce/basis/cyclic_modes.h"
#include "reduce/basis/mode_following.h"
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

class DiameterReduction {
 public:
  DiameterReduction(const SharedByDiameters& shared, const CyclicTransformation& transform)
      : shared_(shared),
        sector_(shared.sector),
        parameters_(shared.parameters),
        at_rest_(at_speed(0.0, [&] { return CyclicSolver(shared.at_rest, transform); })),
        at_top_(at_speed(parameters_.speed_max, [&] { return CyclicSolver(shared.at_top, transform); })) {}

  /// Combines the modes and static shapes of both speeds (eq. 8) in one basis (eq. 9). At Omega_max only the span
  /// of the fixed-interface modes is required, and one inverse iteration of the modes at rest gives it.
  CraigBamptonBasis start_basis() const;
  /// Estimates the errors of the modes at speeds between those of the basis. If an error exceeds [reduce]
  /// frequency_tolerance, the missing shapes are added to the basis. Returns their number.
  int correct(CraigBamptonBasis& basis) const;
  /// Followed from the modes of the basis; n_s x n_f.
  Eigen::MatrixXd unreduced_frequencies(const CraigBamptonBasis& basis) const;
  void estimate_mesh_errors(const CraigBamptonBasis& basis, int nodal_diameter, DiameterResult& result) const;
  /// The model's K at the samples (eq. 10).
  std::vector<Eigen::MatrixXcd> sampled_stiffness(const CraigBamptonBasis& basis) const;

 private:
  ModeFollowing modes_between(const CraigBamptonBasis& basis, const std::vector<double>& fractions) const;

  const SharedByDiameters& shared_;
  const SpinningSector& sector_;
  const ReductionParameters& parameters_;
  CyclicSolver at_rest_;
  CyclicSolver at_top_;
};

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

void DiameterReduction::estimate_mesh_errors(const CraigBamptonBasis& basis, int nodal_diameter,
                                             DiameterResult& result) const {
  const MeshErrorEstimate& mesh = *shared_.mesh_error;
  const auto [squares, vectors] = eigenpairs(basis.stiffness(0), basis.mass());
  const int count = parameters_.verification_modes;
  MeshErrorEstimate::Errors frequency =
      mesh.of_frequencies(at_rest_, squares.head(count), basis.combine(vectors.leftCols(count)));
  MeshErrorEstimate::Errors compliance;
  if (nodal_diameter == 0) compliance = mesh.of_compliances(at_rest_, shared_.contact);
  result.frequency_errors = std::move(frequency.of_each);
  result.compliance_errors = std::move(compliance.of_each);
  if (!shared_.with_fields) return;
  result.frequency_cells = std::move(frequency.of_cells);
  result.compliance_cells = std::move(compliance.of_cells);
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

void require_enough_modes(const ReductionParameters& parameters, int nodal_diameter, Eigen::Index dofs) {
  if (dofs >= parameters.verification_modes) return;
  throw InputError(text_of("[reduce] verification_modes = ", parameters.verification_modes, " is more than the ",
                           dofs, " dofs of the model at nodal diameter ", nodal_diameter,
                           "; ask for fewer, or raise fixed_interface_modes"));
}

}  // namespace

DiameterResult reduce_diameter(const SharedByDiameters& shared, const CyclicTransformation& transform,
                               int nodal_diameter, Progress& progress) {
  const DiameterReduction diameter(shared, transform);
  DiameterResult result;
  CraigBamptonBasis basis = diameter.start_basis();  // eq. 8, eq. 9
  progress.advance();
  require_enough_modes(shared.parameters, nodal_diameter, basis.size());
  result.corrections = diameter.correct(basis);
  progress.advance();
  result.generalized_dofs = static_cast<int>(basis.size() - basis.contact_dofs());
  result.dropped = basis.dropped();
  result.stiffness = diameter.sampled_stiffness(basis);
  result.mass = basis.mass();
  result.unreduced = diameter.unreduced_frequencies(basis);
  if (shared.mesh_error != nullptr) diameter.estimate_mesh_errors(basis, nodal_diameter, result);
  progress.advance();
  if (shared.with_fields) result.shapes = basis.shapes();
  return result;
}

}  // namespace tiprub::reduce
