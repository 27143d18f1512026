// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/contact_kernels.h"

#include "simulate/march/vector_lanes.h"

namespace tiprub::simulate::kernels {

namespace {

constexpr std::size_t eight = 8;

/// `vectors` vectors of the sum. Even and odd columns are summed separately, which halves the chain of additions.
template <class Set, std::size_t vectors>
TIPRUB_INLINE void combine_rows(const double* matrix, std::size_t stride, const int* columns, const double* weights,
                                std::size_t count, double* sum) {
  Eight<Set> even[vectors] = {}, odd[vectors] = {};
  std::size_t i = 0;
  for (; i + 2 <= count; i += 2) {
    const double* first = matrix + stride * columns[i];
    const double* second = matrix + stride * columns[i + 1];
    for (std::size_t v = 0; v < vectors; ++v) {
      even[v] += lanes8<Set>(first + eight * v) * weights[i];
      odd[v] += lanes8<Set>(second + eight * v) * weights[i + 1];
    }
  }
  for (std::size_t v = 0; v < vectors && i < count; ++v)
    even[v] += lanes8<Set>(matrix + stride * columns[i] + eight * v) * weights[i];
  for (std::size_t v = 0; v < vectors; ++v) lanes8<Set>(sum + eight * v) = even[v] + odd[v];
}

TIPRUB_INLINE std::size_t vector_of(std::size_t index) {
  return index / eight * eight;
}

struct CombineColumns {
  template <class Set>
  TIPRUB_INLINE static void run(const Columns& matrix, const int* columns, const double* weights, std::size_t count,
                                double* sum) {
    constexpr std::size_t most = Set::registers == 1 ? 5 : 3;  // vectors whose sums fit the registers
    std::size_t offset = 0;
    for (; offset + most * eight <= matrix.rows; offset += most * eight)
      combine_rows<Set, most>(matrix.values + offset, matrix.stride, columns, weights, count, sum + offset);
    for (; offset + 2 * eight <= matrix.rows; offset += 2 * eight)
      combine_rows<Set, 2>(matrix.values + offset, matrix.stride, columns, weights, count, sum + offset);
    for (; offset < matrix.rows; offset += eight)
      combine_rows<Set, 1>(matrix.values + offset, matrix.stride, columns, weights, count, sum + offset);
  }
};

struct AddDyad {
  template <class Set>
  TIPRUB_INLINE static void run(double* matrix, std::size_t stride, std::size_t size, const double* u,
                                double factor) {
    for (std::size_t j = 0; j < size; ++j) {
      const double share = factor * u[j];
      double* column = matrix + stride * j;
      for (std::size_t i = 0; i < size; i += eight) lanes8<Set>(column + i) += lanes8<Set>(u + i) * share;
    }
  }
};

struct Factorize {
  template <class Set>
  TIPRUB_INLINE static bool run(const Factor& factor, std::size_t size) {
    const std::size_t stride = factor.stride;
    for (std::size_t j = 0; j < size; ++j) {
      double* column = factor.lower + stride * j;
      if (!(column[j] > 0)) return false;
      const double inverse = 1 / column[j];
      factor.inverse_pivot[j] = inverse;
      for (std::size_t c = j + 1; c < size; ++c) {
        const double share = column[c] * inverse;
        factor.upper[stride * c + j] = share;
        double* later = factor.lower + stride * c;
        for (std::size_t i = vector_of(c); i < size; i += eight)
          lanes8<Set>(later + i) -= lanes8<Set>(column + i) * share;
      }
      for (std::size_t i = vector_of(j); i < size; i += eight) lanes8<Set>(column + i) *= inverse;
      for (std::size_t i = vector_of(j); i <= j; ++i) column[i] = 0;
    }
    return true;
  }
};

struct FactorizeUnsymmetric {
  template <class Set>
  TIPRUB_INLINE static bool run(const Factor& factor, std::size_t size) {
    const std::size_t stride = factor.stride;
    for (std::size_t j = 0; j < size; ++j) {
      double* column = factor.lower + stride * j;
      if (!(column[j] > 0)) return false;
      const double inverse = 1 / column[j];
      factor.inverse_pivot[j] = inverse;
      for (std::size_t c = j + 1; c < size; ++c) {
        double* later = factor.lower + stride * c;
        const double share = later[j] * inverse;
        factor.upper[stride * c + j] = share;
        for (std::size_t i = vector_of(j + 1); i < size; i += eight)
          lanes8<Set>(later + i) -= lanes8<Set>(column + i) * share;
      }
      for (std::size_t i = vector_of(j); i < size; i += eight) lanes8<Set>(column + i) *= inverse;
      for (std::size_t i = vector_of(j); i <= j; ++i) column[i] = 0;
    }
    return true;
  }
};

struct Solve {
  template <class Set>
  TIPRUB_INLINE static void run(const Factor& factor, std::size_t size, double* x) {
    const std::size_t stride = factor.stride;
    for (std::size_t j = 0; j + 1 < size; ++j) {
      const double value = x[j];
      for (std::size_t i = vector_of(j + 1); i < size; i += eight)
        lanes8<Set>(x + i) -= lanes8<Set>(factor.lower + stride * j + i) * value;
    }
    for (std::size_t i = 0; i < size; i += eight) lanes8<Set>(x + i) *= lanes8<Set>(factor.inverse_pivot + i);
    for (std::size_t j = size - 1; j > 0; --j) {
      const double value = x[j];
      for (std::size_t i = 0; i < j; i += eight)
        lanes8<Set>(x + i) -= lanes8<Set>(factor.upper + stride * j + i) * value;
    }
  }
};

}  // namespace

void combine_columns(const Columns& matrix, const int* columns, const double* weights, std::size_t count,
                     double* sum) {
  in_eights<CombineColumns>(matrix, columns, weights, count, sum);
}

TIPRUB_CLONES
void add_columns(const Columns& matrix, const double* weights, std::size_t count, double* sum) {
  for (std::size_t i = 0; i < matrix.rows; i += 4) {
    Lanes4 rows = lanes4(sum + i);
    for (std::size_t j = 0; j < count; ++j) rows += lanes4(matrix.values + matrix.stride * j + i) * weights[j];
    lanes4(sum + i) = rows;
  }
}

void add_dyad(double* matrix, std::size_t stride, std::size_t size, const double* u, double factor) {
  in_eights<AddDyad>(matrix, stride, size, u, factor);
}

bool factorize(const Factor& factor, std::size_t size) {
  return in_eights<Factorize>(factor, size);
}

bool factorize_unsymmetric(const Factor& factor, std::size_t size) {
  return in_eights<FactorizeUnsymmetric>(factor, size);
}

void solve(const Factor& factor, std::size_t size, double* x) {
  in_eights<Solve>(factor, size, x);
}

}  // namespace tiprub::simulate::kernels
