// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/supernodal_solve.h"

#include <algorithm>
#include <cstddef>

#include "cases/program/vector_lanes.h"

namespace tiprub::reduce {

namespace {

constexpr int wide = 16, narrow = 8;  ///< right sides of a strip, row by row

/// Some columns of a supernode, from the diagonal on.
struct Panel {
  const double* values;  ///< of the first column, at the diagonal
  std::ptrdiff_t stride;
  const std::int64_t* rows;  ///< from the diagonal on
  int count;                 ///< of them

  double operator()(int row, int column) const { return values[row + column * stride]; }
};

Panel panel(const Supernodes& factor, std::int64_t supernode, int column) {
  const std::ptrdiff_t stride = factor.row_start[supernode + 1] - factor.row_start[supernode];
  return {factor.values + factor.value_start[supernode] + column * (stride + 1), stride,
          factor.rows + factor.row_start[supernode] + column, static_cast<int>(stride) - column};
}

template <class Set, int width, int strip_width>
TIPRUB_INLINE void eliminate(const Panel& L, double* strip) {
  using Lanes = typename Set::Register;
  constexpr int parts = strip_width * sizeof(double) / sizeof(Lanes);
  const auto row_of = [&](std::int64_t row) { return reinterpret_cast<Lanes*>(strip + row * strip_width); };
  Lanes x[width][parts];
  for (int k = 0; k < width; ++k) {
    Lanes* own = row_of(L.rows[k]);
    for (int part = 0; part < parts; ++part) {
      x[k][part] = own[part];
      for (int j = 0; j < k; ++j) x[k][part] -= L(k, j) * x[j][part];
      x[k][part] /= L(k, k);
      own[part] = x[k][part];
    }
  }
  for (int row = width; row < L.count; ++row) {
    Lanes* y = row_of(L.rows[row]);
    for (int part = 0; part < parts; ++part) {
      Lanes sum = y[part];
      for (int k = 0; k < width; ++k) sum -= L(row, k) * x[k][part];
      y[part] = sum;
    }
  }
}

template <class Set, int width, int strip_width>
TIPRUB_INLINE void substitute(const Panel& L, double* strip) {
  using Lanes = typename Set::Register;
  constexpr int parts = strip_width * sizeof(double) / sizeof(Lanes);
  const auto row_of = [&](std::int64_t row) { return reinterpret_cast<Lanes*>(strip + row * strip_width); };
  Lanes x[width][parts];
  for (int k = 0; k < width; ++k)
    for (int part = 0; part < parts; ++part) x[k][part] = row_of(L.rows[k])[part];
  for (int row = width; row < L.count; ++row) {
    const Lanes* y = row_of(L.rows[row]);
    for (int k = 0; k < width; ++k)
      for (int part = 0; part < parts; ++part) x[k][part] -= L(row, k) * y[part];
  }
  for (int k = width - 1; k >= 0; --k) {
    Lanes* own = row_of(L.rows[k]);
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

enum class Half { elimination, substitution };

/// Supernodes from the first to the last or back, in panels of as many columns as the registers hold.
template <int width>
struct Pass {
  template <class Set>
  TIPRUB_INLINE static void run(Half half, const Supernodes& factor, std::int64_t all, double* strip) {
    for (std::int64_t k = 0; k < factor.count; ++k) {
      if (half == Half::elimination) {
        const int columns = columns_within(factor, k, all);
        int at = 0;
        for (; at + 8 <= columns; at += 8) eliminate<Set, 8, width>(panel(factor, k, at), strip);
        for (; at + 3 <= columns; at += 3) eliminate<Set, 3, width>(panel(factor, k, at), strip);
        for (; at < columns; ++at) eliminate<Set, 1, width>(panel(factor, k, at), strip);
      } else {
        const std::int64_t b = factor.count - 1 - k;
        int at = columns_within(factor, b, all);
        for (; at >= 8; at -= 8) substitute<Set, 8, width>(panel(factor, b, at - 8), strip);
        for (; at >= 3; at -= 3) substitute<Set, 3, width>(panel(factor, b, at - 3), strip);
        for (; at >= 1; at -= 1) substitute<Set, 1, width>(panel(factor, b, at - 1), strip);
      }
    }
  }
};

/// Strip by strip: the last columns, if they are few, in a narrow one.
void in_strips(Half half, const Supernodes& factor, std::int64_t all, Eigen::MatrixXd& right) {
  using Strip = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  constexpr Eigen::Index rows_at_once = 256;  // both orders of them stay in the cache
  Strip strip;
  for (Eigen::Index first = 0; first < right.cols(); first += strip.cols()) {
    const Eigen::Index rest = right.cols() - first;
    if (rest <= narrow || strip.size() == 0) strip.setZero(right.rows(), rest <= narrow ? narrow : wide);
    const Eigen::Index columns = std::min(rest, strip.cols());
    for (Eigen::Index row = 0; row < right.rows(); row += rows_at_once) {
      const Eigen::Index rows = std::min(rows_at_once, right.rows() - row);
      strip.block(row, 0, rows, columns) = right.block(row, first, rows, columns);
    }
    strip.cols() == wide ? in_eights<Pass<wide>>(half, factor, all, strip.data())
                         : in_eights<Pass<narrow>>(half, factor, all, strip.data());
    for (Eigen::Index row = 0; row < right.rows(); row += rows_at_once) {
      const Eigen::Index rows = std::min(rows_at_once, right.rows() - row);
      right.block(row, first, rows, columns) = strip.block(row, 0, rows, columns);
    }
  }
}

}  // namespace

void eliminate_interior(const Supernodes& factor, std::int64_t columns, Eigen::MatrixXd& right) {
  in_strips(Half::elimination, factor, columns, right);
}

void substitute_interior(const Supernodes& factor, std::int64_t columns, Eigen::MatrixXd& right) {
  in_strips(Half::substitution, factor, columns, right);
}

}  // namespace tiprub::reduce
