// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/operators/sector_factor.h"
#include "reduce/sector/reduction_parameters.h"
#include "reduce/sector/sector_dofs.h"
#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// The numbers of large objects that a reduction holds at the same time.
struct Holdings {
  int factors = 0;        ///< factors of the sector's K
  int stiffnesses = 0;    ///< sparse matrices K of the sector
  int columns = 0;        ///< complex vectors of each nodal diameter at work
  double mesh_error = 0;  ///< [bytes] memory of a MeshErrorEstimate
  int threads = 1;        ///< threads, each with a nodal diameter
};

/// The memory that a reduction will need at its peak [bytes], estimated before it starts.
struct MemoryNeed {
  double factor = 0;    ///< CHOLMOD's L for each speed, S, and the dense factors of a nodal diameter
  double bases = 0;     ///< vectors of the nodal diameters at work, and those of a solution with a factor
  double matrices = 0;  ///< sparse K and M, cells for the error of the mesh, and the program itself
  double threads = 0;  ///< address space of the threads' stacks and of the buffers of the BLAS, most of it never used
  double sparse_factor = 0;  ///< L for one speed, part of `factor`
  double interface = 0;      ///< one dense matrix of interface dofs
  int factors = 0;

  /// `factor` for a method of factorization. MUMPS also holds its workspace, which includes two matrices of interface
  /// dofs; with factors and S on disk it includes one, is held only while it factorizes, and leaves buffers.
  double factor_by(FactorMethod method) const;
  double total(FactorMethod method = FactorMethod::cholmod) const { return factor_by(method) + bases + matrices; }
  /// [bytes] The size of the files that MUMPS writes.
  double on_disk(FactorMethod method) const;
};

/// Estimates the memory. The size of a factor comes from CHOLMOD's symbolic analysis of the graph of nodes, each of
/// whose entries is a 3 x 3 block of dofs; this costs a ninth of an analysis of the dofs, and little compared with a
/// factorization. The estimate is an upper bound: reductions of 12,000 to 112,000 dofs, on one and two threads,
/// needed 0.70 to 0.83 of it.
MemoryNeed memory_need(const SectorMesh& mesh, const SectorDofs& dofs, const Holdings& held);

/// Raises RunError, with the numbers, if the need exceeds the available memory [bytes], or if the need including the
/// threads exceeds the memory that may be mapped [bytes].
void require_memory(const MemoryNeed& need, FactorMethod method, double available, double mappable);

/// The method for [reduce] factorization that fits into the memory or, if none does, the one that needs least.
FactorMethod choose_method(const MemoryNeed& need, Factorization wanted, double available, double mappable);

/// The same for the memory of this machine, which `processes` share. Raises RunError if memory or disk do not
/// suffice.
FactorMethod choose_method(const MemoryNeed& need, const ReductionParameters& parameters, int processes = 1);

/// Checks that the memory suffices, and starts the threads of the BLAS. Nothing may call the BLAS earlier: if a limit
/// leaves no room for a buffer, OpenBLAS tries for ever to map it.
void start_threads(const MemoryNeed& need, FactorMethod method, int threads);

}  // namespace tiprub::reduce
