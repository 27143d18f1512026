// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/model/reduced_model.h"
#include "simulate/march/rotor_at_speed.h"

namespace tiprub::simulate::testing {

/// A wheel as one sector: real modes of all sectors at once, and all their contact nodes. What a plain modal
/// transform marches, which doesn't know cyclic symmetry.
struct WholeRotor {
  RotorAtSpeed rotor;
  ContactLine contact;
};
/// `rotor`: with all nodal diameters and all modes with mass.
WholeRotor whole_rotor(const RotorAtSpeed& rotor, const ContactLine& contact);

}  // namespace tiprub::simulate::testing
