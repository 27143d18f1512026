// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>

namespace tiprub {

/// [bytes] that this process may still map under its resource limits (ulimit -d, -v).
double mappable_memory();

/// [bytes] MemAvailable of /proc/meminfo, or less if a control group (versions 1 and 2) or a resource limit leaves
/// less. Unlimited if nothing is known. `root` is where /proc and /sys are.
double available_memory(const std::filesystem::path& root = "/");

/// Raises std::bad_alloc if so many bytes can't be had now: for libraries that don't bear to be refused.
void require_memory(std::size_t bytes);

}  // namespace tiprub
