// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>

#include "reduce/model/reduced_model.h"
#include "simulate/scene/casing.h"
#include "simulate/scene/simulate_parameters.h"

namespace tiprub::simulate {

/// The coefficient of friction from which on a contact node jams: under a slowly growing contact force that slides,
/// lambda (nu + mu e_theta), it moves by -lambda (C_NN + mu C_NT) along its normal, with the static compliance C of
/// the wheel. Where this changes its sign, at mu = -C_NN/C_NT, the force pushes the node into the casing, and contact
/// ends only when the blade has deformed beyond what a linear model can say.
struct FrictionLimit {
  double coefficient = std::numeric_limits<double>::infinity();  ///< [1] infinite: no node jams
  int node = 0;                                                  ///< the node that jams first
  double speed = 0;                                              ///< [rad/s] at which it does

  /// "from a friction coefficient of 0.256 on, contact node 1 jams at 1900 rad/s", or that none does.
  std::string text() const;
};

/// The limit at a speed [rad/s]; none if the rotor is statically unstable there. Solves one Hermitian system for each
/// nodal diameter.
FrictionLimit friction_limit(const ReducedModel& model, double speed);
/// The lower one of the limits at standstill and at the model's highest speed.
FrictionLimit friction_limit(const ReducedModel& model);

/// Refuses friction from the limit of a contact node on, and with the paper's contact rule, which pulls. Raises
/// InputError at the key.
void require_friction_that_slides(const CaseTable& table, const Casing& casing, const SimulateParameters& parameters,
                                  const ReducedModel& model);

}  // namespace tiprub::simulate
