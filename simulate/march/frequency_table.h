// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/model/reduced_model.h"
#include "simulate/motion/motion.h"
#include "simulate/scene/damping.h"

namespace tiprub {

/// Number of speeds in the table. The squares of the frequencies are nearly polynomials in Omega^2 (eq. 11); cubics
/// between 33 speeds are exact to 1e-5 of the frequency on the wheel of the demo.
constexpr int frequency_speeds = 33;

/// The natural frequencies of the model as it is marched (modes_at_speed), at `frequency_speeds` evenly spaced speeds
/// from 0 to speed_max [rad/s]. Frequencies are negative where the rotor is statically unstable. Each speed and nodal
/// diameter costs a condensation and the eigenvalues of a dense Hermitian pencil. The result does not depend on the
/// number of threads.
FrequencyTable frequency_table(const ReducedModel& model, const Damping& damping, double speed_max, int threads);

}  // namespace tiprub
