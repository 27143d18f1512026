// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "simulate/scene/scene.h"
#include "simulate/sweep/finished_speeds.h"
#include "simulate/sweep/sweep_tally.h"

namespace tiprub {

/// response.h5 from finished speeds [rad/s], ascending, with the natural frequencies of the model that was marched
/// and the branches; then the finished speeds go. Raises RunError, and writes nothing, if all speeds failed.
SweepTally assemble_response(const Scene& scene, const std::vector<double>& speeds,
                             const std::vector<OrbitBranch>& branches, int threads, FinishedSpeeds& finished,
                             const std::filesystem::path& output);

}  // namespace tiprub
