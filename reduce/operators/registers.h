// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tiprub::reduce {

/// Registers of the processor, for loops that are compiled once for each kind. Without AVX-512, GCC would pass those
/// of 64 bytes through memory. They are not a template over the size, because GCC drops `may_alias` of a type that
/// depends on an argument, and the loops would then be wrong.
struct Registers32 {
  using Lanes = double __attribute__((vector_size(32), aligned(alignof(double)), may_alias));
  static constexpr int lanes = 4;
};
struct Registers64 {
  using Lanes = double __attribute__((vector_size(64), aligned(alignof(double)), may_alias));
  static constexpr int lanes = 8;
};

}  // namespace tiprub::reduce
