// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/wheels/wheel.h"

namespace tiprub {

/// The volume of one sector's shape [m^3], without a mesh: the integral of r times the angle that the part takes,
/// over the meridional section. Gauss quadrature between the stations; exact to about 1e-8.
double geometry_volume(const Wheel& wheel);

}  // namespace tiprub
