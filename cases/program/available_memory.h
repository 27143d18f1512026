// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace tiprub {

/// [bytes] that this process may still map under its resource limits (ulimit -d, -v).
double mappable_memory();

/// [bytes] MemAvailable of /proc/meminfo, or less if a control group (versions 1 and 2) or a resource limit leaves
/// less. Unlimited if nothing is known. `root` is where /proc and /sys are.
double available_memory(const std::filesystem::path& root = "/");

}  // namespace tiprub
