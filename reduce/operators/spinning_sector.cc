// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/spinning_sector.h"

#include <utility>

#include "reduce/operators/at_speed.h"
#include "reduce/operators/speed_polynomial.h"

namespace tiprub {

SpinningSector::SpinningSector(const SectorMesh& mesh, const SectorDofs& dofs, const ReductionParameters& parameters,
                               const SpeedSamples& samples)
    : mesh_(mesh),
      dofs_(dofs),
      parameters_(parameters),
      samples_(samples),
      elasticity_(std::in_place, mesh, dofs, parameters.material, parameters.threads),
      mass_(elasticity_->mass()) {
  shapes_.at[0.0] = Eigen::VectorXd::Zero(dofs.sector());
  stiffness_.push_back(assemble_stiffness(0.0));
}

void SpinningSector::spin(const SectorFactor& factor_at_rest, const CyclicTransformation& transform) {
  const std::vector<double> speeds = speeds_at(samples_.fractions(), parameters_.speed_max);
  const CyclicSolver at_rest = at_speed(0.0, [&] { return CyclicSolver(factor_at_rest, transform); });
  shapes_ = shapes_under_spin(*elasticity_, mesh_, at_rest, speeds, parameters_.prestress);
  for (std::size_t s = 1; s < speeds.size(); ++s) stiffness_.push_back(assemble_stiffness(samples_.fractions()[s]));
  elasticity_.reset();
}

SymmetricMatrix SpinningSector::assemble_stiffness(double fraction) const {
  const Eigen::Matrix3Xd shape = cartesian_displacement(mesh_, dofs_, shapes_.at.at(speed(fraction)));
  return elasticity_->stiffness(speed(fraction), shape, parameters_.prestress, parameters_.spin_softening);
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

SectorFactor SpinningSector::factorize(std::size_t sample) const {
  return at_speed(speed(samples_.fractions()[sample]), [&] { return SectorFactor(stiffness_[sample], dofs_); });
}

std::array<Eigen::VectorXcd, 2> SpinningSector::static_shift() const {
  const Eigen::VectorXcd full = shapes_.at.at(speed(1.0)).cast<std::complex<double>>();
  if (parameters_.prestress != Prestress::nonlinear)
    return {full / (speed(1.0) * speed(1.0)), Eigen::VectorXcd::Zero(full.size())};
  const Eigen::VectorXcd half = shapes_.at.at(speed(0.5)).cast<std::complex<double>>();
  const auto terms = SpeedPolynomial({0.0, speed(0.5), speed(1.0)}).coefficients({0 * full, half, full});
  return {terms[1], terms[2]};
}

}  // namespace tiprub
