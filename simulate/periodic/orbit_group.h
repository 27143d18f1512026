// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <LOCA_Abstract_Group.H>
#include <LOCA_GlobalData.H>
#include <LOCA_Parameter_Vector.H>
#include <NOX_LAPACK_Vector.H>
#include <NOX_Solver_Generic.H>
#include <NOX_StatusTest_Generic.H>
#include <Eigen/Dense>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "simulate/periodic/periodic_map.h"

namespace tiprub::simulate {

/// The map at a value of the parameter, a speed in rad/s.
using MapFamily = std::function<std::shared_ptr<PeriodicMap>(double)>;

/// The numbers of a NOX vector.
Eigen::Map<const Eigen::VectorXd> numbers(const NOX::Abstract::Vector& vector);
Eigen::Map<Eigen::VectorXd> numbers(NOX::Abstract::Vector& vector);

/// Switches off the output of NOX through its parameter list "Printing"; otherwise it reports failures on standard
/// output at any level of verbosity.
void be_quiet(Teuchos::ParameterList& printing);

/// Ends an iteration of NOX or LOCA as soon as a condition on its solver holds.
class StopsWhen final : public NOX::StatusTest::Generic {
 public:
  using Condition = std::function<bool(const NOX::Solver::Generic&)>;
  using Status = NOX::StatusTest::StatusType;
  explicit StopsWhen(Condition holds, Status then = Status::Converged) : holds_(std::move(holds)), then_(then) {}

  Status checkStatus(const NOX::Solver::Generic& solver, NOX::StatusTest::CheckType /*type*/) override {
    return status_ = holds_(solver) ? then_ : Status::Unconverged;
  }
  Status getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int /*indent*/) const override { return stream; }

 private:
  Condition holds_;
  Status then_, status_ = Status::Unevaluated;
};

/// The equation F(x; p) - x = 0 as NOX and LOCA see it: a state x, its residual, and solutions with the Jacobian DF -
/// 1. Copies share the family of maps. Exceptions of the map are passed on.
class OrbitGroup final : public LOCA::Abstract::Group {
 public:
  static constexpr const char* parameter = "speed";
  using ReturnType = NOX::Abstract::Group::ReturnType;
  using NOX::Abstract::Group::applyJacobianInverseMultiVector;

  OrbitGroup(const Teuchos::RCP<LOCA::GlobalData>& global, MapFamily family, double speed,
             const Eigen::VectorXd& start);
  OrbitGroup(const OrbitGroup& other, NOX::CopyType type);

  /// This function is called with the speed and the state of each orbit that LOCA finds.
  using Listener = std::function<void(double, const Eigen::VectorXd&)>;
  void call_at_solutions(Listener listener) { listener_ = std::move(listener); }

  /// The contact pattern of the map at the state; to be called after computeF().
  const std::shared_ptr<const ContactPattern>& pattern() const { return pattern_; }

  // NOX
  NOX::Abstract::Group& operator=(const NOX::Abstract::Group& source) override;  // NOLINT(misc-unconventional-*)
  void copy(const NOX::Abstract::Group& source) override;
  Teuchos::RCP<NOX::Abstract::Group> clone(NOX::CopyType type) const override;
  void setX(const NOX::Abstract::Vector& state) override;
  void computeX(const NOX::Abstract::Group& from, const NOX::Abstract::Vector& direction, double step) override;
  ReturnType computeF() override;
  ReturnType computeJacobian() override;
  ReturnType computeNewton(Teuchos::ParameterList& settings) override;
  ReturnType applyJacobian(const NOX::Abstract::Vector& input, NOX::Abstract::Vector& result) const override;
  ReturnType applyJacobianInverse(Teuchos::ParameterList& settings, const NOX::Abstract::Vector& input,
                                  NOX::Abstract::Vector& result) const override;
  bool isF() const override { return is_f_; }
  bool isJacobian() const override { return is_jacobian_; }
  bool isNewton() const override { return is_newton_; }
  const NOX::Abstract::Vector& getX() const override { return x_; }
  const NOX::Abstract::Vector& getF() const override { return f_; }
  double getNormF() const override { return f_.norm(); }
  const NOX::Abstract::Vector& getGradient() const override { return f_; }  // NOX demands it; no solver here uses it
  const NOX::Abstract::Vector& getNewton() const override { return newton_; }
  Teuchos::RCP<const NOX::Abstract::Vector> getXPtr() const override { return Teuchos::rcpFromRef(x_); }
  Teuchos::RCP<const NOX::Abstract::Vector> getFPtr() const override { return Teuchos::rcpFromRef(f_); }
  Teuchos::RCP<const NOX::Abstract::Vector> getGradientPtr() const override { return Teuchos::rcpFromRef(f_); }
  Teuchos::RCP<const NOX::Abstract::Vector> getNewtonPtr() const override { return Teuchos::rcpFromRef(newton_); }

  // LOCA
  void setParams(const LOCA::ParameterVector& parameters) override;
  void setParam(int id, double value) override;
  void setParam(std::string name, double value) override;
  const LOCA::ParameterVector& getParams() const override { return parameters_; }
  double getParam(int id) const override { return parameters_.getValue(id); }
  double getParam(std::string name) const override { return parameters_.getValue(name); }
  void printSolution(double speed) const override;
  /// The scalar product is scaled by the size of the first state, so that steps in state and in speed are comparable.
  double computeScaledDotProduct(const NOX::Abstract::Vector& one, const NOX::Abstract::Vector& other) const override;

 private:
  void forget() { is_f_ = is_jacobian_ = is_newton_ = false; }

  MapFamily family_;
  std::shared_ptr<PeriodicMap> map_;
  Listener listener_;
  double size_;  ///< norm of the first state
  LOCA::ParameterVector parameters_;
  NOX::LAPACK::Vector x_, f_, newton_;
  std::shared_ptr<const ContactPattern> pattern_;
  bool is_f_ = false, is_jacobian_ = false, is_newton_ = false;
};

}  // namespace tiprub::simulate
