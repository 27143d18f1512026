// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/spinning_sector.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "reduce/matrices/matrix_sector.h"
#include "reduce/operators/speed_samples.h"

namespace tiprub::reduce {

namespace {

constexpr int most_terms = 8;  // 16 would lose K's 33 terms to rounding

class ShapeFit {
 public:
  ShapeFit(const SpinProblem& problem, const ReductionParameters& parameters)
      : problem_(problem), parameters_(parameters) {
    const std::vector<double> verified = speeds_at(parameters.verification_speeds, parameters.speed_max);
    std::set<double> speeds(verified.begin(), verified.end());
    speeds.insert({0.0, parameters.speed_max});
    shape_.equilibria = shapes_under_spin(problem, speeds, parameters.prestress);
  }

  SpinShape run() {
    const bool given = parameters_.polynomial_speeds > 0;
    int terms = given ? parameters_.polynomial_speeds - 1 : 1;
    fit(terms);
    while (!given && shape_.imbalance > parameters_.polynomial_tolerance && terms < most_terms) fit(terms *= 2);
    return std::move(shape_);
  }

 private:
  void fit(int terms) {
    const std::vector<double> speeds = speeds_at(chebyshev_fractions(terms), parameters_.speed_max);
    std::vector<Eigen::VectorXd> shapes;
    for (const double speed : speeds) shapes.push_back(equilibrium(speed));
    shape_.displacement.terms = PolynomialFit(speeds).through(shapes).terms;
    shape_.displacement.terms.erase(shape_.displacement.terms.begin());  // at rest: zero
    shape_.imbalance = imbalance(terms);
  }

  Eigen::VectorXd equilibrium(double speed) {
    SpinShapes& known = shape_.equilibria;
    if (const auto at = known.at.find(speed); at != known.at.end()) return at->second;
    const auto& [below, shape] = *std::prev(known.at.upper_bound(speed));
    const KnownShape from{below, below > 0 ? shape / (below * below) : linear_shape(problem_)};
    const SpinEquilibrium found = climb(problem_, from, speed);
    known.newton_steps = std::max(known.newton_steps, found.iterations);
    known.newton_residual = std::max(known.newton_residual, found.residual);
    return known.at[speed] = found.displacement;
  }

  /// The largest imbalance at the speeds that twice as many terms would add.
  double imbalance(int terms) const {
    double largest = 0;
    const std::vector<double> finer = speeds_at(chebyshev_fractions(2 * terms), parameters_.speed_max);
    for (std::size_t k = 1; k < finer.size(); k += 2)
      largest = std::max(largest, spin_imbalance(problem_, finer[k], shape_.displacement(finer[k])));
    return largest;
  }

  const SpinProblem& problem_;
  const ReductionParameters& parameters_;
  SpinShape shape_;
};

std::optional<RotatingElasticity> elasticity_of(const SectorMesh& mesh, const SectorDofs& dofs,
                                                const ReductionParameters& parameters) {
  if (mesh.matrices != nullptr) return std::nullopt;
  return std::optional<RotatingElasticity>(std::in_place, mesh, dofs, parameters.material, parameters.threads);
}

}  // namespace

SpinShape spin_shape(const SpinProblem& problem, const ReductionParameters& parameters) {
  if (parameters.prestress == Prestress::nonlinear) return ShapeFit(problem, parameters).run();
  return {.displacement = {{linear_shape(problem)}}, .imbalance = 0, .equilibria = {}};
}

SpinningSector::SpinningSector(const SectorMesh& mesh, const SectorDofs& dofs, const ReductionParameters& parameters)
    : mesh_(mesh),
      dofs_(dofs),
      parameters_(parameters),
      samples_(parameters, 1),
      elasticity_(elasticity_of(mesh, dofs, parameters)),
      mass_(elasticity_ ? elasticity_->mass() : on_sector_dofs(mesh.matrices->mass, mesh, dofs)),
      total_mass_(elasticity_ ? elasticity_->total_mass() : mesh.matrices->total_mass()) {
  stiffness_.push_back(assemble_stiffness(0.0, Eigen::VectorXd::Zero(dofs.sector())));
}

const SpeedSamples& SpinningSector::spin(const SectorFactor& factor_at_rest, const CyclicTransformation& transform) {
  if (!elasticity_) {
    shape_ = {.displacement = {{Eigen::VectorXd::Zero(dofs_.sector())}}, .imbalance = 0, .equilibria = {}};
    return samples_;
  }
  const CyclicSolver at_rest = at_speed(0.0, [&] { return CyclicSolver(factor_at_rest, transform); });
  shape_ = spin_shape({*elasticity_, mesh_, at_rest}, parameters_);
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

SectorFactor SpinningSector::factorize(double fraction, const FactorChoice& choice) const {
  return at_speed(speed(fraction), [&] { return SectorFactor(stiffness(fraction), dofs_, choice); });
}

}  // namespace tiprub::reduce
