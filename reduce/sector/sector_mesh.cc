// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/sector_mesh.h"

#include <algorithm>

#include "cases/program/digest.h"
#include "cases/program/text.h"
#include "mesh/cells/cell_kind.h"

namespace tiprub::reduce {

std::string place_text(const Eigen::Vector3d& position) {
  return text_of("x y z = ", position.x(), " ", position.y(), " ", position.z(), " m");
}

std::string digest(const SectorMesh& mesh) {
  Digest digest;
  digest.add(mesh.sector_count);
  digest.add(static_cast<int>(mesh.cells.rows()));
  digest.add(mesh.nodes.data(), static_cast<std::size_t>(mesh.nodes.size()));
  digest.add(mesh.cells.data(), static_cast<std::size_t>(mesh.cells.size()));
  const auto add = [&](const std::vector<int>& members) {
    digest.add(members.size());
    digest.add(members.data(), members.size());
  };
  for (const auto* group : {&mesh.cyclic_low, &mesh.cyclic_high, &mesh.clamped, &mesh.contact_line}) add(*group);
  digest.add(mesh.tip_faces.data(), static_cast<std::size_t>(mesh.tip_faces.size()));
  if (!mesh.splitter_line.empty()) {
    add(mesh.splitter_line);
    digest.add(mesh.splitter_faces.data(), static_cast<std::size_t>(mesh.splitter_faces.size()));
  }
  if (mesh.matrices != nullptr)
    for (const Eigen::SparseMatrix<double>* matrix : {&mesh.matrices->mass, &mesh.matrices->stiffness.front()})
      digest.add(matrix->valuePtr(), static_cast<std::size_t>(matrix->nonZeros()));
  for (const auto& [name, cells] : mesh.parts) {
    digest.add(name);
    add(cells);
  }
  return digest.digits();
}

std::string SectorMesh::kinds_in_words() const {
  if (matrices != nullptr) return "given by their matrices";
  std::map<int, int> counts;
  for (int cell = 0; cell < cell_count(); ++cell) ++counts[static_cast<int>(nodes_of(cells, cell).size())];
  return listed(counts, ", ", [](const auto& of) { return text_of(of.second, " ", cell_kind(of.first).name); });
}

double SectorMatrices::total_mass() const {
  constexpr int directions = 3;  // a translation along each meets the mass once
  double sum = 0;
  for (int column = 0; column < mass.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator at(mass, column); at; ++at)
      if (at.row() % directions == column % directions) sum += at.value();
  return sum / directions;
}

std::vector<int> SectorMesh::moving_nodes(int cell) const {
  const Eigen::VectorXi listed =
      cubic != nullptr ? Eigen::VectorXi(cubic->cells.node.col(cell)) : nodes_of(cells, cell);
  return {listed.begin(), listed.end()};
}

std::string SectorMesh::place_of(int node) const {
  return place_text(nodes.col(node));
}

std::string SectorMesh::name_of_cell(int cell) const {
  std::string name = "cell " + std::to_string(cell_tags.empty() ? static_cast<std::size_t>(cell) : cell_tags[cell]);
  for (const auto& [part, members] : parts)
    if (std::ranges::find(members, cell) != members.end()) name += " (" + part + ")";
  return name;
}

}  // namespace tiprub::reduce
