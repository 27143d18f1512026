// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/supernodal_solve.h"

#include <algorithm>
#include <cstddef>

namespace tiprub::reduce {

namespace {

constexpr int lanes = 4;  ///< 32 bytes: without AVX-512, GCC passes vectors of 64 through memory
using Lanes = double __attribute__((vector_size(lanes * sizeof(double)), aligned(alignof(double)), may_alias));

/// Some columns of a supernode, from the diagonal on.
struct Panel {
  const double* values;  ///< of the first column, at the diagonal
  std::ptrdiff_t stride;
  const std::int64_t* rows;  ///< from the diagonal on
  int count;                 ///< of them

  Panel(const Supernodes& factor, std::int64_t supernode, int column)
      : values(factor.values + factor.value_start[supernode]),
        stride(factor.row_start[supernode + 1] - factor.row_start[supernode]),
        rows(factor.rows + factor.row_start[supernode] + column),
        count(static_cast<int>(stride) - column) {
    values += column * (stride + 1);
  }
  double operator()(int row, int column) const { return values[row + column * stride]; }
};

/// A strip holds `parts` times `lanes` right sides, row by row.
template <int parts>
Lanes* row_of(double* strip, std::int64_t row) {
  return reinterpret_cast<Lanes*>(strip + row * parts * lanes);
}

template <int width, int parts>
__attribute__((always_inline)) inline void eliminate(const Panel& L, double* strip) {
  Lanes x[width][parts];
  for (int k = 0; k < width; ++k) {
    Lanes* own = row_of<parts>(strip, L.rows[k]);
    for (int part = 0; part < parts; ++part) {
      x[k][part] = own[part];
      for (int j = 0; j < k; ++j) x[k][part] -= L(k, j) * x[j][part];
      x[k][part] /= L(k, k);
      own[part] = x[k][part];
    }
  }
  for (int row = width; row < L.count; ++row) {
    Lanes* y = row_of<parts>(strip, L.rows[row]);
    for (int part = 0; part < parts; ++part) {
      Lanes sum = y[part];
      for (int k = 0; k < width; ++k) sum -= L(row, k) * x[k][part];
      y[part] = sum;
    }
  }
}

template <int width, int parts>
__attribute__((always_inline)) inline void substitute(const Panel& L, double* strip) {
  Lanes x[width][parts];
  for (int k = 0; k < width; ++k)
    for (int part = 0; part < parts; ++part) x[k][part] = row_of<parts>(strip, L.rows[k])[part];
  for (int row = width; row < L.count; ++row) {
    const Lanes* y = row_of<parts>(strip, L.rows[row]);
    for (int k = 0; k < width; ++k)
      for (int part = 0; part < parts; ++part) x[k][part] -= L(row, k) * y[part];
  }
  for (int k = width - 1; k >= 0; --k) {
    Lanes* own = row_of<parts>(strip, L.rows[k]);
    for (int part = 0; part < parts; ++part) {
      for (int j = k + 1; j < width; ++j) x[k][part] -= L(j, k) * x[j][part];
      x[k][part] /= L(k, k);
      own[part] = x[k][part];
    }
  }
}

/// How many of a supernode's columns are among the first `all` ones.
int columns_within(const Supernodes& factor, std::int64_t supernode, std::int64_t all) {
  return static_cast<int>(std::min(factor.first[supernode + 1], all) - factor.first[supernode]);
}

/// Supernodes from the first to the last, in panels of as many columns as the registers hold.
template <int parts>
__attribute__((always_inline)) inline void forward(const Supernodes& factor, std::int64_t all, double* strip) {
  for (std::int64_t b = 0; b < factor.count; ++b) {
    const int columns = columns_within(factor, b, all);
    int at = 0;
    for (; at + 8 <= columns; at += 8) eliminate<8, parts>({factor, b, at}, strip);
    for (; at + 3 <= columns; at += 3) eliminate<3, parts>({factor, b, at}, strip);
    for (; at < columns; ++at) eliminate<1, parts>({factor, b, at}, strip);
  }
}

template <int parts>
__attribute__((always_inline)) inline void backward(const Supernodes& factor, std::int64_t all, double* strip) {
  for (std::int64_t b = factor.count - 1; b >= 0; --b) {
    int at = columns_within(factor, b, all);
    for (; at >= 8; at -= 8) substitute<8, parts>({factor, b, at - 8}, strip);
    for (; at >= 3; at -= 3) substitute<3, parts>({factor, b, at - 3}, strip);
    for (; at >= 1; at -= 1) substitute<1, parts>({factor, b, at - 1}, strip);
  }
}

// Compiled for what the processor has: the sums are then the same on the same machine.
#define TIPRUB_FOR_EACH_PROCESSOR __attribute__((target_clones("avx512f", "avx2,fma", "default")))
TIPRUB_FOR_EACH_PROCESSOR void forward_wide(const Supernodes& factor, std::int64_t all, double* strip) {
  forward<4>(factor, all, strip);
}
TIPRUB_FOR_EACH_PROCESSOR void forward_narrow(const Supernodes& factor, std::int64_t all, double* strip) {
  forward<2>(factor, all, strip);
}
TIPRUB_FOR_EACH_PROCESSOR void backward_wide(const Supernodes& factor, std::int64_t all, double* strip) {
  backward<4>(factor, all, strip);
}
TIPRUB_FOR_EACH_PROCESSOR void backward_narrow(const Supernodes& factor, std::int64_t all, double* strip) {
  backward<2>(factor, all, strip);
}
#undef TIPRUB_FOR_EACH_PROCESSOR

/// Strip by strip: the last columns, if they are few, in a narrow one.
template <class Wide, class Narrow>
void in_strips(Eigen::MatrixXd& right, const Wide& wide, const Narrow& narrow) {
  using Strip = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  constexpr Eigen::Index rows_at_once = 256;  // both orders of them stay in the cache
  Strip strip;
  for (Eigen::Index first = 0; first < right.cols(); first += strip.cols()) {
    const Eigen::Index rest = right.cols() - first;
    if (rest <= 2 * lanes || strip.size() == 0)
      strip.setZero(right.rows(), rest <= 2 * lanes ? 2 * lanes : 4 * lanes);
    const Eigen::Index columns = std::min(rest, strip.cols());
    for (Eigen::Index row = 0; row < right.rows(); row += rows_at_once) {
      const Eigen::Index rows = std::min(rows_at_once, right.rows() - row);
      strip.block(row, 0, rows, columns) = right.block(row, first, rows, columns);
    }
    strip.cols() == 2 * lanes ? narrow(strip.data()) : wide(strip.data());
    for (Eigen::Index row = 0; row < right.rows(); row += rows_at_once) {
      const Eigen::Index rows = std::min(rows_at_once, right.rows() - row);
      right.block(row, first, rows, columns) = strip.block(row, 0, rows, columns);
    }
  }
}

}  // namespace

void eliminate_interior(const Supernodes& factor, std::int64_t columns, Eigen::MatrixXd& right) {
  in_strips(
      right, [&](double* strip) { forward_wide(factor, columns, strip); },
      [&](double* strip) { forward_narrow(factor, columns, strip); });
}

void substitute_interior(const Supernodes& factor, std::int64_t columns, Eigen::MatrixXd& right) {
  in_strips(
      right, [&](double* strip) { backward_wide(factor, columns, strip); },
      [&](double* strip) { backward_narrow(factor, columns, strip); });
}

}  // namespace tiprub::reduce
