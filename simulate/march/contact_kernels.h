// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace tiprub::kernels {

/// The inner loops of the contact problem. Matrices are column-major with `stride` rows; vectors that are written are
/// as long. The stride is a multiple of eight, and what is beyond the matrix is zero: loops run over whole vectors.

constexpr std::size_t whole_vectors(std::size_t size) {
  return (size + 7) / 8 * 8;
}

/// The first `rows` of a matrix, in whole vectors.
struct Columns {
  const double* values;
  std::size_t stride, rows;
};
/// sum = matrix(:, columns) weights.
void combine_columns(const Columns& matrix, const int* columns, const double* weights, std::size_t count,
                     double* sum);

/// matrix += factor u u^T, of `size` rows and columns; u is zero from there to whole vectors.
void add_dyad(double* matrix, std::size_t stride, std::size_t size, const double* u, double factor);

/// A symmetric matrix as L D L^T, without pivoting.
struct Factor {
  double* lower;          ///< on entry the matrix, in and below its diagonal; on return L below a diagonal of zeros
  double* upper;          ///< L^T above a diagonal of zeros: both substitutions run along columns
  double* inverse_pivot;  ///< 1/D
  std::size_t stride;
};
/// Whether it is positive definite; stops at the first pivot that isn't positive.
bool factorize(const Factor& factor, std::size_t size);
/// x of the factorized system in the place of the right side.
void solve(const Factor& factor, std::size_t size, double* x);

}  // namespace tiprub::kernels
