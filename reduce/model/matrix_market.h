// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "reduce/model/reduced_model.h"

namespace tiprub {

/// Writes the matrices of a model in Matrix Market's array format (Boisvert, Pozo, Remington 1996), one file each:
/// `n<n>_K0.mtx`, `n<n>_K1.mtx`, `n<n>_K2.mtx`, `n<n>_M.mtx` for every nodal diameter n, "hermitian" or, where they
/// are real, "symmetric": the lower triangle by columns, 17 digits, so that they read back bit by bit. `folder` is
/// made if it doesn't exist. Raises RunError if a file can't be written.
void write_matrix_market(const ReducedModel& model, const std::filesystem::path& folder);

}  // namespace tiprub
