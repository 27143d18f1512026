// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cases/program/case_file.h"
#include "cases/program/command_line.h"
#include "reduce/sector/reduction_parameters.h"

namespace tiprub::reduce {

/// The options of this stage: what it writes besides model.h5, or instead of it, and what it reads. Empty ones were
/// not given.
struct ReduceOptions {
  std::string calculix_folder;           ///< instead
  std::string modes_file;                ///< instead
  std::string matrix_market_folder;      ///< besides
  std::string fields_file;               ///< besides
  std::vector<std::string> matrices;     ///< K, M, nodes.csv in place of sector.msh; none: a mesh
  std::string matrix_dofs;               ///< what their rows are; may be empty
  std::vector<std::string> matrices_at;  ///< "RPM", "K", ...: K at further speeds
  int threads = 0;                       ///< 0: as [reduce] says

  SectorInput input() const { return matrices.empty() ? SectorInput::mesh : SectorInput::matrices; }
};

/// The table that this stage reads from the case, [reduce], with all its values.
std::string reduce_tables(const CaseFile& file, SectorInput input);

/// tiprub-reduce case.toml sector.msh -o model.h5.
void run_reduce(const StageArguments& arguments, const ReduceOptions& options);

}  // namespace tiprub::reduce
