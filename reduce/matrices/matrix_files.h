// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <filesystem>
#include <vector>

namespace tiprub::reduce {

/// Reads a real symmetric matrix: Matrix Market (coordinate or array, symmetric or general), or lines "row column
/// value" of one triangle, as CalculiX writes them (.sti, .mas). Both triangles are in the result. Raises RunError if
/// the file can't be read, and InputError, with the line, if it holds no such matrix, or one that isn't square, or
/// not symmetric to 1e-9 of its largest entry.
Eigen::SparseMatrix<double> read_symmetric_matrix(const std::filesystem::path& path);

/// The place of a node in a sector that is given by its matrices.
enum class NodePlace { inside, clamped, cyclic_low, cyclic_high, contact };

/// nodes.csv: its first line names the columns x, y, z [m] and, optionally, node and set.
struct NodeTable {
  std::vector<long> number;  ///< column `node`, or 1, 2, ...
  Eigen::Matrix3Xd position;
  std::vector<NodePlace> place;  ///< column `set`: clamped, cyclic_low, cyclic_high, contact, or empty
};

/// Raises RunError if the file can't be read, and InputError, with the line, if it holds no such table.
NodeTable read_node_table(const std::filesystem::path& path);

/// Reads what the rows of the matrices are: the number of a node and a direction 0, 1, 2. CalculiX lists them as
/// "12.3" (.dof). Raises RunError if the file can't be read, and InputError with the line.
std::vector<std::pair<long, int>> read_dof_list(const std::filesystem::path& path);

}  // namespace tiprub::reduce
