// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/periodic/orbit_group.h"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_TimeMonitor.hpp>
#include <Teuchos_oblackholestream.hpp>
#include <utility>

namespace tiprub::simulate {

Eigen::Map<const Eigen::VectorXd> numbers(const NOX::Abstract::Vector& vector) {
  const auto& values = dynamic_cast<const NOX::LAPACK::Vector&>(vector);
  return {&values(0), static_cast<Eigen::Index>(values.length())};
}

Eigen::Map<Eigen::VectorXd> numbers(NOX::Abstract::Vector& vector) {
  auto& values = dynamic_cast<NOX::LAPACK::Vector&>(vector);
  return {&values(0), static_cast<Eigen::Index>(values.length())};
}

void be_quiet(Teuchos::ParameterList& printing) {
  const Teuchos::RCP<std::ostream> nowhere = Teuchos::rcp(new Teuchos::oblackholestream);
  printing.set("Output Information", 0);
  printing.set("Output Stream", nowhere);
  printing.set("Error Stream", nowhere);
}

/// Switches off the stacked timer of Trilinos, which all threads would share without protection.
void close_book_of_times() {
  static const bool is_closed = [] {
    Teuchos::TimeMonitor::setStackedTimer(Teuchos::null);
    return true;
  }();
  static_cast<void>(is_closed);
}

OrbitGroup::OrbitGroup(const Teuchos::RCP<LOCA::GlobalData>& global, MapFamily family, double speed,
                       const Eigen::VectorXd& start)
    : LOCA::Abstract::Group(global),
      family_(std::move(family)),
      map_(family_(speed)),
      size_(start.norm()),
      x_(static_cast<int>(start.size())),
      f_(x_),
      newton_(x_) {
  close_book_of_times();
  numbers(static_cast<NOX::Abstract::Vector&>(x_)) = start;
  parameters_.addParameter(parameter, speed);
}

OrbitGroup::OrbitGroup(const OrbitGroup& other, NOX::CopyType type)
    : LOCA::Abstract::Group(other, type),
      family_(other.family_),
      map_(other.map_),
      listener_(other.listener_),
      size_(other.size_),
      parameters_(other.parameters_),
      x_(other.x_, type),
      f_(other.f_, type),
      newton_(other.newton_, type),
      pattern_(other.pattern_) {
  if (type == NOX::ShapeCopy) return;
  is_f_ = other.is_f_;
  is_jacobian_ = other.is_jacobian_;
  is_newton_ = other.is_newton_;
}

NOX::Abstract::Group& OrbitGroup::operator=(const NOX::Abstract::Group& source) {  // NOLINT(misc-unconventional-*)
  copy(source);
  return *this;
}

void OrbitGroup::copy(const NOX::Abstract::Group& source) {
  const auto& other = dynamic_cast<const OrbitGroup&>(source);
  if (this == &other) return;
  LOCA::Abstract::Group::copy(source);
  map_ = other.map_;
  parameters_ = other.parameters_;
  x_ = other.x_;
  f_ = other.f_;
  newton_ = other.newton_;
  pattern_ = other.pattern_;
  is_f_ = other.is_f_;
  is_jacobian_ = other.is_jacobian_;
  is_newton_ = other.is_newton_;
}

Teuchos::RCP<NOX::Abstract::Group> OrbitGroup::clone(NOX::CopyType type) const {
  return Teuchos::rcp(new OrbitGroup(*this, type));
}

void OrbitGroup::setX(const NOX::Abstract::Vector& state) {
  forget();
  x_ = state;
}

void OrbitGroup::computeX(const NOX::Abstract::Group& from, const NOX::Abstract::Vector& direction, double step) {
  forget();
  x_.update(1.0, from.getX(), step, direction, 0.0);
}

OrbitGroup::ReturnType OrbitGroup::computeF() {
  if (is_f_) return Ok;
  MapImage image = map_->image(numbers(getX()));
  numbers(static_cast<NOX::Abstract::Vector&>(f_)) = image.state - numbers(getX());
  pattern_ = std::move(image.pattern);
  is_f_ = true;
  return Ok;
}

OrbitGroup::ReturnType OrbitGroup::computeJacobian() {
  computeF();
  is_jacobian_ = true;  // needs nothing but the pattern
  return Ok;
}

OrbitGroup::ReturnType OrbitGroup::computeNewton(Teuchos::ParameterList& settings) {
  if (is_newton_) return Ok;
  applyJacobianInverse(settings, f_, newton_);
  newton_.scale(-1.0);
  is_newton_ = true;
  return Ok;
}

OrbitGroup::ReturnType OrbitGroup::applyJacobian(const NOX::Abstract::Vector& input,
                                                 NOX::Abstract::Vector& result) const {
  numbers(result) = map_->tangent(pattern_, numbers(input)) - numbers(input);
  return Ok;
}

OrbitGroup::ReturnType OrbitGroup::applyJacobianInverse(Teuchos::ParameterList& settings,
                                                        const NOX::Abstract::Vector& input,
                                                        NOX::Abstract::Vector& result) const {
  const auto tangent = [this](const Eigen::VectorXd& change) { return map_->tangent(pattern_, change); };
  const auto precondition = [this](const Eigen::VectorXd& change) { return map_->precondition(change); };
  numbers(result) = -gmres(tangent, precondition, numbers(input), settings.get("Tolerance", 1e-2));
  return Ok;
}

void OrbitGroup::setParams(const LOCA::ParameterVector& parameters) {
  setParam(parameter, parameters.getValue(parameter));
}

void OrbitGroup::setParam(int id, double value) {
  if (value == parameters_.getValue(id)) return;
  forget();
  parameters_.setValue(static_cast<unsigned int>(id), value);
  map_ = family_(value);
}

void OrbitGroup::setParam(std::string name, double value) {
  setParam(parameters_.getIndex(name), value);
}

void OrbitGroup::printSolution(double speed) const {
  if (listener_) listener_(speed, numbers(getX()));
}

double OrbitGroup::computeScaledDotProduct(const NOX::Abstract::Vector& one,
                                           const NOX::Abstract::Vector& other) const {
  return one.innerProduct(other) / (size_ * size_);
}

}  // namespace tiprub::simulate
