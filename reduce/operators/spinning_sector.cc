// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/spinning_sector.h"

#include "reduce/operators/at_speed.h"

namespace tiprub {

SpinningSector::SpinningSector(const SectorMesh& mesh, const SectorDofs& dofs, const ReductionParameters& parameters)
    : mesh_(mesh),
      dofs_(dofs),
      parameters_(parameters),
      samples_(parameters, 1),
      elasticity_(std::in_place, mesh, dofs, parameters.material, parameters.threads),
      mass_(elasticity_->mass()) {
  stiffness_.push_back(assemble_stiffness(0.0, Eigen::VectorXd::Zero(dofs.sector())));
}

const SpeedSamples& SpinningSector::spin(const SectorFactor& factor_at_rest, const CyclicTransformation& transform) {
  const CyclicSolver at_rest = at_speed(0.0, [&] { return CyclicSolver(factor_at_rest, transform); });
  shape_ = spin_shape(*elasticity_, mesh_, at_rest, parameters_);
  samples_ = SpeedSamples(parameters_, static_cast<int>(shape_.terms.size()));
  return samples_;
}

void SpinningSector::sample() {
  const std::vector<double>& fractions = samples_.fractions();
  for (std::size_t s = stiffness_.size(); s < fractions.size(); ++s) {
    const bool equilibrium = s >= static_cast<std::size_t>(samples_.polynomial_terms());
    stiffness_.push_back(assemble_stiffness(
        fractions[s], equilibrium ? shape_.equilibria.at.at(speed(fractions[s])) : shape_.at(speed(fractions[s]))));
  }
  elasticity_.reset();
}

SymmetricMatrix SpinningSector::assemble_stiffness(double fraction, const Eigen::VectorXd& shape) const {
  return elasticity_->stiffness(speed(fraction), cartesian_displacement(mesh_, dofs_, shape), parameters_.prestress,
                                parameters_.spin_softening);
}

SymmetricMatrix SpinningSector::stiffness(double fraction) const {
  const Eigen::VectorXd weights = samples_.weights(fraction);
  SymmetricMatrix sum;
  for (Eigen::Index s = 0; s < weights.size(); ++s) {
    if (weights[s] == 0) continue;
    const SymmetricMatrix& sample = stiffness_[s];
    const bool first = sum.size() == 0;
    if (first) sum = sample;
    Eigen::Map<Eigen::VectorXd> values(sum.valuePtr(), sum.nonZeros());
    if (first)
      values *= weights[s];
    else
      values += weights[s] * Eigen::Map<const Eigen::VectorXd>(sample.valuePtr(), sample.nonZeros());
  }
  return sum;
}

SectorFactor SpinningSector::factorize(double fraction) const {
  return at_speed(speed(fraction), [&] { return SectorFactor(stiffness(fraction), dofs_); });
}

}  // namespace tiprub
