// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/model/fields_file.h"
#include "reduce/sector/rotating_elasticity.h"

namespace tiprub {

/// A sector as fields.h5 holds it, but for its shape under spin.
SectorFields describe_sector(const SectorMesh& mesh, const std::vector<int>& contact, const Material& material);

/// One vector of sector dofs on all nodes: r, theta, z of node 0, then of node 1, ...; zero where clamped.
Eigen::VectorXcd on_nodes(const SectorDofs& dofs, const Eigen::VectorXcd& sector_vector);

}  // namespace tiprub
