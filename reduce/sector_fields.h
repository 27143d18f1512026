// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "reduce/model/fields_file.h"
#include "reduce/sector/rotating_elasticity.h"
#include "reduce/sector/sector_dofs.h"
#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// A sector as fields.h5 holds it, but for its shape under spin.
SectorFields describe_sector(const SectorMesh& mesh, const std::vector<int>& contact, const Material& material);

/// One vector of sector dofs on all nodes of the file: r, theta, z of node 0, then of node 1, ...; zero where
/// clamped.
Eigen::VectorXcd on_nodes(const SectorMesh& mesh, const SectorDofs& dofs, const Eigen::VectorXcd& sector_vector);

}  // namespace tiprub::reduce
