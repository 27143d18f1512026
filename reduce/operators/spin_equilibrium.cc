// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/spin_equilibrium.h"

#include <algorithm>
#include <cmath>

#include "cases/program/errors.h"
#include "cases/program/text.h"
#include "reduce/operators/speed_samples.h"

namespace tiprub::reduce {

namespace {

constexpr double tolerance = 1e-10;        // of a residual, in the energy norm of the load
constexpr int most_newton_steps = 30;      // some 5 are usual
constexpr int most_halvings = 10;          // of one step
constexpr int most_gradient_steps = 400;   // some 10 are usual
constexpr double coarsest_solution = 0.1;  // of a linear step, relative

/// Equations of one speed on the independent dofs of nodal diameter 0, which are real.
class Balance {
 public:
  Balance(const SpinProblem& problem, double speed) : problem_(problem), speed_(speed) {}

  /// r = f - f_int at a shape.
  Eigen::VectorXd residual(const Eigen::VectorXd& shape) const {
    const Eigen::Matrix3Xd moved = displacement(shape);
    return gather(speed_ * speed_ * problem_.elasticity.centrifugal_load(moved) -
                  problem_.elasticity.internal_force(moved));
  }
  SymmetricMatrix tangent(const Eigen::VectorXd& shape) const {
    return problem_.elasticity.stiffness(speed_, displacement(shape), Prestress::nonlinear);
  }
  /// K_nearby^-1 r.
  Eigen::VectorXd precondition(const Eigen::VectorXd& force) const {
    return problem_.nearby.solve(force.cast<std::complex<double>>(), ContactNodes::free).real();
  }
  double norm(const Eigen::VectorXd& force) const { return std::sqrt(force.dot(precondition(force))); }
  double load_norm() const { return norm(gather(speed_ * speed_ * problem_.elasticity.centrifugal_load())); }
  /// K_T du = r by preconditioned conjugate gradients, to a relative residual.
  Eigen::VectorXd solve(const SymmetricMatrix& tangent, const Eigen::VectorXd& force, double accuracy) const;

 private:
  Eigen::Matrix3Xd displacement(const Eigen::VectorXd& shape) const {
    return cartesian_displacement(problem_.mesh, problem_.nearby.transform().dofs(), shape);
  }
  Eigen::VectorXd gather(const Eigen::VectorXd& sector) const {
    return problem_.nearby.transform().gather(sector.cast<std::complex<double>>()).real();
  }

  const SpinProblem& problem_;
  double speed_;
};

Eigen::VectorXd Balance::solve(const SymmetricMatrix& tangent, const Eigen::VectorXd& force, double accuracy) const {
  Eigen::VectorXd step = Eigen::VectorXd::Zero(force.size()), left = force, z = precondition(left), direction = z;
  const double first = left.dot(z);
  double now = first;
  for (int k = 0; k < most_gradient_steps; ++k) {
    const Eigen::VectorXd pushed =
        problem_.nearby.transform().apply(tangent, direction.cast<std::complex<double>>()).real();
    const double curvature = direction.dot(pushed);
    if (!(curvature > 0)) throw RunError("the loaded shape is not stable: its stiffness is not positive definite");
    step += now / curvature * direction;
    left -= now / curvature * pushed;
    z = precondition(left);
    const double next = left.dot(z);
    if (next <= accuracy * accuracy * first) return step;
    direction = z + next / now * direction;
    now = next;
  }
  throw RunError(
      "the stiffness of the loaded shape is too far from that at rest: conjugate gradients don't converge");
}

}  // namespace

SpinEquilibrium spin_equilibrium(const SpinProblem& problem, double speed, const Eigen::VectorXd& guess) {
  SpinEquilibrium found{guess};
  if (speed == 0.0) return {Eigen::VectorXd::Zero(guess.size())};
  const Balance balance(problem, speed);
  const double scale = balance.load_norm();
  Eigen::VectorXd force = balance.residual(found.displacement);
  found.residual = balance.norm(force) / scale;
  while (found.residual > tolerance) {
    if (++found.iterations > most_newton_steps) break;
    // The linear step needs no more accuracy than Newton's next step will have.
    const double accuracy = std::min(coarsest_solution, found.residual);
    const Eigen::VectorXcd step =
        balance.solve(balance.tangent(found.displacement), force, accuracy).cast<std::complex<double>>();
    const Eigen::VectorXd whole = problem.nearby.transform().expand(step).real();
    double fraction = 1.0, residual = 0.0;
    Eigen::VectorXd shape;
    for (int halving = 0; halving <= most_halvings; ++halving, fraction /= 2) {
      shape = found.displacement + fraction * whole;
      force = balance.residual(shape);
      residual = balance.norm(force) / scale;
      if (residual < found.residual) break;
    }
    if (!(residual < found.residual)) break;
    found.displacement = shape;
    found.residual = residual;
  }
  if (found.residual <= tolerance) return found;
  throw RunError(text_of("the shape under spin doesn't converge: after ", found.iterations, " Newton steps ",
                         found.residual, " of the load is left, more than ", tolerance,
                         "; lower speed_max_rpm, or take prestress = \"linear\""));
}

double spin_imbalance(const SpinProblem& problem, double speed, const Eigen::VectorXd& shape) {
  const Balance balance(problem, speed);
  return balance.norm(balance.residual(shape)) / balance.load_norm();
}

SpinEquilibrium climb(const SpinProblem& problem, const KnownShape& from, double speed, int halvings) {
  const double square = speed * speed;
  try {
    return at_speed(speed, [&] { return spin_equilibrium(problem, speed, square * from.over_square); });
  } catch (const RunError&) {
    if (halvings == 0) throw;
  }
  const double between = std::sqrt((from.speed * from.speed + square) / 2);
  const SpinEquilibrium half = climb(problem, from, between, halvings - 1);
  SpinEquilibrium found = climb(problem, {between, half.displacement / (between * between)}, speed, halvings - 1);
  found.iterations = std::max(found.iterations, half.iterations);
  return found;
}

Eigen::VectorXd linear_shape(const SpinProblem& problem) {
  const Eigen::VectorXcd load = problem.elasticity.centrifugal_load().cast<std::complex<double>>();
  const CyclicTransformation& transform = problem.nearby.transform();
  return transform.expand(problem.nearby.solve(transform.gather(load), ContactNodes::free)).real();
}

SpinShapes shapes_under_spin(const SpinProblem& problem, const std::set<double>& speeds, Prestress prestress) {
  KnownShape known{0.0, linear_shape(problem)};
  SpinShapes shapes;
  for (const double speed : speeds) {
    const double square = speed * speed;
    shapes.at[speed] = square * known.over_square;
    if (prestress != Prestress::nonlinear || speed == 0.0) continue;
    SpinEquilibrium found = climb(problem, known, speed);
    shapes.newton_steps = std::max(shapes.newton_steps, found.iterations);
    shapes.newton_residual = std::max(shapes.newton_residual, found.residual);
    known = {speed, found.displacement / square};
    shapes.at[speed] = std::move(found.displacement);
  }
  return shapes;
}

}  // namespace tiprub::reduce
