// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/spin_shape.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "reduce/operators/polynomial_fit.h"
#include "reduce/operators/speed_samples.h"

namespace tiprub {

namespace {

constexpr int most_terms = 8;  // 16 would lose K's 33 terms to rounding

class ShapeFit {
 public:
  ShapeFit(const RotatingElasticity& elasticity, const SectorMesh& mesh, const CyclicSolver& at_rest,
           const ReductionParameters& parameters)
      : elasticity_(elasticity), mesh_(mesh), at_rest_(at_rest), parameters_(parameters) {
    std::vector<double> speeds = speeds_at(parameters.verification_speeds, parameters.speed_max);
    speeds.insert(speeds.end(), {0.0, parameters.speed_max});
    shape_.equilibria = shapes_under_spin(elasticity, mesh, at_rest, speeds, parameters.prestress);
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
    const KnownShape from{below, below > 0 ? shape / (below * below) : linear_shape(elasticity_, at_rest_)};
    const SpinEquilibrium found = climb(elasticity_, mesh_, at_rest_, from, speed);
    known.newton_steps = std::max(known.newton_steps, found.iterations);
    known.newton_residual = std::max(known.newton_residual, found.residual);
    return known.at[speed] = found.displacement;
  }

  /// Where twice as many terms would have their new speeds.
  double imbalance(int terms) const {
    double largest = 0;
    const std::vector<double> finer = speeds_at(chebyshev_fractions(2 * terms), parameters_.speed_max);
    for (std::size_t k = 1; k < finer.size(); k += 2)
      largest =
          std::max(largest, spin_imbalance(elasticity_, mesh_, at_rest_, finer[k], shape_.displacement(finer[k])));
    return largest;
  }

  const RotatingElasticity& elasticity_;
  const SectorMesh& mesh_;
  const CyclicSolver& at_rest_;
  const ReductionParameters& parameters_;
  SpinShape shape_;
};

}  // namespace

SpinShape spin_shape(const RotatingElasticity& elasticity, const SectorMesh& mesh, const CyclicSolver& at_rest,
                     const ReductionParameters& parameters) {
  if (parameters.prestress == Prestress::nonlinear) return ShapeFit(elasticity, mesh, at_rest, parameters).run();
  return {.displacement = {{linear_shape(elasticity, at_rest)}}, .imbalance = 0, .equilibria = {}};
}

}  // namespace tiprub
