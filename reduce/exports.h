// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "reduce/model/reduced_model.h"
#include "reduce/sector/reduction_parameters.h"
#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// Writes the sector as complete CalculiX decks: `mesh.inp` (nodes, C3D10, C3D15 and C3D20 elements, sets, cyclic
/// symmetry) and one `speed_<rpm>.inp` for each verification speed (except at rest, a static step under spin, with
/// NLGEOM for nonlinear prestress; then the lowest frequencies of every nodal diameter). `folder` is made if it
/// doesn't exist. Raises InputError for cells that CalculiX doesn't have, and RunError if a file can't be
/// written.
void write_calculix_decks(const SectorMesh& mesh, const ReductionParameters& parameters,
                          const std::filesystem::path& folder);

/// Writes the matrices of a model in Matrix Market's array format (Boisvert, Pozo, Remington 1996), one file each:
/// `n<n>_K0.mtx`, `n<n>_K1.mtx`, `n<n>_K2.mtx`, `n<n>_M.mtx` for every nodal diameter n, "hermitian" or, where they
/// are real, "symmetric": the lower triangle by columns, 17 digits, so that they read back bit by bit. `folder` is
/// made if it doesn't exist. Raises RunError if a file can't be written.
void write_matrix_market(const ReducedModel& model, const std::filesystem::path& folder);

}  // namespace tiprub::reduce
