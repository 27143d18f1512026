// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "postprocess/figures/drawing.h"

namespace tiprub {

/// Raises RunError if gnuplot can't be started.
void require_gnuplot();

/// Draws name.svg and name.png for each drawing in the folder, with at most `jobs` processes at a time, and calls
/// `drawn` after each. Raises RunError with gnuplot's own words if one fails or leaves no picture, Interrupted if a
/// signal came; no process outlives the call.
void draw(const std::vector<Drawing>& drawings, const std::filesystem::path& folder, int jobs,
          const std::function<void()>& drawn);

}  // namespace tiprub
