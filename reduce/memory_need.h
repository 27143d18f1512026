// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "reduce/sector_dofs.h"
#include "reduce/sector_mesh.h"

namespace tiprub {

/// What a reduction will hold at its peak [bytes], before it starts.
struct MemoryNeed {
  double factor = 0;    ///< L of one speed, its interface part, and a nodal diameter's dense factors
  double bases = 0;     ///< shapes of all nodal diameters, and the vectors of the eigensolvers
  double matrices = 0;  ///< sparse K and M, and the shape functions at the Gauss points

  double total() const { return factor + bases + matrices; }
};

/// An estimate, some 5 to 20 % below what was measured (0.25 GiB for 0.3 with 7,653 dofs, 6.0 for at least 6.3 with
/// the sector of cases/impeller). The factor's size comes from CHOLMOD's symbolic analysis of the graph of nodes:
/// each of its entries is a 3 x 3 block of dofs. Costs a ninth of the analysis of the dofs, which is little beside a
/// factorization. `shapes` is the number of columns that a nodal diameter keeps, `threads` how many are solved at
/// once.
MemoryNeed memory_need(const SectorMesh& mesh, const SectorDofs& dofs, int shapes, int threads);

/// [bytes] MemAvailable of /proc/meminfo, or less if a control group (versions 1 and 2) or a resource limit of this
/// process (ulimit -d, -v) leaves less. Unlimited if nothing is known. `root` is where /proc and /sys are.
double available_memory(const std::filesystem::path& root = "/");

/// Raises RunError with both numbers if the need is more than what there is.
void require_memory(const MemoryNeed& need, double available);

}  // namespace tiprub
