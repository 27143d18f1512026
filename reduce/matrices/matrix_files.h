// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace tiprub {

/// Reads a real symmetric matrix: Matrix Market (coordinate or array, symmetric or general), or lines "row column
/// value" of one triangle, as CalculiX writes them (.sti, .mas). Both triangles are in the result. Raises RunError if
/// it can't be read, InputError, with the line, if it is no such matrix, not square, or not symmetric to 1e-9 of its
/// largest entry.
Eigen::SparseMatrix<double> read_symmetric_matrix(const std::filesystem::path& path);

/// What a node of a sector is, whose matrices are given.
enum class NodePlace { inside, clamped, cyclic_low, cyclic_high, contact };

/// nodes.csv: a head that names columns, x, y, z [m], and, if wanted, node and set.
struct NodeTable {
  std::vector<long> number;  ///< column `node`, or 1, 2, ...
  Eigen::Matrix3Xd position;
  std::vector<NodePlace> place;  ///< column `set`: clamped, cyclic_low, cyclic_high, contact, or empty
};

/// Raises RunError if it can't be read, InputError, with the line, if it is no such table.
NodeTable read_node_table(const std::filesystem::path& path);

/// What the rows of the matrices are: number of a node and direction 0, 1, 2, as CalculiX lists them (.dof): "12.3".
/// Raises RunError if it can't be read, InputError with the line.
std::vector<std::pair<long, int>> read_dof_list(const std::filesystem::path& path);

}  // namespace tiprub
