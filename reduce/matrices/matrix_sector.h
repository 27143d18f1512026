// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "reduce/sector/rotating_elasticity.h"
#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// The files that give a sector by its matrices.
struct MatrixFiles {
  std::filesystem::path stiffness, mass, nodes;
  std::filesystem::path dofs;  ///< what the rows are; empty: x, y, z of each node in the order of nodes.csv
  std::vector<std::pair<double, std::filesystem::path>> stiffness_at;  ///< K at further speeds [rad/s], two at most
};

/// A sector whose K and M another code has made, both cut faces free: mesh.matrices holds them, and it has no cells.
/// The contact line is the nodes `contact` in the order of the table.
///
/// Checks what nothing else would show: M is positive on its diagonal and gives the same mass in x, y and z and none
/// between them, which finds rows in another order and K in place of M; K at rest meets a rigid motion with no force
/// at most of the nodes, which finds places that belong to other nodes; some node is clamped; and the cut faces pair.
/// Raises RunError or InputError.
SectorMesh read_matrix_sector(const MatrixFiles& files, double cyclic_tolerance);

/// One of these matrices on the dofs of the sector, in cylindrical components. All have the same pattern.
SymmetricMatrix on_sector_dofs(const Eigen::SparseMatrix<double>& matrix, const SectorMesh& mesh,
                               const SectorDofs& dofs);

/// K at any speed [rad/s], by eq. 7 through the speeds that are given.
Eigen::SparseMatrix<double> stiffness_at(const SectorMatrices& matrices, double speed);

}  // namespace tiprub::reduce
