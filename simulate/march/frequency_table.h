// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/model/reduced_model.h"
#include "simulate/motion/motion.h"
#include "simulate/scene/damping.h"

namespace tiprub {

/// Speeds of the table: the squares of the frequencies are nearly polynomials of Omega^2 (eq. 11), and cubics between
/// so many are exact to 1e-5 of the frequency on a wheel like the demo's.
constexpr int frequency_speeds = 33;

/// The natural frequencies of the model as it is marched (modes_at_speed) at `frequency_speeds` even speeds 0 ..
/// speed_max [rad/s]. An unstable speed has negative ones. Costs a condensation and the eigenvalues of a dense
/// Hermitian pencil for each speed and nodal diameter; `threads` of them at a time, with the same result.
FrequencyTable frequency_table(const ReducedModel& model, const Damping& damping, double speed_max, int threads);

}  // namespace tiprub
