// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cases/program/progress.h"
#include "simulate/response/response.h"
#include "simulate/scene/scene.h"
#include "simulate/sweep/finished_speeds.h"

namespace tiprub {

/// The branches through the orbits at a sweep's examined speeds, of `speeds` [rad/s]: those that attract and those
/// that repel. A speed whose motion lies on a branch already followed begins none; nor does one near whose march from
/// rest there is no orbit. None if [simulate] branches does not ask for them, or the sweep goes up or down.
std::vector<OrbitBranch> follow_branches(const Scene& scene, const std::vector<double>& speeds,
                                         const FinishedSpeeds& finished, Progress::Shown shown);

}  // namespace tiprub
