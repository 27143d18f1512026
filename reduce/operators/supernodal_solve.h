// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstdint>

namespace tiprub::reduce {

/// A supernodal Cholesky factor as CHOLMOD holds it (Chen, Davis, Hager, Rajamanickam 2008). Supernode b has the
/// columns first[b] .. first[b + 1] - 1, and the rows rows[row_start[b]] .. rows[row_start[b + 1] - 1], its own
/// first; values + value_start[b] is a dense matrix of these, column by column, whose upper triangle is not used.
/// Indices have 64 bits: a factor passes 2^31 entries at about a million dofs.
struct Supernodes {
  std::int64_t count;
  const std::int64_t* first;
  const std::int64_t* row_start;
  const std::int64_t* value_start;
  const std::int64_t* rows;
  const double* values;
};

/// With the first `columns` columns of L, an interior I before an interface F: replaces b_I by y = L_II^-1 b_I, and
/// b_F by b_F - L_FI y, which is b_F - K_FI K_II^-1 b_I. `right` has the rows of the factor and any number of
/// columns. Why not cholmod_solve: it takes all of L, of which the dense L_FF may be half, and passes each supernode
/// to the BLAS, which first copies it into another order. Here 16 right-hand sides are stored side by side, and L is
/// read once without a copy: this is at least twice as fast for 8 or 16 columns, and 1.4 times for 48.
void eliminate_interior(const Supernodes& factor, std::int64_t columns, Eigen::MatrixXd& right);
/// Replaces y_I by x_I, with L_II' x_I = y_I - L_FI' x_F; x_F stays.
void substitute_interior(const Supernodes& factor, std::int64_t columns, Eigen::MatrixXd& right);

}  // namespace tiprub::reduce
