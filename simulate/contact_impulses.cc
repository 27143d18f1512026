// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/contact_impulses.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

#include "cases/errors.h"

namespace tiprub {

namespace {

constexpr double diagonal_shift = 1e-12;  // of W's diagonal
constexpr double gap_tolerance = 1e-12;   // of the deepest penetration of the free step
constexpr int active_set_rounds = 25;
constexpr int least_index_rounds = 200;  // a node

}  // namespace

ContactImpulses::ContactImpulses(Eigen::MatrixXd compliance, ContactRule rule)
    : compliance_(std::move(compliance)),
      rule_(rule),
      multipliers_(Eigen::VectorXd::Zero(compliance_.rows())),
      correction_(Eigen::VectorXd::Zero(compliance_.rows())),
      free_gap_(compliance_.rows()),
      closed_forces_(compliance_.rows()),
      factor_(compliance_.rows(), compliance_.rows()) {}

void ContactImpulses::open() {
  for (int i : closed_) multipliers_[i] = 0.0;
  closed_.clear();
  warm_.clear();
}

void ContactImpulses::factorize() {
  if (closed_ == factorized_) return;
  const auto size = static_cast<Eigen::Index>(closed_.size());
  auto block = factor_.topLeftCorner(size, size);
  for (Eigen::Index row = 0; row < size; ++row) {
    for (Eigen::Index column = 0; column <= row; ++column)
      block(row, column) = compliance_(closed_[row], closed_[column]);
    block(row, row) *= 1 + diagonal_shift;
  }
  Eigen::Ref<Eigen::MatrixXd> in_place(block);
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> cholesky(in_place);
  if (cholesky.info() != Eigen::Success)
    throw RunError("the contact compliance of " + std::to_string(size) +
                   " closed nodes is not positive definite: nodes lie too close together, or modes are too few");
  factorized_ = closed_;
  ++factorizations_;
}

/// lambda on the closed set, W_cc lambda_c = -g_c, and what it does to all gaps.
void ContactImpulses::solve_closed() {
  factorize();
  const auto size = static_cast<Eigen::Index>(closed_.size());
  auto forces = closed_forces_.head(size);
  for (Eigen::Index i = 0; i < size; ++i) forces[i] = -free_gap_[closed_[i]];
  const auto lower = factor_.topLeftCorner(size, size).triangularView<Eigen::Lower>();
  lower.solveInPlace(forces);
  lower.adjoint().solveInPlace(forces);
  multipliers_.setZero();
  correction_.setZero();
  for (Eigen::Index i = 0; i < size; ++i) {
    multipliers_[closed_[i]] = forces[i];
    correction_.noalias() += forces[i] * compliance_.col(closed_[i]);
  }
}

void ContactImpulses::close_penetrating() {
  closed_.clear();
  for (Eigen::Index i = 0; i < free_gap_.size(); ++i)
    if (free_gap_[i] < 0) closed_.push_back(static_cast<int>(i));
}

bool ContactImpulses::settle_active_set(double tolerance) {
  closed_ = warm_;
  if (closed_.empty()) close_penetrating();
  for (int round = 0; round < active_set_rounds; ++round) {
    solve_closed();
    next_.clear();
    std::size_t at = 0;
    for (int i = 0; i < static_cast<int>(free_gap_.size()); ++i) {
      const bool is_closed = at < closed_.size() && closed_[at] == i;
      if (is_closed) ++at;
      if (is_closed ? multipliers_[i] > 0 : free_gap_[i] + correction_[i] < -tolerance) next_.push_back(i);
    }
    if (next_ == closed_) return true;
    std::swap(closed_, next_);
  }
  return false;
}

void ContactImpulses::settle_least_index(double tolerance) {
  ++fallbacks_;
  closed_.clear();
  for (Eigen::Index round = 0; round < least_index_rounds * free_gap_.size(); ++round) {
    solve_closed();
    int wrong = -1;
    for (int i = 0; i < static_cast<int>(free_gap_.size()) && wrong < 0; ++i) {
      const bool is_closed = std::binary_search(closed_.begin(), closed_.end(), i);
      if (is_closed ? multipliers_[i] < 0 : free_gap_[i] + correction_[i] < -tolerance) wrong = i;
    }
    if (wrong < 0) return;
    const auto place = std::lower_bound(closed_.begin(), closed_.end(), wrong);
    if (place != closed_.end() && *place == wrong)
      closed_.erase(place);
    else
      closed_.insert(place, wrong);
  }
  throw RunError("the contact problem of a step has no solution: the contact compliance is not positive definite");
}

void ContactImpulses::solve(Eigen::Ref<Eigen::VectorXd> gap) {
  free_gap_ = gap;
  if (rule_ == ContactRule::paper) {
    close_penetrating();
    solve_closed();
  } else {
    const double tolerance = -gap_tolerance * free_gap_.minCoeff();
    if (!settle_active_set(tolerance)) settle_least_index(tolerance);
    warm_ = closed_;
  }
  gap += correction_;
}

}  // namespace tiprub
