// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace tiprub {

/// The widest vectors that a processor, and its system, can compute with.
enum class Vectors {
  none,   ///< nothing beyond SSE
  avx,    ///< AVX
  avx2,   ///< AVX2 and FMA
  avx512  ///< AVX-512 F, DQ, BW, VL and CD
};

/// Of this processor, by its feature flags (cpuid), as far as the system keeps its registers.
Vectors vectors_of_processor();

/// The kernels that are better than those that OpenBLAS `taken`, by OpenBLAS's names; empty: none are, or these are
/// unknown here.
std::string better_kernels(const std::string& taken, Vectors processor);

/// What OpenBLAS works with.
struct BlasKernels {
  std::string description;  ///< the library's own words, its kernels' name among them; empty: no OpenBLAS in here
  std::string warning;      ///< of generic kernels; empty: they aren't
};

/// Lets OpenBLAS take the best kernels that the processor can run; call it before any other thread works.
///
/// OpenBLAS chooses by the processor's model as it is loaded. Of an Intel processor that it doesn't know, 0.3.21 may
/// take the generic kernels of any 64-bit processor ("Prescott"; family 6, models 183 and 207 among them), which are
/// half as fast. It is made to choose again, told by the name. Why not a new start with OPENBLAS_CORETYPE set: a
/// program that loads gmsh and MPI needs 0.2 s for it. A user's OPENBLAS_CORETYPE is left alone.
BlasKernels choose_blas_kernels();

/// [bytes] that OpenBLAS takes for a thread to work in; 0 without it. Refused, it asks again and again, and never
/// comes back: see first whether they can be had.
std::size_t blas_working_space();
/// Lets it take them, once its kernels are chosen.
void reserve_blas_space();

}  // namespace tiprub
