// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/closed_inverse.h"

#include <algorithm>
#include <numeric>

#include "simulate/march/contact_kernels.h"

namespace tiprub {

namespace {

constexpr char kept = 2;

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

}  // namespace tiprub
