// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cases/program/process_group.h"
#include "cases/program/progress.h"
#include "reduce/model/fields_file.h"
#include "reduce/model/reduced_model.h"
#include "reduce/operators/sector_factor.h"
#include "reduce/sector/reduction_parameters.h"
#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// The time that a part of the work took.
struct PartOfWork {
  std::string what;
  double wall = 0;       ///< [s]
  double processor = 0;  ///< [s] of all threads
};

/// Sizes, errors and times of a reduction.
struct ReductionReport {
  int newton_steps = 0;        ///< most of all speeds, with nonlinear prestress
  double newton_residual = 0;  ///< [1] largest of all speeds; see spin_equilibrium()
  int sector_dofs = 0;
  double sector_mass = 0;    ///< [kg]
  double memory_needed = 0;  ///< [bytes] estimated
  FactorMethod factor_method = FactorMethod::cholmod;
  double memory_by_cholmod = 0;       ///< [bytes] that it would need
  double memory_available = 0;        ///< [bytes] before the start, for this process
  std::vector<int> generalized_dofs;  ///< by nodal diameter
  std::vector<int> dropped;           ///< by nodal diameter
  std::vector<int> corrections;       ///< number of shapes added for modes between the speeds, by nodal diameter
  int shape_terms = 0;                ///< of the shape under spin; see SpinShape
  bool mesh_error_unknown = false;    ///< the mesh is too coarse to estimate it; see is_known()
  std::vector<PartOfWork> parts;
};

/// Section 3.4 of the paper: K and M of a sector (eq. 3, eq. 5), nodal diameter by nodal diameter (eq. 4, eq. 6)
/// on one Craig-Bampton basis (eq. 8, eq. 9, eq. 10), eq. 7 through K at three speeds or more, and the unreduced
/// frequencies that verify it. Costs two factorizations, at rest and at Omega_max, for all nodal diameters and all
/// speeds. Raises RunError for an unstable rotor, with the speed. If `fields` is given, the basis on all nodes is
/// written to it as soon as it is known.
///
/// The processes of a group each factorize and share the nodal diameters. All must call this; only the leader gets
/// the model, and gives `fields`.
ReducedModel reduce(const SectorMesh& mesh, const ReductionParameters& parameters, Progress::Shown progress,
                    ReductionReport& report, FieldsWriter* fields, ProcessGroup& group);

/// The size of a sector that can be reduced.
struct CheckedSector {
  int dofs = 0;
  double mass = 0;  ///< [kg]
};

/// Whether a sector can be reduced: contact nodes can be chosen and are free, no cell is inverted. Raises InputError.
CheckedSector check_sector(const SectorMesh& mesh, const ReductionParameters& parameters);

}  // namespace tiprub::reduce
