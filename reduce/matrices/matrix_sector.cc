// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/matrices/matrix_sector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "cases/program/errors.h"
#include "cases/program/text.h"
#include "reduce/matrices/matrix_files.h"
#include "reduce/sector/contact_line.h"
#include "reduce/sector/cut_faces.h"

namespace tiprub::reduce {

namespace {

using Matrix = Eigen::SparseMatrix<double>;

constexpr int directions = 3;

/// The row of x, y, z of each node; -1 where the matrices leave a dof out.
Eigen::MatrixXi rows_of(const NodeTable& table, const MatrixFiles& files, Eigen::Index size) {
  const Eigen::Index nodes = table.position.cols();
  Eigen::MatrixXi rows = Eigen::MatrixXi::Constant(directions, nodes, -1);
  if (files.dofs.empty()) {
    if (size != directions * nodes)
      throw InputError(text_of(files.stiffness.string(), ": has ", size, " rows; ", files.nodes.string(), " has ",
                               nodes, " nodes, which makes ", directions * nodes,
                               "; where dofs are left out, say which by --matrix-dofs"));
    for (int row = 0; row < size; ++row) rows.data()[row] = row;
    return rows;
  }
  std::map<long, Eigen::Index> column;
  for (Eigen::Index k = 0; k < nodes; ++k)
    if (const long number = table.number[static_cast<std::size_t>(k)]; !column.emplace(number, k).second)
      throw InputError(text_of(files.nodes.string(), ": has two nodes of number ", number));
  const std::vector<std::pair<long, int>> dofs = read_dof_list(files.dofs);
  if (static_cast<Eigen::Index>(dofs.size()) != size)
    throw InputError(text_of(files.dofs.string(), ": lists ", dofs.size(), " dofs; ", files.stiffness.string(),
                             " has ", size, " rows"));
  for (std::size_t row = 0; row < dofs.size(); ++row) {
    const auto known = column.find(dofs[row].first);
    if (known == column.end())
      throw InputError(text_of(files.dofs.string(), ": names node ", dofs[row].first, ", which ",
                               files.nodes.string(), " doesn't have"));
    int& place = rows(dofs[row].second, known->second);
    if (place >= 0)
      throw InputError(
          text_of(files.dofs.string(), ": names ", dofs[row].first, ".", dofs[row].second + 1, " twice"));
    place = static_cast<int>(row);
  }
  return rows;
}

/// On x, y, z of each node in the table's order, zero where the matrices leave a dof out.
Matrix by_node(const Matrix& matrix, const Eigen::MatrixXi& rows) {
  std::vector<int> to(static_cast<std::size_t>(matrix.rows()), -1);
  for (int k = 0; k < rows.size(); ++k)
    if (rows.data()[k] >= 0) to[static_cast<std::size_t>(rows.data()[k])] = k;
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < matrix.outerSize(); ++column)
    for (Matrix::InnerIterator at(matrix, column); at; ++at)
      if (to[static_cast<std::size_t>(at.row())] >= 0 && to[static_cast<std::size_t>(at.col())] >= 0)
        entries.emplace_back(to[static_cast<std::size_t>(at.row())], to[static_cast<std::size_t>(at.col())],
                             at.value());
  Matrix sorted(rows.size(), rows.size());
  sorted.setFromTriplets(entries.begin(), entries.end());
  return sorted;
}

Matrix read(const std::filesystem::path& path, Eigen::Index size) {
  Matrix matrix = read_symmetric_matrix(path);
  if (size > 0 && matrix.rows() > size)
    throw InputError(text_of(path.string(), ": has ", matrix.rows(), " rows, K at rest ", size));
  if (size > 0) matrix.conservativeResize(size, size);  // a file may leave out rows of zeros at its end
  return matrix;
}

/// Translations along, and rotations about, x, y, z.
Eigen::MatrixXd rigid_motions(const Eigen::Matrix3Xd& nodes) {
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(nodes.size(), 6);
  const Eigen::Vector3d centre = nodes.rowwise().mean();
  const double size = (nodes.colwise() - centre).colwise().norm().maxCoeff();
  for (Eigen::Index k = 0; k < nodes.cols(); ++k)
    for (int d = 0; d < directions; ++d) {
      motions(directions * k + d, d) = 1;
      motions.block<3, 1>(directions * k, 3 + d) =
          Eigen::Vector3d::Unit(d).cross(Eigen::Vector3d(nodes.col(k) - centre)) / size;
    }
  return motions;
}

/// The files that say which node and direction a row is.
std::string said_by(const MatrixFiles& files) {
  return files.nodes.string() + (files.dofs.empty() ? "" : " and " + files.dofs.string());
}

/// [kg] of three translations; `columns` are these.
Eigen::Matrix3d masses_of(const Matrix& mass, const Eigen::MatrixXd& columns) {
  return columns.transpose() * (mass * columns);
}

/// Whether a body has the same mass in all directions, and none between two.
bool is_even(const Eigen::Matrix3d& masses) {
  constexpr double tolerance = 1e-6;
  const double total = masses.trace() / 3;
  return total > 0 && (masses - total * Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= tolerance * total;
}

/// Whether the rows are x of all nodes, then y of all, then z.
bool is_by_direction(const Matrix& mass) {
  const Eigen::Index nodes = mass.rows() / directions;
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(mass.rows(), directions);
  for (int d = 0; d < directions; ++d) columns.col(d).segment(d * nodes, nodes).setOnes();
  return nodes > 1 && is_even(masses_of(mass, columns));
}

void require_mass(const Matrix& mass, const MatrixFiles& files, const Eigen::MatrixXd& motions) {
  const Eigen::Matrix3d masses = masses_of(mass, motions.leftCols(3));
  if (is_even(masses) && mass.diagonal().minCoeff() >= 0) return;
  if (files.dofs.empty() && mass.diagonal().minCoeff() >= 0 && is_by_direction(mass))
    throw InputError(files.mass.string() +
                     ": its rows are x of all nodes, then y, then z; expected are x, y, z of the first node, then of "
                     "the second, ...: sort them, or list them by --matrix-dofs");
  throw InputError(
      text_of(files.mass.string(), ": gives ", masses(0, 0), ", ", masses(1, 1), ", ", masses(2, 2),
              " kg along x, y, z, which must be the same mass; does K stand before M, and are the rows those that ",
              said_by(files), " tell, x, y, z of each node?"));
}

/// Refuses a K that resists rigid motions. The force that a rigid motion causes in a row, over the diagonal entry of
/// the row, is next to nothing except near dofs that are left out, so the median over all rows must be small.
void require_places(const Matrix& stiffness, const MatrixFiles& files, const Eigen::MatrixXd& motions) {
  constexpr double tolerance = 1e-5;
  const Eigen::MatrixXd forces = (stiffness * motions).cwiseAbs();
  const Eigen::VectorXd scale = stiffness.diagonal().cwiseAbs();
  for (Eigen::Index motion = 0; motion < motions.cols(); ++motion) {
    std::vector<double> felt;
    for (Eigen::Index row = 0; row < scale.size(); ++row)
      if (const double force = forces(row, motion) / scale[row]; scale[row] > 0)
        felt.push_back(std::isfinite(force) ? force : std::numeric_limits<double>::max());
    if (felt.empty()) throw InputError(files.stiffness.string() + ": has no entry on its diagonal");
    std::nth_element(felt.begin(), felt.begin() + static_cast<std::ptrdiff_t>(felt.size() / 2), felt.end());
    if (felt[felt.size() / 2] <= tolerance) continue;
    const std::string what = motion < 3 ? "a translation along " : "a rotation about ";
    throw InputError(text_of(files.stiffness.string(), ": meets ", what, "xyz"[motion % 3],
                             " with forces at most nodes, ", std::to_string(felt[felt.size() / 2]),
                             " of a diagonal entry: is it K at rest, and are its rows those that ", said_by(files),
                             " tell?"));
  }
}

/// Refuses a K that holds nodes which should be free. It is told only where every node has all its rows, since dofs
/// that are left out hold their neighbours.
void require_free(const Matrix& stiffness, const Eigen::MatrixXd& motions, const SectorMesh& mesh,
                  const MatrixFiles& files) {
  constexpr double tolerance = 1e-3;
  std::vector<char> free(static_cast<std::size_t>(mesh.node_count()), 1);
  for (const int node : mesh.clamped) free[static_cast<std::size_t>(node)] = 0;
  const Eigen::VectorXd force = (stiffness * motions.leftCols(3)).rowwise().norm();
  int held = 0, first = -1;
  for (int node = 0; node < mesh.node_count(); ++node) {
    const double diagonal = stiffness.diagonal().segment<3>(directions * node).cwiseAbs().maxCoeff();
    const bool holds = force.segment<3>(directions * node).maxCoeff() > tolerance * diagonal;
    if (!holds || free[static_cast<std::size_t>(node)] == 0) continue;
    if (held++ == 0) first = node;
  }
  if (held > 0)
    throw InputError(text_of(files.stiffness.string(), ": holds ", held, " of the ", mesh.node_count(),
                             " nodes against translations, the first at ", mesh.place_of(first),
                             "; K must be that of the free sector, in the rows that ", said_by(files),
                             files.dofs.empty() ? " says" : " say"));
}

/// Sorts the nodes by their places. A node that has none of its dofs in the matrices is clamped.
void place_nodes(const NodeTable& table, const Eigen::MatrixXi& rows, SectorMesh& mesh) {
  for (int node = 0; node < table.position.cols(); ++node) {
    const int known = static_cast<int>((rows.col(node).array() >= 0).count());
    if (known == 1 || known == 2)
      refuse(mesh, "node ", table.number[node], " is held in some directions only; hold it in all, or in none");
    const NodePlace place = table.place[static_cast<std::size_t>(node)];
    if (place == NodePlace::clamped || known == 0) mesh.clamped.push_back(node);
    if (place == NodePlace::cyclic_low) mesh.cyclic_low.push_back(node);
    if (place == NodePlace::cyclic_high) mesh.cyclic_high.push_back(node);
    if (place == NodePlace::contact) mesh.contact_line.push_back(node);
  }
  if (mesh.clamped.empty())
    refuse(mesh,
           "has no node whose set is clamped, so that nothing holds the wheel; name the nodes that are held, "
           "for example those of the bore");
  if (mesh.contact_line.empty()) refuse(mesh, "has no node whose set is contact");
  if (mesh.cyclic_low.empty() != mesh.cyclic_high.empty())
    refuse(mesh, "has nodes on one cut, and none on the other");
}

}  // namespace

SectorMesh read_matrix_sector(const MatrixFiles& files, double cyclic_tolerance) {
  const NodeTable table = read_node_table(files.nodes);
  const Matrix stiffness = read(files.stiffness, 0);
  const Eigen::MatrixXi rows = rows_of(table, files, stiffness.rows());
  auto matrices = std::make_shared<SectorMatrices>();
  matrices->mass = by_node(read(files.mass, stiffness.rows()), rows);
  matrices->speeds = {0.0};
  matrices->stiffness = {by_node(stiffness, rows)};
  for (const auto& [speed, path] : files.stiffness_at) {
    matrices->speeds.push_back(speed);
    matrices->stiffness.push_back(by_node(read(path, stiffness.rows()), rows));
  }
  const Eigen::MatrixXd motions = rigid_motions(table.position);
  require_mass(matrices->mass, files, motions);
  require_places(matrices->stiffness.front(), files, motions);
  SectorMesh mesh;
  mesh.file = files.nodes.string();
  mesh.nodes = table.position;
  mesh.sector_count = 1;
  place_nodes(table, rows, mesh);
  if (rows.minCoeff() >= 0) require_free(matrices->stiffness.front(), motions, mesh, files);
  mesh.matrices = std::move(matrices);
  if (!mesh.cyclic_low.empty()) pair_cut_faces(mesh, cyclic_tolerance);
  require_one_way(mesh);
  return mesh;
}

SymmetricMatrix on_sector_dofs(const Matrix& matrix, const SectorMesh& mesh, const SectorDofs& dofs) {
  SymmetricMatrix made = zero_matrix(mesh, dofs);
  std::vector<Eigen::Matrix3d> frames;
  for (int node = 0; node < mesh.node_count(); ++node) frames.push_back(cylindrical_frame(mesh.nodes.col(node)));
  for (int column = 0; column < matrix.outerSize(); ++column) {
    const int b = column / directions;
    for (Matrix::InnerIterator at(matrix, column); at; ++at) {
      const int a = static_cast<int>(at.row()) / directions, to_row = dofs.first[a], to_column = dofs.first[b];
      if (to_row < to_column || to_column < 0) continue;
      // The part of the block frame_a' K_ab frame_b that comes from this entry.
      const Eigen::Matrix3d block =
          at.value() * frames[a].row(at.row() % directions).transpose() * frames[b].row(column % directions);
      for (int k = 0; k < directions; ++k)
        for (int i = to_row == to_column ? k : 0; i < directions; ++i)
          made.coeffRef(to_row + i, to_column + k) += block(i, k);
    }
  }
  return made;
}

Matrix stiffness_at(const SectorMatrices& matrices, double speed) {
  Matrix sum(matrices.mass.rows(), matrices.mass.cols());
  for (std::size_t s = 0; s < matrices.speeds.size(); ++s) {
    double weight = 1;  // Lagrange's, in Omega^2
    for (std::size_t other = 0; other < matrices.speeds.size(); ++other)
      if (other != s)
        weight *= (speed * speed - std::pow(matrices.speeds[other], 2)) /
                  (std::pow(matrices.speeds[s], 2) - std::pow(matrices.speeds[other], 2));
    sum += weight * matrices.stiffness[s];
  }
  return sum;
}

}  // namespace tiprub::reduce
