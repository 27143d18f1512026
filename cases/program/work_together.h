// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace tiprub {

/// Runs `work` at once on this thread and on up to `threads` - 1 others, and waits for all. With fewer others if the
/// system gives no more (limits on memory or processes): results must not hang on how many there are. Raises what
/// one of them raised, once all have ended.
void work_together(int threads, const std::function<void()>& work);

}  // namespace tiprub
