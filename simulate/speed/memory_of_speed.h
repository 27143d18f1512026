// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/scene/scene.h"

namespace tiprub {

/// [bytes] an estimate of what a speed holds at its peak: samples, the states of a cycle, and the revolutions by
/// which its motion is judged.
double memory_of_speed(const Scene& scene);

/// Raises RunError, with both numbers, if so many speeds at once need more than there is.
void require_memory(const Scene& scene, int threads, double available);

}  // namespace tiprub
