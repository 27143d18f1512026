// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>

#include "reduce/model/reduced_model.h"
#include "simulate/scene/casing.h"
#include "simulate/scene/simulate_parameters.h"

namespace tiprub::simulate {

/// The coefficient of friction from which on a contact node jams. Under a slowly growing force of sliding contact,
/// -lambda (nu + mu e_theta), the node moves by -lambda (C_NN + mu C_NT) along its normal, where C_NN and C_NT are
/// its static displacements along the normal under unit forces along nu and e_theta. From mu = -C_NN/C_NT on, if C_NT
/// < 0, the force pushes the node into the casing, and contact ends only when the blade has deformed beyond the range
/// of a linear model.
///
/// Assumes a single loaded node that slides along e_theta, and all modes of the model. The march applies friction to
/// the resolved modes only (WaveModes::sliding_rows).
struct FrictionLimit {
  double coefficient = std::numeric_limits<double>::infinity();  ///< [1] infinite if no node jams
  int node = 0;                                                  ///< the node that jams first
  double speed = 0;                                              ///< [rad/s] the speed at which it jams

  /// "from a friction coefficient of 0.256 on, contact node 1 (from 0) jams at ...", or that no node jams.
  std::string text() const;
};

/// The lowest limit of all nodes, at standstill and at the highest speed of the model; none at a speed at which the
/// rotor is statically unstable. Solves one Hermitian system for each nodal diameter.
FrictionLimit friction_limit(const ReducedModel& model);

/// Refuses a coefficient of friction at or above the limit of its contact node, and friction with the paper's contact
/// rule, whose forces may pull. Raises InputError at the key.
void require_friction_that_slides(const CaseTable& table, const Casing& casing, const SimulateParameters& parameters,
                                  const ReducedModel& model);

}  // namespace tiprub::simulate
