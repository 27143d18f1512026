// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/operators/sector_factor.h"
#include "reduce/sector/reduction_parameters.h"
#include "reduce/sector/sector_dofs.h"
#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// The numbers of large objects that a reduction holds at the same time.
struct Holdings {
  int factors = 0;        ///< of the sector's K
  int stiffnesses = 0;    ///< sparse K of the sector
  int columns = 0;        ///< complex vectors of a nodal diameter
  double mesh_error = 0;  ///< [bytes] of a MeshErrorEstimate
  int threads = 1;        ///< nodal diameters at work
};

/// What a reduction will hold at its peak [bytes], before it starts.
struct MemoryNeed {
  double factor = 0;    ///< L by CHOLMOD of each speed, S, and a nodal diameter's dense factors
  double bases = 0;     ///< vectors of the nodal diameters at work, and those in a solve with a factor
  double matrices = 0;  ///< sparse K and M, cells for the error of the mesh, and the program itself
  double threads = 0;   ///< address space of their stacks and of the BLAS's buffers, most of which is never touched
  double sparse_factor = 0;  ///< L of one speed, part of `factor`
  double interface = 0;      ///< one dense matrix of interface dofs
  int factors = 0;

  /// `factor` by this method: MUMPS also holds its workspace, with two matrices of interface dofs; with factors and S
  /// on disk only while it factorizes, and then buffers.
  double factor_by(FactorMethod method) const;
  double total(FactorMethod method = FactorMethod::cholmod) const { return factor_by(method) + bases + matrices; }
  /// That MUMPS writes.
  double on_disk(FactorMethod method) const;
};

/// An estimate. The size of a factor comes from CHOLMOD's symbolic analysis of the graph of nodes: each of its
/// entries is a 3 x 3 block of dofs. Costs a ninth of the analysis of the dofs, which is little beside a
/// factorization. It is an upper bound: the peaks of reductions of 12,000 to 112,000 dofs, on one and two threads,
/// were 0.70 to 0.83 of it.
MemoryNeed memory_need(const SectorMesh& mesh, const SectorDofs& dofs, const Holdings& held);

/// Raises RunError with both numbers if the need exceeds the available memory, or if the need with its threads
/// exceeds the memory that may be mapped.
void require_memory(const MemoryNeed& need, FactorMethod method, double available, double mappable);

/// The method for [reduce] factorization that fits the memory; if none does, the one that needs least.
FactorMethod choose_method(const MemoryNeed& need, Factorization wanted, double available, double mappable);

/// The same for this machine, which `processes` share. Raises RunError if memory or disk don't suffice.
FactorMethod choose_method(const MemoryNeed& need, const ReductionParameters& parameters, int processes = 1);

/// Requires the memory that the work will take, and starts the BLAS's threads. Nothing may call the BLAS before
/// this: if a limit leaves no room for a buffer, OpenBLAS tries to map it forever.
void start_threads(const MemoryNeed& need, FactorMethod method, int threads);

}  // namespace tiprub::reduce
