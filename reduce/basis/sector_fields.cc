// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/basis/sector_fields.h"

namespace tiprub {

SectorFields describe_sector(const SectorMesh& mesh, const std::vector<int>& contact, const Material& material) {
  SectorFields sector;
  sector.sector_count = mesh.sector_count;
  sector.nodes = mesh.nodes;
  sector.cells = mesh.cells;
  sector.node_sets = {{"clamped", mesh.clamped},
                      {"contact", contact},
                      {"contact_line", mesh.contact_line},
                      {"cyclic_low", mesh.cyclic_low},
                      {"cyclic_high", mesh.cyclic_high}};
  sector.parts = mesh.parts;
  sector.mesh_digest = digest(mesh);
  sector.young = material.young;
  sector.poisson = material.poisson;
  sector.density = material.density;
  return sector;
}

Eigen::VectorXcd on_nodes(const SectorDofs& dofs, const Eigen::VectorXcd& sector_vector) {
  Eigen::VectorXcd values = Eigen::VectorXcd::Zero(3 * static_cast<Eigen::Index>(dofs.first.size()));
  for (std::size_t node = 0; node < dofs.first.size(); ++node)
    if (dofs.first[node] >= 0)
      values.segment<3>(3 * static_cast<Eigen::Index>(node)) = sector_vector.segment<3>(dofs.first[node]);
  return values;
}

}  // namespace tiprub
