// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cases/program/progress.h"
#include "simulate/response/response.h"
#include "simulate/scene/scene.h"
#include "simulate/sweep/finished_speeds.h"

namespace tiprub::simulate {

/// The branches of orbits, attracting and repelling, through the orbits at the examined ones of `speeds` [rad/s]
/// and at both sides of each jump between them. No
/// branch begins at a speed whose motion lies on another branch, or where no orbit is found near the march from rest.
/// Empty if [simulate] branches does not ask for branches, or if the sweep goes up or down.
std::vector<OrbitBranch> follow_branches(const Scene& scene, const std::vector<double>& speeds,
                                         const FinishedSpeeds& finished, Progress::Shown shown);

}  // namespace tiprub::simulate
