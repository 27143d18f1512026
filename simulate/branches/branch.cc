// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/branches/branch.h"

#include <LOCA_GlobalData.H>
#include <LOCA_MultiContinuation_ExtendedVector.H>
#include <LOCA_Stepper.H>
#include <NOX_Solver_Generic.H>
#include <NOX_StatusTest_Combo.H>
#include <NOX_StatusTest_MaxIters.H>
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <future>
#include <string>
#include <vector>

#include "simulate/branches/orbit_family.h"
#include "simulate/motion/attempt.h"
#include "simulate/periodic/multipliers.h"
#include "simulate/periodic/orbit_group.h"

namespace tiprub::simulate {

namespace {

constexpr double residual = 1e-8;      // of the state's size: |F(x) - x|
constexpr int newton_iterations = 10;  // of a step that is not shortened
constexpr double linear_tolerance = 1e-3;
constexpr double longest_step = 8;  // first steps
constexpr double shortest_step = 1e-4;
constexpr double correction = 0.2;       // of a step, at most
constexpr double kink = 0.01;            // of the state: a shorter correction is never refused
constexpr double at_bound = 1e-9;        // of the speed
constexpr double there_and_back = 1e-5;  // of the speed, between two folds

Teuchos::RCP<Teuchos::ParameterList> settings(double speed, const BranchLimits& limits) {
  auto list = Teuchos::parameterList();
  Teuchos::ParameterList& loca = list->sublist("LOCA");
  loca.sublist("Predictor").set("Method", "Secant");
  loca.sublist("Predictor").sublist("First Step Predictor").set("Method", "Constant");
  Teuchos::ParameterList& stepper = loca.sublist("Stepper");
  stepper.set("Continuation Method", "Arc Length");
  stepper.set("Continuation Parameter", OrbitGroup::parameter);
  stepper.set("Initial Value", speed);
  stepper.set("Max Value", limits.speed_max);
  stepper.set("Min Value", limits.speed_min);
  stepper.set("Max Steps", limits.steps);
  stepper.set("Max Nonlinear Iterations", newton_iterations);
  stepper.set("Compute Eigenvalues", false);
  stepper.set("Bordered Solver Method", "Bordering");
  Teuchos::ParameterList& step = loca.sublist("Step Size");
  const double first = limits.first_step * speed;
  step.set("Method", "Adaptive");
  step.set("Initial Step Size", first);
  step.set("Max Step Size", longest_step * std::abs(first));
  step.set("Min Step Size", shortest_step * std::abs(first));
  Teuchos::ParameterList& nox = list->sublist("NOX");
  be_quiet(nox.sublist("Printing"));
  nox.sublist("Direction").set("Method", "Newton");
  nox.sublist("Direction").sublist("Newton").sublist("Linear Solver").set("Tolerance", linear_tolerance);
  nox.sublist("Line Search").set("Method", "Full Step");
  return list;
}

/// One orbit.
struct Point {
  double speed;           ///< [rad/s]
  Eigen::VectorXd state;  ///< of the family
};

/// The orbit's state, without the speed.
Eigen::Map<const Eigen::VectorXd> state_of(const NOX::Solver::Generic& solver) {
  const NOX::Abstract::Vector& whole = solver.getSolutionGroup().getX();
  const auto* extended = dynamic_cast<const LOCA::MultiContinuation::ExtendedVector*>(&whole);
  return numbers(extended ? *extended->getXVec() : whole);
}

/// Whether the residual is small against the state, which may grow a hundredfold along a branch.
bool has_small_residual(const NOX::Solver::Generic& solver) {
  const NOX::Abstract::Group& now = solver.getSolutionGroup();
  return now.isF() && now.getNormF() <= residual * state_of(solver).norm();
}

/// Ends an iteration at a small residual: with a failure if the orbit is far from the predicted one, for the step
/// that was made, because other branches pass nearby, and Newton's method may end on one of them. A kink of the
/// branch is passed with short steps. Refers to the points.
Teuchos::RCP<NOX::StatusTest::Generic> test_after(const std::vector<Point>& points) {
  const auto leaves_branch = [&points, predicted = Eigen::VectorXd()](const NOX::Solver::Generic& solver) mutable {
    const auto state = state_of(solver);
    if (solver.getNumIterations() == 0) predicted = state;
    if (points.empty() || !has_small_residual(solver)) return false;
    const Eigen::VectorXd& before = points.back().state;
    return (state - predicted).norm() > std::max(correction * (state - before).norm(), kink * before.norm());
  };
  auto any = Teuchos::rcp(new NOX::StatusTest::Combo(NOX::StatusTest::Combo::OR));
  any->addStatusTest(Teuchos::rcp(new StopsWhen(leaves_branch, NOX::StatusTest::Failed)));
  any->addStatusTest(Teuchos::rcp(new StopsWhen(has_small_residual)));
  any->addStatusTest(Teuchos::rcp(new NOX::StatusTest::MaxIters(newton_iterations)));
  return any;
}

/// One side of a branch, from its start.
struct Side {
  std::vector<Point> points;
  std::string end;
  Eigen::ArrayXXd measured;  ///< amplitude, multiplier, its uncertainty and angle; 4 x points
};

/// `failure`: why no more motions could be computed; empty if they could.
std::string reason_of_end(const std::vector<Point>& points, const BranchLimits& limits, const std::string& failure) {
  const double last = points.back().speed;
  if (last <= limits.speed_min * (1 + at_bound) || last >= limits.speed_max * (1 - at_bound))
    return "end of the range";
  if (static_cast<int>(points.size()) > limits.steps) return "most steps";
  return failure.empty() ? "no orbit within the shortest step" : failure;
}

/// Amplitude, multiplier, its uncertainty and angle.
Eigen::Array4d measure(OrbitFamily& family, const Point& point) {
  const std::shared_ptr<PeriodicMap> map = family.at(point.speed);
  const MapImage image = map->image(point.state);
  const Multiplier largest =
      largest_multiplier([&](const Eigen::VectorXd& change) { return map->tangent(image.pattern, change); },
                         point.state.size(), {.start = map->seed()});
  const Growth growth = per_revolution(largest, family.maps_per_revolution());
  return {family.amplitude(point.speed, point.state), growth.factor, growth.uncertainty,
          std::abs(std::arg(largest.value))};
}

Side follow_side(const Scene& scene, double speed, int steps_per_revolution, const Eigen::VectorXd& start,
                 BranchLimits limits) {
  OrbitFamily family(scene, speed, steps_per_revolution);
  const auto list = settings(speed, limits);
  const auto global = LOCA::createGlobalData(list);
  const Eigen::VectorXd state = family.of_family(speed, start);
  Side side;
  const auto group = Teuchos::rcp(new OrbitGroup(
      global, [&](double at) { return family.at(at); }, speed, state));
  group->call_at_solutions([&](double at, const Eigen::VectorXd& found) { side.points.push_back({at, found}); });
  LOCA::Stepper stepper(global, group, test_after(side.points), list);
  std::string failure;
  try {
    stepper.run();
  } catch (const NoMotion& error) {  // the rotor is unstable or the clearance is closed
    failure = error.what();
  } catch (const char*) {  // an error of LOCA
  }
  LOCA::destroyGlobalData(global);
  // LOCA steps beyond the range and then returns to its bound.
  std::erase_if(side.points, [&](const Point& point) {
    return point.speed < limits.speed_min * (1 - at_bound) || point.speed > limits.speed_max * (1 + at_bound);
  });
  if (side.points.empty()) throw NoMotion("no orbit near the start");
  const auto repeated = std::unique(side.points.begin(), side.points.end(), [](const Point& one, const Point& other) {
    return std::abs(one.speed - other.speed) <= at_bound * one.speed;
  });
  side.points.erase(repeated, side.points.end());
  side.end = reason_of_end(side.points, limits, failure);
  side.measured.resize(4, static_cast<Eigen::Index>(side.points.size()));
  for (std::size_t i = 0; i < side.points.size(); ++i)
    side.measured.col(static_cast<Eigen::Index>(i)) = measure(family, side.points[i]);
  return side;
}

/// [rad/s] The speeds at which a side turns back: the vertices of the parabolas over arc length through an orbit and
/// its neighbours. Two turns in immediate succession are a kink and not counted.
std::vector<double> folds_of(const std::vector<Point>& points) {
  std::vector<double> found;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double left = (points[i].state - points[i - 1].state).norm(),
                 right = (points[i + 1].state - points[i].state).norm();
    const double before = (points[i].speed - points[i - 1].speed) / left,
                 after = (points[i + 1].speed - points[i].speed) / right;
    if (before * after >= 0) continue;
    const double curve = (after - before) / (left + right), slope = before + curve * left;
    const double fold = points[i].speed - slope * slope / (4 * curve);
    if (!found.empty() && std::abs(fold - found.back()) < there_and_back * fold)
      found.pop_back();
    else
      found.push_back(fold);
  }
  return found;
}

/// The whole branch, from the end of the first side over the common start to the end of the second.
OrbitBranch joined(const Side& first, const Side& second) {
  const auto back = static_cast<Eigen::Index>(first.points.size()),
             ahead = static_cast<Eigen::Index>(second.points.size());
  OrbitBranch branch;
  branch.speed.resize(back + ahead - 1);
  Eigen::ArrayXXd measured(4, branch.speed.size());
  measured << first.measured.rowwise().reverse(), second.measured.rightCols(ahead - 1);
  for (Eigen::Index i = 0; i < branch.speed.size(); ++i)
    branch.speed[i] = i < back ? first.points[static_cast<std::size_t>(back - 1 - i)].speed
                               : second.points[static_cast<std::size_t>(i - back + 1)].speed;
  branch.amplitude = measured.row(0);
  branch.multiplier = measured.row(1);
  branch.multiplier_uncertainty = measured.row(2);
  branch.multiplier_angle = measured.row(3);
  std::vector<double> folds = folds_of(first.points);
  const std::vector<double> further = folds_of(second.points);
  folds.insert(folds.end(), further.begin(), further.end());
  branch.folds = Eigen::Map<const Eigen::VectorXd>(folds.data(), static_cast<Eigen::Index>(folds.size()));
  branch.ends[0] = first.end;
  branch.ends[1] = second.end;
  return branch;
}

}  // namespace

OrbitBranch follow_branch(const Scene& scene, double speed, int steps_per_revolution, const Eigen::VectorXd& start,
                          const BranchLimits& limits) {
  BranchLimits down = limits;
  down.first_step = -limits.first_step;
  auto below =
      std::async(std::launch::async, [&] { return follow_side(scene, speed, steps_per_revolution, start, down); });
  const Side above = follow_side(scene, speed, steps_per_revolution, start, limits);
  OrbitBranch branch = joined(below.get(), above);
  branch.start = speed;
  branch.steps_per_revolution = steps_per_revolution;
  return branch;
}

}  // namespace tiprub::simulate
