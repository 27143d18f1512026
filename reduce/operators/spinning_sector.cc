// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/spinning_sector.h"

#include <algorithm>

#include "reduce/matrices/matrix_sector.h"
#include "reduce/operators/at_speed.h"

namespace tiprub {

namespace {

std::optional<RotatingElasticity> elasticity_of(const SectorMesh& mesh, const SectorDofs& dofs,
                                                const ReductionParameters& parameters) {
  if (mesh.matrices != nullptr) return std::nullopt;
  return std::optional<RotatingElasticity>(std::in_place, mesh, dofs, parameters.material, parameters.threads);
}

}  // namespace

SpinningSector::SpinningSector(const SectorMesh& mesh, const SectorDofs& dofs, const ReductionParameters& parameters)
    : mesh_(mesh),
      dofs_(dofs),
      parameters_(parameters),
      samples_(parameters, 1),
      elasticity_(elasticity_of(mesh, dofs, parameters)),
      mass_(elasticity_ ? elasticity_->mass() : on_sector_dofs(mesh.matrices->mass, mesh, dofs)) {
  stiffness_.push_back(assemble_stiffness(0.0, Eigen::VectorXd::Zero(dofs.sector())));
}

const SpeedSamples& SpinningSector::spin(const SectorFactor& factor_at_rest, const CyclicTransformation& transform) {
  if (!elasticity_) {
    shape_ = {.displacement = {{Eigen::VectorXd::Zero(dofs_.sector())}}, .imbalance = 0, .equilibria = {}};
    return samples_;
  }
  const CyclicSolver at_rest = at_speed(0.0, [&] { return CyclicSolver(factor_at_rest, transform); });
  shape_ = spin_shape(*elasticity_, mesh_, at_rest, parameters_);
  samples_ = SpeedSamples(parameters_, static_cast<int>(shape_.displacement.terms.size()));
  return samples_;
}

void SpinningSector::sample() {
  const std::vector<double>& fractions = samples_.fractions();
  for (std::size_t s = stiffness_.size(); s < fractions.size(); ++s) {
    const bool equilibrium = s >= static_cast<std::size_t>(samples_.polynomial_terms());
    stiffness_.push_back(assemble_stiffness(fractions[s], equilibrium ? shape_.equilibria.at.at(speed(fractions[s]))
                                                                      : shape_.displacement(speed(fractions[s]))));
  }
  elasticity_.reset();
}

SymmetricMatrix SpinningSector::assemble_stiffness(double fraction, const Eigen::VectorXd& shape) const {
  if (!elasticity_) return on_sector_dofs(stiffness_at(*mesh_.matrices, speed(fraction)), mesh_, dofs_);
  return elasticity_->stiffness(speed(fraction), cartesian_displacement(mesh_, dofs_, shape), parameters_.prestress,
                                parameters_.spin_softening);
}

SymmetricMatrix SpinningSector::stiffness(double fraction) const {
  const Eigen::VectorXd weights = samples_.weights(fraction);
  SymmetricMatrix sum = stiffness_.front();
  constexpr Eigen::Index at_once = 4096;  // in the cache, while the samples pass
  for (Eigen::Index first = 0; first < sum.nonZeros(); first += at_once) {
    const Eigen::Index count = std::min(at_once, sum.nonZeros() - first);
    Eigen::Map<Eigen::VectorXd> values(sum.valuePtr() + first, count);
    values *= weights[0];
    for (Eigen::Index s = 1; s < weights.size(); ++s)
      if (weights[s] != 0)
        values += weights[s] * Eigen::Map<const Eigen::VectorXd>(stiffness_[s].valuePtr() + first, count);
  }
  return sum;
}

SectorFactor SpinningSector::factorize(double fraction) const {
  return at_speed(speed(fraction), [&] { return SectorFactor(stiffness(fraction), dofs_); });
}

}  // namespace tiprub
