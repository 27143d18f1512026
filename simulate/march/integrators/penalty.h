// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/march/rotor_at_speed.h"

namespace tiprub {

/// [rad/s] the highest frequency with every contact node on a spring kappa [N/m]: the largest eigenvalue of
/// omega^2 + kappa Y^H Y over the rotor's nodal diameters, which is K + kappa C C^T in modes. With fewer closed nodes
/// it is lower (interlacing), so that h omega_max < 2 keeps central differences stable whatever closes. One Hermitian
/// eigenproblem a nodal diameter.
double penalised_omega_max(const RotorAtSpeed& rotor, double stiffness);

}  // namespace tiprub
