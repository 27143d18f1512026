// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

/// A function with this mark is compiled for several instruction sets, of which the program chooses the best when it
/// starts. On one machine equal runs give equal bits: no sum is reordered at run time.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define TIPRUB_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define TIPRUB_CLONES
#endif
#define TIPRUB_INLINE inline __attribute__((always_inline))

namespace tiprub::simulate::kernels {

/// Four or eight doubles that are processed together; they may begin at any address.
using Lanes4 [[gnu::vector_size(4 * sizeof(double)), gnu::aligned(8), gnu::may_alias]] = double;
using Lanes8 [[gnu::vector_size(8 * sizeof(double)), gnu::aligned(8), gnu::may_alias]] = double;

TIPRUB_INLINE const Lanes4& lanes4(const double* from) {
  return *reinterpret_cast<const Lanes4*>(from);
}
TIPRUB_INLINE Lanes4& lanes4(double* from) {
  return *reinterpret_cast<Lanes4*>(from);
}
TIPRUB_INLINE const Lanes8& lanes8(const double* from) {
  return *reinterpret_cast<const Lanes8*>(from);
}
TIPRUB_INLINE Lanes8& lanes8(double* from) {
  return *reinterpret_cast<Lanes8*>(from);
}
/// Reads a vector into registers once. Otherwise gcc reads it again for each use, and a loop that uses each vector
/// twice is limited by its reads.
TIPRUB_INLINE void read_once(const double* from, Lanes8& into) {
  into = *reinterpret_cast<const volatile Lanes8*>(from);
}

}  // namespace tiprub::simulate::kernels
