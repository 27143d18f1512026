// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace tiprub::simulate::kernels {

/// The inner loops of the contact problem. Matrices are column-major with `stride` rows, and output vectors have the
/// same length. The stride is a multiple of eight and the padding is zero, so that loops run over whole vectors of
/// eight.

constexpr std::size_t whole_vectors(std::size_t size) {
  return (size + 7) / 8 * 8;
}

/// The first `rows` rows of a matrix; `rows` is a whole number of vectors.
struct Columns {
  const double* values;
  std::size_t stride, rows;
};
/// sum = matrix(:, columns) weights.
void combine_columns(const Columns& matrix, const int* columns, const double* weights, std::size_t count,
                     double* sum);

/// sum += matrix(:, 0 .. count - 1) weights over the first `rows` rows, a whole number of vectors of four.
void add_columns(const Columns& matrix, const double* weights, std::size_t count, double* sum);

/// The displacements due to unit forces, in columns of `tall` values: those of `nodes` contact nodes, then the
/// coordinates y of the blades, `coordinates` per sector (a multiple of four). The columns belong to forces along the
/// normal of each node, along the two directions of sliding of each node, and on each coordinate. Without friction or
/// coordinates, these columns are absent.
struct Parts {
  const double* values;
  std::size_t tall, nodes, coordinates;
};
/// The closed nodes, ascending, with their sectors and the slopes of their gaps; and the drag of all nodes, two
/// values for each, or null.
struct ClosedNodes {
  const int *node, *sector;
  const double *slopes, *drag;
  std::size_t count;
};
/// Writes the block of W (ContactCompliance) of the closed nodes; without friction its lower triangle only. By
/// reciprocity, forces on coordinates displace the nodes as forces along normals change the coordinates.
void turned_block(const Parts& parts, const ClosedNodes& closed, double* into, std::size_t stride);

/// matrix += factor u u^T over `size` rows and columns. From `size` to the end of its last vector, u must be zero.
void add_dyad(double* matrix, std::size_t stride, std::size_t size, const double* u, double factor);

/// The factors L D L^T of a symmetric matrix, without pivoting.
struct Factor {
  double* lower;          ///< on entry the lower triangle of the matrix; on return L, with zeros on its diagonal
  double* upper;          ///< L^T, with zeros on its diagonal, so that both substitutions run along columns
  double* inverse_pivot;  ///< 1/D
  std::size_t stride;
};
/// Factorizes the matrix. Returns whether it is positive definite, and stops at the first pivot that is not positive.
/// An unsymmetric matrix becomes L D U: `lower` holds all of it on entry, and U takes the place of L^T. If all
/// principal minors are positive (a P-matrix), the pivots are positive in any order.
bool factorize(const Factor& factor, std::size_t size, bool symmetric);
/// Overwrites the right side x with the solution of the factorized system.
void solve(const Factor& factor, std::size_t size, double* x);

}  // namespace tiprub::simulate::kernels
