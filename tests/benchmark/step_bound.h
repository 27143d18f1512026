// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/march/rotor_at_speed.h"

namespace tiprub::simulate::testing {

/// What this machine does at its best, measured now.
struct MachineRates {
  double flops;  ///< [1/s] multiplications and additions in registers, fused where the processor can
  double bytes;  ///< [1/s] read from what is too large for the innermost cache
};
MachineRates machine_rates();

/// What is counted of a step.
struct StepPart {
  double bytes = 0, flops = 0;

  /// [us] if arithmetic and memory never wait for each other.
  double least(const MachineRates& rates) const;
};

/// A step has two parts, neither of which can begin before the other ends, and no wheel needs less of them:
/// waves: forces to modes, the free step, modes to the nodes' gaps. Of each mode Y, a, b, c, q and q- are read and q+
///        is written once; Y is used for both maps.
/// contact: lambda from a factor of the closed nodes' block of W that is there, and what it does to all gaps; the
///        closed nodes' columns of W and the factor are read once.
/// Nodes and modes are those of the wheel, not of the padding.
struct StepCount {
  StepPart waves, contact;

  double least(const MachineRates& rates) const { return waves.least(rates) + contact.least(rates); }  ///< [us]
};
/// `sectors` that are marched; `closed` nodes among all of them, on average.
StepCount count_step(const RotorAtSpeed& rotor, int sectors, double closed);

}  // namespace tiprub::simulate::testing
