// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "simulate/scene/scene.h"
#include "simulate/sweep/finished_speeds.h"
#include "simulate/sweep/sweep_tally.h"

namespace tiprub {

/// response.h5 from a sweep's finished speeds, with the natural frequencies of the model that was marched; then the
/// finished speeds go. Raises RunError, and writes nothing, if all speeds failed.
SweepTally assemble_response(const Scene& scene, int threads, FinishedSpeeds& finished,
                             const std::filesystem::path& output);

}  // namespace tiprub
