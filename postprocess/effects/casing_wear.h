// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub {

/// How deep a rub would wear the casing; an order of magnitude.
struct CasingWear {
  int node = 0;      ///< contact node whose track is worn most
  double force = 0;  ///< [N] of that node, mean over time and blades
  double depth = 0;  ///< [m] mean over the places of that track that are rubbed
};

/// Archard (1953): the worn volume is (k/H) F s, with k/H the `coefficient` [m^2/N], F the normal force and s the way
/// that is slid. At contact node k all N blades rub the same track of the casing, as wide as the node's share w of
/// the tip line's length (half way to its neighbours); of its circumference the share phi is rubbed at all. In the
/// time t [s] each blade slides r Omega t there, so that the depth is
///
///     (k/H) N F Omega t/(2 pi phi w),
///
/// whatever the radius. Forces stay what they are in a casing that doesn't wear.
CasingWear casing_wear(const SpeedResponse& response, const SimulatedScene& scene, const ContactLine& contact,
                       double coefficient, double time);

}  // namespace tiprub
