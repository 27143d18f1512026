// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace tiprub {

/// Calls body(0) .. body(count - 1) from up to `threads` threads, each index once. The BLAS runs on one thread
/// meanwhile. Results must not depend on the order. The first exception is raised again here, after all have stopped.
void parallel_for(int count, int threads, const std::function<void(int)>& body);

}  // namespace tiprub
