// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/branches/branch.h"

#include <LOCA_GlobalData.H>
#include <LOCA_Stepper.H>
#include <NOX_StatusTest_Combo.H>
#include <NOX_StatusTest_MaxIters.H>
#include <NOX_StatusTest_NormF.H>
#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <utility>

#include "cases/program/errors.h"
#include "simulate/periodic/multipliers.h"
#include "simulate/periodic/orbit_group.h"

namespace tiprub {

namespace {

constexpr double residual = 1e-8;         // of the first state's size: |F(x) - x|
constexpr int newton_iterations = 10;     // of a step that is not shortened
constexpr double linear_tolerance = 1e-3;
constexpr double longest_step = 8;        // first steps
constexpr double shortest_step = 1e-4;

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
  nox.sublist("Printing").set("Output Information", 0);
  nox.sublist("Direction").set("Method", "Newton");
  nox.sublist("Direction").sublist("Newton").sublist("Linear Solver").set("Tolerance", linear_tolerance);
  nox.sublist("Line Search").set("Method", "Full Step");
  return list;
}

Teuchos::RCP<NOX::StatusTest::Generic> test(double size) {
  auto any = Teuchos::rcp(new NOX::StatusTest::Combo(NOX::StatusTest::Combo::OR));
  any->addStatusTest(
      Teuchos::rcp(new NOX::StatusTest::NormF(residual * size, NOX::StatusTest::NormF::Unscaled)));
  any->addStatusTest(Teuchos::rcp(new NOX::StatusTest::MaxIters(newton_iterations)));
  return any;
}

void measure(OrbitFamily& family, BranchPoint& point) {
  const std::shared_ptr<PeriodicMap> map = family.at(point.speed);
  const MapImage image = map->image(point.state);
  point.amplitude = family.amplitude(point.speed, point.state);
  const Multiplier largest = largest_multiplier(
      [&](const Eigen::VectorXd& change) { return map->tangent(image.pattern, change); }, point.state.size());
  const double maps = family.maps_per_revolution(), magnitude = std::abs(largest.value);
  point.multiplier = std::pow(magnitude, maps);
  point.multiplier_uncertainty = maps * point.multiplier * largest.uncertainty / magnitude;
  point.multiplier_angle = std::abs(std::arg(largest.value));
}

}  // namespace

std::vector<double> Branch::folds() const {
  std::vector<double> found;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double before = points[i].speed - points[i - 1].speed, after = points[i + 1].speed - points[i].speed;
    if (before * after >= 0) continue;
    const double left = (points[i].state - points[i - 1].state).norm(),
                 right = (points[i + 1].state - points[i].state).norm();
    const double curve = (after / right - before / left) / (left + right), slope = before / left + curve * left;
    found.push_back(points[i].speed - slope * slope / (4 * curve));
  }
  return found;
}

Branch follow_branch(OrbitFamily& family, double speed, const Eigen::VectorXd& start, const BranchLimits& limits) {
  const auto list = settings(speed, limits);
  const auto global = LOCA::createGlobalData(list);
  Branch branch;
  const auto group = Teuchos::rcp(new OrbitGroup(
      global, [&](double at) { return family.at(at); }, speed, start, std::make_shared<RecycledGmres>()));
  group->call_at_solutions([&](double at, const Eigen::VectorXd& state) {
    BranchPoint point;
    point.speed = at;
    point.state = state;
    branch.points.push_back(std::move(point));
  });
  LOCA::Stepper stepper(global, group, test(start.norm()), list);
  const LOCA::Abstract::Iterator::IteratorStatus status = stepper.run();
  LOCA::destroyGlobalData(global);
  if (branch.points.empty()) throw RunError("no orbit to follow at " + std::to_string(speed) + " rad/s");
  branch.end = status == LOCA::Abstract::Iterator::Finished ? "end of the range of speeds, or of the steps"
                                                            : "no orbit within the shortest step";
  for (BranchPoint& point : branch.points) measure(family, point);
  return branch;
}

}  // namespace tiprub
