// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/contact_kernels.h"

#include "cases/program/vector_lanes.h"

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

template <bool symmetric>
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
        double* later = factor.lower + stride * c;
        const double share = (symmetric ? column[c] : later[j]) * inverse;
        factor.upper[stride * c + j] = share;
        for (std::size_t i = vector_of(symmetric ? c : j + 1); i < size; i += eight)
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
void turned_block(const Parts& parts, const ClosedNodes& closed, double* into, std::size_t stride) {
  const std::size_t p = parts.coordinates, nodes = parts.nodes, tall = parts.tall;
  for (std::size_t j = 0; j < closed.count; ++j) {
    const std::size_t node = static_cast<std::size_t>(closed.node[j]), first = closed.sector[j] * p;
    const double *pushed = parts.values + tall * node, *slid = parts.values + tall * (nodes + 2 * node),
                 *bent = parts.values + tall * (3 * nodes + first), *slopes = closed.slopes + j * p;
    const bool slides = closed.drag != nullptr;
    const double along = slides ? closed.drag[2 * node] : 0, across = slides ? closed.drag[2 * node + 1] : 0;
    for (std::size_t i = slides ? 0 : j; i < closed.count; ++i) {
      const int to = closed.node[i];
      into[stride * j + i] = slides ? pushed[to] + along * slid[to] + across * slid[tall + to] : pushed[to];
    }
    for (std::size_t a = 0; a < p; a += 4) {
      Lanes4 y = {};  // what the force moves of the coordinates of the sector of node i
      int sector = -1;
      for (std::size_t i = slides ? 0 : j; i < closed.count; ++i) {
        if (closed.sector[i] != sector) {
          sector = closed.sector[i];
          const std::size_t place = nodes + sector * p + a;
          y = lanes4(pushed + place);
          if (slides) y += along * lanes4(slid + place) + across * lanes4(slid + tall + place);
          for (std::size_t b = 0; b < p; ++b) y += slopes[b] * lanes4(bent + tall * b + place);
        }
        const double* from = parts.values + tall * closed.node[i] + nodes + first + a;
        const Lanes4 narrowed = lanes4(closed.slopes + i * p + a) * y + lanes4(slopes + a) * lanes4(from);
        into[stride * j + i] += (narrowed[0] + narrowed[1]) + (narrowed[2] + narrowed[3]);
      }
    }
  }
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

bool factorize(const Factor& factor, std::size_t size, bool symmetric) {
  return symmetric ? in_eights<Factorize<true>>(factor, size) : in_eights<Factorize<false>>(factor, size);
}

void solve(const Factor& factor, std::size_t size, double* x) {
  in_eights<Solve>(factor, size, x);
}

}  // namespace tiprub::simulate::kernels
