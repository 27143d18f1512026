// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace tiprub::simulate::kernels {

/// The inner loops of the contact problem. Matrices are column-major with `stride` rows, and vectors that are written
/// have the same length. The stride is a multiple of eight and the padding is zero, so that loops run over whole
/// vectors of eight.

constexpr std::size_t whole_vectors(std::size_t size) {
  return (size + 7) / 8 * 8;
}

/// The first `rows` rows of a matrix, a whole number of vectors.
struct Columns {
  const double* values;
  std::size_t stride, rows;
};
/// sum = matrix(:, columns) weights.
void combine_columns(const Columns& matrix, const int* columns, const double* weights, std::size_t count,
                     double* sum);

/// sum += matrix(:, 0 .. count - 1) weights over the first `rows` rows, a whole number of vectors of four.
void add_columns(const Columns& matrix, const double* weights, std::size_t count, double* sum);

/// What unit forces do to `nodes` contact nodes and then to the coordinates of the blades, `coordinates` a sector (a
/// whole number of vectors of four), in columns of `tall` values: forces along the normal of each node, then along
/// the two directions of sliding of each, then on each coordinate. Without coordinates or friction there are none.
struct Parts {
  const double* values;
  std::size_t tall, nodes, coordinates;
};
/// Closed nodes, ascending, the slopes of the gap of each, and the drag of all nodes, two values each, or null.
struct ClosedNodes {
  const int *node, *sector;
  const double *slopes, *drag;
  std::size_t count;
};
/// The block of W (ContactCompliance) of some nodes; without friction its lower triangle. The forces on coordinates
/// do to the nodes what those along normals do to the coordinates.
void turned_block(const Parts& parts, const ClosedNodes& closed, double* into, std::size_t stride);

/// matrix += factor u u^T over `size` rows and columns; u is zero from `size` to the end of its last vector.
void add_dyad(double* matrix, std::size_t stride, std::size_t size, const double* u, double factor);

/// A symmetric matrix as L D L^T, without pivoting.
struct Factor {
  double* lower;          ///< on entry the matrix, in and below its diagonal; on return L below a diagonal of zeros
  double* upper;          ///< L^T above a diagonal of zeros: both substitutions run along columns
  double* inverse_pivot;  ///< 1/D
  std::size_t stride;
};
/// Returns whether the matrix is positive definite; stops at the first pivot that is not positive.
bool factorize(const Factor& factor, std::size_t size);
/// The same of an unsymmetric matrix, as L D U: `lower` holds all of it on entry, and U takes the place of L^T. If
/// all principal minors are positive (a P-matrix), so are the pivots, in any order.
bool factorize_unsymmetric(const Factor& factor, std::size_t size);
/// Overwrites the right side x with the solution of the factorized system.
void solve(const Factor& factor, std::size_t size, double* x);

}  // namespace tiprub::simulate::kernels
