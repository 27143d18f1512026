// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector_fields.h"

namespace tiprub::reduce {

namespace {

/// Those of some nodes that the file has.
std::vector<int> in_file(const SectorMesh& mesh, std::vector<int> nodes) {
  std::erase_if(nodes, [&](int node) { return node >= mesh.file_node_count(); });
  return nodes;
}

}  // namespace

SectorFields describe_sector(const SectorMesh& mesh, const std::vector<int>& contact, const Material& material) {
  SectorFields sector;
  sector.sector_count = mesh.sector_count;
  sector.nodes = mesh.nodes.leftCols(mesh.file_node_count());
  sector.cells = mesh.cells;
  sector.node_sets = {{"clamped", in_file(mesh, mesh.clamped)},
                      {"contact", contact},
                      {"contact_line", mesh.contact_line},
                      {"cyclic_low", in_file(mesh, mesh.cyclic_low)},
                      {"cyclic_high", in_file(mesh, mesh.cyclic_high)}};
  if (!mesh.splitter_line.empty()) sector.node_sets["contact_splitter"] = mesh.splitter_line;
  sector.parts = mesh.parts;
  sector.mesh_digest = digest(mesh);
  sector.young = material.young;
  sector.poisson = material.poisson;
  sector.density = material.density;
  return sector;
}

Eigen::VectorXcd on_nodes(const SectorMesh& mesh, const SectorDofs& dofs, const Eigen::VectorXcd& sector_vector) {
  Eigen::VectorXcd values = Eigen::VectorXcd::Zero(3 * mesh.file_node_count());
  for (int node = 0; node < mesh.file_node_count(); ++node)
    if (dofs.first[node] >= 0) values.segment<3>(3 * node) = sector_vector.segment<3>(dofs.first[node]);
  return values;
}

}  // namespace tiprub::reduce
