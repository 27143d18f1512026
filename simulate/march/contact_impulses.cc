// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/contact_impulses.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "simulate/march/contact_kernels.h"
#include "simulate/motion/attempt.h"

namespace tiprub::simulate {

namespace {

constexpr char kept = 2;

constexpr double diagonal_shift = 1e-12;    // of W's diagonal
constexpr double gap_tolerance = 1e-12;     // of the deepest penetration of the free step
constexpr double inverse_rounding = 1e-13;  // of the deepest gap of the closed nodes
constexpr int active_set_rounds = 25;
constexpr int least_index_rounds = 200;  // a node

NoMotion indefinite(const std::string& what, const ContactCompliance& compliance) {
  return NoMotion(what + " is not positive definite: nodes lie too close together, or modes are too few" +
                  (compliance.has_friction() ? ", or there is too much friction" : "") +
                  (compliance.is_curved() ? ", or the casing is too steep for a gap of second order" : ""));
}

}  // namespace

ClosedInverse::ClosedInverse(const double* compliance, std::size_t stride, double diagonal_shift)
    : compliance_(compliance),
      stride_(stride),
      diagonal_(1 + diagonal_shift),
      inverse_(stride * stride),
      column_(stride),
      product_(stride),
      all_slots_(stride),
      wanted_(stride, 0) {
  std::iota(all_slots_.begin(), all_slots_.end(), 0);
}

void ClosedInverse::clear() {
  while (!nodes_.empty()) {
    nodes_.pop_back();
    double* last = inverse_.data() + stride_ * nodes_.size();
    std::fill(last, last + stride_, 0.0);
  }
}

/// V becomes V + u u^T / s, u = (V w, -1), s the pivot w_ii - w^T V w.
bool ClosedInverse::close(int node) {
  const double* from = compliance_ + stride_ * static_cast<std::size_t>(node);
  const std::size_t size = nodes_.size();
  for (std::size_t i = 0; i < size; ++i) column_[i] = from[nodes_[i]];
  std::fill(column_.data() + size, column_.data() + kernels::whole_vectors(size + 1), 0.0);
  kernels::combine_columns({inverse_.data(), stride_, kernels::whole_vectors(size + 1)}, all_slots_.data(),
                           column_.data(), size, product_.data());
  double pivot = from[node] * diagonal_;
  for (std::size_t i = 0; i < size; ++i) pivot -= column_[i] * product_[i];
  if (!(pivot > 0)) return false;
  product_[size] = -1;
  nodes_.push_back(node);
  kernels::add_dyad(inverse_.data(), stride_, size + 1, product_.data(), 1 / pivot);
  return true;
}

/// V becomes V - v_k v_k^T / v_kk, which makes row and column k zero; the last row and column take their place.
void ClosedInverse::open(std::size_t slot) {
  const std::size_t last = nodes_.size() - 1;
  std::copy_n(inverse_.data() + stride_ * slot, kernels::whole_vectors(last + 1), column_.data());
  kernels::add_dyad(inverse_.data(), stride_, last + 1, column_.data(), -1 / column_[slot]);
  double* into = inverse_.data() + stride_ * slot;
  double* from = inverse_.data() + stride_ * last;
  if (slot != last) {
    std::copy_n(from, last, into);
    into[slot] = from[last];
    for (std::size_t j = 0; j < last; ++j) inverse_[stride_ * j + slot] = into[j];
  }
  for (std::size_t j = 0; j < last; ++j) inverse_[stride_ * j + last] = 0;
  std::fill(from, from + last + 1, 0.0);
  nodes_[slot] = nodes_[last];
  nodes_.pop_back();
}

bool ClosedInverse::follow(const std::vector<int>& closed) {
  for (int node : closed) wanted_[node] = 1;
  for (std::size_t slot = nodes_.size(); slot-- > 0;)
    if (wanted_[nodes_[slot]] == 0)
      open(slot);
    else
      wanted_[nodes_[slot]] = kept;
  bool done = true;
  for (int node : closed) {
    if (wanted_[node] != kept) done = done && close(node);
    wanted_[node] = 0;
  }
  if (!done) clear();
  return done;
}

const double* ClosedInverse::forces(const double* gap) {
  const std::size_t size = nodes_.size();
  for (std::size_t i = 0; i < size; ++i) column_[i] = -gap[nodes_[i]];
  kernels::combine_columns({inverse_.data(), stride_, kernels::whole_vectors(size)}, all_slots_.data(),
                           column_.data(), size, product_.data());
  return product_.data();
}

ContactImpulses::ContactImpulses(std::shared_ptr<ContactCompliance> compliance, ContactRule rule)
    : rule_(rule),
      multipliers_(Eigen::VectorXd::Zero(compliance->size())),
      correction_(multipliers_),
      free_gap_(multipliers_),
      gap_(multipliers_),
      stride_(compliance->stride()),
      compliance_(std::move(compliance)),
      lower_(stride_ * stride_),
      upper_(stride_ * stride_),
      inverse_pivots_(stride_),
      closed_forces_(stride_),
      padded_correction_(stride_),
      inverse_(compliance_->data(), stride_, diagonal_shift) {}

void ContactImpulses::open() {
  for (int i : closed_) multipliers_[i] = 0.0;
  closed_.clear();
  warm_.clear();
}

void ContactImpulses::factorize() {
  if (compliance_->is_constant() && closed_ == factorized_) return;
  factorized_.clear();
  const std::size_t size = closed_.size();
  compliance_->block(closed_, lower_.data());
  for (std::size_t column = 0; column < size; ++column) {
    double* const values = lower_.data() + stride_ * column;
    std::fill(values + size, values + kernels::whole_vectors(size), 0.0);
    values[column] *= 1 + diagonal_shift;
  }
  if (!kernels::factorize(factor(), size, !compliance_->has_friction()))
    throw indefinite("the contact compliance of " + std::to_string(size) + " closed nodes", *compliance_);
  factorized_ = closed_;
  ++factorizations_;
}

/// Solves with the kept inverse. If that leaves the closed nodes farther from the wall than a factor would, the
/// inverse is cleared and the result is false.
bool ContactImpulses::solve_by_inverse() {
  if (!inverse_.follow(closed_)) return false;
  const std::vector<int>& nodes = inverse_.nodes();
  const double* forces = inverse_.forces(free_gap_.data());
  kernels::combine_columns(columns(), nodes.data(), forces, nodes.size(), padded_correction_.data());
  double deepest = 0, left = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const int node = nodes[i];
    const double shift = diagonal_shift * compliance_->column(node)[node] * forces[i];
    multipliers_[node] = forces[i];
    left = std::max(left, std::abs(free_gap_[node] + padded_correction_[node] + shift));
    deepest = std::max(deepest, std::abs(free_gap_[node]));
  }
  if (left <= inverse_rounding * deepest) return true;
  inverse_.clear();
  return false;
}

void ContactImpulses::solve_by_factor() {
  factorize();
  const std::size_t size = closed_.size();
  for (std::size_t i = 0; i < size; ++i) closed_forces_[i] = -free_gap_[closed_[i]];
  std::fill(closed_forces_.data() + size, closed_forces_.data() + kernels::whole_vectors(size), 0.0);
  if (size > 0) kernels::solve(factor(), size, closed_forces_.data());
  for (std::size_t i = 0; i < size; ++i) multipliers_[closed_[i]] = closed_forces_[i];
  compliance_->respond(closed_forces_.data(), closed_);
  std::copy_n(compliance_->opened(), stride_, padded_correction_.data());
}

/// eq. 15: lambda on the closed set from W_cc lambda_c = -g_c, so that eq. 14 holds there, and its effect W lambda on
/// all gaps.
void ContactImpulses::solve_closed() {
  multipliers_.setZero();
  if (!compliance_->is_constant() || !solve_by_inverse()) solve_by_factor();
  std::copy_n(padded_correction_.data(), correction_.size(), correction_.data());
}

/// Whether all closed nodes are pushed and no open one penetrates.
bool ContactImpulses::set_stands(double tolerance) {
  for (int i : closed_)
    if (!(multipliers_[i] > 0)) return false;
  gap_ = free_gap_ + correction_;
  for (int i : closed_) gap_[i] = 0;
  return gap_.minCoeff() >= -tolerance;
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
    if (set_stands(tolerance)) return true;
    next_.clear();
    std::size_t place = 0;
    for (int i = 0; i < static_cast<int>(free_gap_.size()); ++i) {
      const bool is_closed = place < closed_.size() && closed_[place] == i;
      if (is_closed) ++place;
      if (is_closed ? multipliers_[i] > 0 : free_gap_[i] + correction_[i] < -tolerance) next_.push_back(i);
    }
    if (next_ == closed_) return true;  // happens only if a gap is not a number
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
      const bool is_closed = std::ranges::binary_search(closed_, i);
      if (is_closed ? multipliers_[i] < 0 : free_gap_[i] + correction_[i] < -tolerance) wrong = i;
    }
    if (wrong < 0) return;
    const auto place = std::ranges::lower_bound(closed_, wrong);
    if (place != closed_.end() && *place == wrong)
      closed_.erase(place);
    else
      closed_.insert(place, wrong);
  }
  throw indefinite("the contact problem of a step has no solution: the contact compliance", *compliance_);
}

void ContactImpulses::solve(Eigen::Ref<Eigen::VectorXd> gap) {
  free_gap_ = gap;
  if (rule_ == ContactRule::paper) {  // eq. 14: every penetration is cancelled, once
    close_penetrating();
    solve_closed();
  } else {
    const double tolerance = -gap_tolerance * free_gap_.minCoeff();
    if (!settle_active_set(tolerance)) settle_least_index(tolerance);
    warm_ = closed_;
  }
  gap += correction_;
}

}  // namespace tiprub::simulate
