// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>

namespace tiprub {

/// Whether mpirun or srun started this process, as the environment variables of Open MPI, of MPICH and Intel MPI, and
/// of Slurm's PMIx tell.
inline bool started_together() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

}  // namespace tiprub
