// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/spin_shape.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "reduce/operators/at_speed.h"
#include "reduce/operators/speed_polynomial.h"
#include "reduce/operators/speed_samples.h"

namespace tiprub {

namespace {

const std::vector<int> term_choices = {1, 2, 4, 8};  // 16 would lose K's 33 terms to rounding

class ShapeFit {
 public:
  ShapeFit(const RotatingElasticity& elasticity, const SectorMesh& mesh, const CyclicSolver& at_rest,
           const ReductionParameters& parameters)
      : elasticity_(elasticity), mesh_(mesh), at_rest_(at_rest), parameters_(parameters) {
    std::vector<double> speeds = speeds_at(parameters.verification_speeds, parameters.speed_max);
    speeds.insert(speeds.end(), {0.0, parameters.speed_max});
    shape_.equilibria = shapes_under_spin(elasticity, mesh, at_rest, speeds, parameters.prestress);
    shape_.terms = {shape_.equilibria.at.at(parameters.speed_max) / std::pow(parameters.speed_max, 2)};
  }

  SpinShape run() {
    const bool given = parameters_.polynomial_speeds > 0;
    for (const int terms : given ? std::vector{parameters_.polynomial_speeds - 1} : term_choices) {
      go_through(speeds_at(chebyshev_fractions(terms), parameters_.speed_max));
      shape_.imbalance = imbalance(terms);
      if (shape_.imbalance <= parameters_.polynomial_tolerance) break;
    }
    return std::move(shape_);
  }

 private:
  /// `speeds` from zero.
  void go_through(const std::vector<double>& speeds) {
    std::vector<Eigen::VectorXd> shapes;
    for (const double speed : speeds) shapes.push_back(equilibrium(speed));
    shape_.terms = SpeedPolynomial(speeds).coefficients(shapes);
    shape_.terms.erase(shape_.terms.begin());  // at rest: zero
  }

  Eigen::VectorXd equilibrium(double speed) {
    SpinShapes& known = shape_.equilibria;
    if (const auto at = known.at.find(speed); at != known.at.end()) return at->second;
    const SpinEquilibrium found =
        at_speed(speed, [&] { return spin_equilibrium(elasticity_, mesh_, at_rest_, speed, guess(speed)); });
    known.newton_steps = std::max(known.newton_steps, found.iterations);
    known.newton_residual = std::max(known.newton_residual, found.residual);
    return known.at[speed] = found.displacement;
  }

  /// u / Omega^2 on a line between its neighbours.
  Eigen::VectorXd guess(double speed) const {
    const double square = speed * speed;
    const auto above = shape_.equilibria.at.upper_bound(speed), below = std::prev(above);
    const double top = above->first * above->first, bottom = below->first * below->first;
    if (bottom == 0) return square / top * above->second;
    const double share = (square - bottom) / (top - bottom);
    return square * ((1 - share) / bottom * below->second + share / top * above->second);
  }

  /// Where a finer choice would have its new speeds.
  double imbalance(int terms) const {
    double largest = 0;
    const std::vector<double> finer = speeds_at(chebyshev_fractions(2 * terms), parameters_.speed_max);
    for (std::size_t k = 1; k < finer.size(); k += 2)
      largest = std::max(largest, spin_imbalance(elasticity_, mesh_, at_rest_, finer[k], shape_.at(finer[k])));
    return largest;
  }

  const RotatingElasticity& elasticity_;
  const SectorMesh& mesh_;
  const CyclicSolver& at_rest_;
  const ReductionParameters& parameters_;
  SpinShape shape_;
};

}  // namespace

Eigen::VectorXd SpinShape::at(double speed) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(terms.front().size());
  double power = 1;
  for (const Eigen::VectorXd& term : terms) sum += (power *= speed * speed) * term;
  return sum;
}

SpinShape spin_shape(const RotatingElasticity& elasticity, const SectorMesh& mesh, const CyclicSolver& at_rest,
                     const ReductionParameters& parameters) {
  if (parameters.prestress == Prestress::nonlinear) return ShapeFit(elasticity, mesh, at_rest, parameters).run();
  return {.terms = {linear_shape(elasticity, at_rest)}, .imbalance = 0, .equilibria = {}};
}

}  // namespace tiprub
