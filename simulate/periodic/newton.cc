// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/periodic/newton.h"

#include <LOCA_Factory.H>
#include <LOCA_GlobalData.H>
#include <NOX_Solver_Factory.H>
#include <NOX_Solver_Generic.H>
#include <NOX_StatusTest_Combo.H>
#include <NOX_StatusTest_FiniteValue.H>
#include <NOX_StatusTest_MaxIters.H>
#include <Teuchos_ParameterList.hpp>

#include "simulate/periodic/orbit_group.h"

namespace tiprub::simulate {

namespace {

constexpr double linear_tolerance = 1e-2;  // of a Newton step
constexpr int most_halvings = 4;           // of a Newton step
constexpr double rounding = 1e-13;         // of |x|: a smaller residual is rounding

/// Converged if the last Newton step, before any halving, was small against the state, or the residual is rounding.
bool is_converged(const NOX::Solver::Generic& solver, double tolerance) {
  const NOX::Abstract::Group& now = solver.getSolutionGroup();
  const double size = now.getX().norm();
  if (now.getNormF() <= rounding * size) return true;
  return solver.getNumIterations() > 0 && solver.getPreviousSolutionGroup().getNewton().norm() <= tolerance * size;
}

Teuchos::RCP<Teuchos::ParameterList> settings() {
  auto list = Teuchos::parameterList();
  list->set("Nonlinear Solver", "Line Search Based");
  be_quiet(list->sublist("Printing"));
  list->sublist("Direction").set("Method", "Newton");
  list->sublist("Direction").sublist("Newton").sublist("Linear Solver").set("Tolerance", linear_tolerance);
  Teuchos::ParameterList& search = list->sublist("Line Search");
  search.set("Method", "Backtrack");
  search.sublist("Backtrack").set("Max Iters", most_halvings);
  search.sublist("Backtrack").set("Recovery Step", 0.0);  // no recovery step: the search fails
  return list;
}

Teuchos::RCP<NOX::StatusTest::Generic> test(const NewtonLimits& limits) {
  auto any = Teuchos::rcp(new NOX::StatusTest::Combo(NOX::StatusTest::Combo::OR));
  any->addStatusTest(Teuchos::rcp(
      new StopsWhen([=](const NOX::Solver::Generic& solver) { return is_converged(solver, limits.tolerance); })));
  any->addStatusTest(Teuchos::rcp(new NOX::StatusTest::FiniteValue));
  any->addStatusTest(Teuchos::rcp(new NOX::StatusTest::MaxIters(limits.iterations)));
  return any;
}

}  // namespace

NewtonResult find_fixed_point(PeriodicMap& map, const Eigen::VectorXd& start, const NewtonLimits& limits) {
  const auto list = settings();
  const auto global = LOCA::createGlobalData(list);
  const MapFamily here = [&map](double) { return std::shared_ptr<PeriodicMap>(&map, [](PeriodicMap*) {}); };
  const auto group = Teuchos::rcp(new OrbitGroup(global, here, 0.0, start));
  const auto newton = NOX::Solver::buildSolver(group, test(limits), list);
  NewtonResult result;
  result.found = newton->solve() == NOX::StatusTest::Converged;
  const auto& last = dynamic_cast<const OrbitGroup&>(newton->getSolutionGroup());
  result.state = numbers(last.getX());
  result.pattern = last.pattern();
  const double size = result.state.norm();
  result.residual = size > 0 ? last.getNormF() / size : last.getNormF();  // a state at rest
  result.iterations = newton->getNumIterations();
  LOCA::destroyGlobalData(global);
  return result;
}

}  // namespace tiprub::simulate
