// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

/// A function with this mark is compiled for several instruction sets, of which the program chooses the best when it
/// starts. On one machine equal runs give equal bits: no sum is reordered at run time.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define TIPRUB_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#define TIPRUB_TARGET(set) __attribute__((target("arch=" set)))
#define TIPRUB_HAS(set) (__builtin_cpu_supports(set) != 0)
#else
#define TIPRUB_CLONES
#define TIPRUB_TARGET(set)
#define TIPRUB_HAS(set) false
#endif
#define TIPRUB_INLINE inline __attribute__((always_inline))

namespace tiprub {

/// Four doubles that are processed together, in a register of AVX; they may begin at any address. Not [[gnu::...]]:
/// GCC 12 drops the alignment of such a type where a template takes it from its argument.
using Lanes4 = double __attribute__((vector_size(4 * sizeof(double)), aligned(8), may_alias));

TIPRUB_INLINE const Lanes4& lanes4(const double* from) {
  return *reinterpret_cast<const Lanes4*>(from);
}
TIPRUB_INLINE Lanes4& lanes4(double* from) {
  return *reinterpret_cast<Lanes4*>(from);
}

/// The instruction sets that kernels are written for.
struct Avx512 {
  using Register = double __attribute__((vector_size(8 * sizeof(double)), aligned(8), may_alias));
  static constexpr std::size_t registers = 1;  ///< for eight doubles
};
struct Avx {
  using Register = Lanes4;
  static constexpr std::size_t registers = 2;
};

/// Eight doubles that are processed together, in registers of an instruction set. A vector that is wider than the
/// registers would go through memory (gcc 12), which takes twenty times as long.
template <class Set>
struct Eight {
  typename Set::Register part[Set::registers];

  TIPRUB_INLINE Eight& operator+=(const Eight& more) {
    for (std::size_t k = 0; k < Set::registers; ++k) part[k] += more.part[k];
    return *this;
  }
  TIPRUB_INLINE Eight& operator-=(const Eight& less) {
    for (std::size_t k = 0; k < Set::registers; ++k) part[k] -= less.part[k];
    return *this;
  }
  TIPRUB_INLINE Eight& operator*=(const Eight& factor) {
    for (std::size_t k = 0; k < Set::registers; ++k) part[k] *= factor.part[k];
    return *this;
  }
  TIPRUB_INLINE Eight& operator*=(double factor) {
    for (typename Set::Register& one : part) one *= factor;
    return *this;
  }
};
template <class Set>
TIPRUB_INLINE Eight<Set> operator+(Eight<Set> a, const Eight<Set>& b) {
  return a += b;
}
template <class Set>
TIPRUB_INLINE Eight<Set> operator-(Eight<Set> a, const Eight<Set>& b) {
  return a -= b;
}
template <class Set>
TIPRUB_INLINE Eight<Set> operator*(Eight<Set> a, const Eight<Set>& b) {
  return a *= b;
}
template <class Set>
TIPRUB_INLINE Eight<Set> operator*(Eight<Set> a, double b) {
  return a *= b;
}

template <class Set>
TIPRUB_INLINE const Eight<Set>& lanes8(const double* from) {
  return *reinterpret_cast<const Eight<Set>*>(from);
}
template <class Set>
TIPRUB_INLINE Eight<Set>& lanes8(double* from) {
  return *reinterpret_cast<Eight<Set>*>(from);
}
/// One register.
template <class Set>
TIPRUB_INLINE const typename Set::Register& lanes(const double* from) {
  return *reinterpret_cast<const typename Set::Register*>(from);
}
template <class Set>
TIPRUB_INLINE typename Set::Register& lanes(double* from) {
  return *reinterpret_cast<typename Set::Register*>(from);
}
/// Reads a register once. Otherwise gcc reads it again for each use, and a loop that uses each vector twice is
/// limited by its reads.
template <class Set>
TIPRUB_INLINE void read_once(const double* from, typename Set::Register& into) {
  into = *reinterpret_cast<const volatile typename Set::Register*>(from);
}

template <class Set>
TIPRUB_INLINE void read_once(const double* from, Eight<Set>& into) {
  for (std::size_t k = 0; k < Set::registers; ++k) read_once<Set>(from + 8 / Set::registers * k, into.part[k]);
}

template <class Kernel, class... Arguments>
TIPRUB_TARGET("x86-64-v4")
auto in_avx512(Arguments... arguments) {
  return Kernel::template run<Avx512>(arguments...);
}
template <class Kernel, class... Arguments>
TIPRUB_TARGET("x86-64-v3")
auto in_avx(Arguments... arguments) {
  return Kernel::template run<Avx>(arguments...);
}
inline const bool has_avx512 = TIPRUB_HAS("x86-64-v4"), has_avx = TIPRUB_HAS("x86-64-v3");
/// Runs a kernel that processes eight doubles together, `Kernel::run<Set>`, in the best instruction set of this
/// machine. run() must be TIPRUB_INLINE.
template <class Kernel, class... Arguments>
TIPRUB_INLINE auto in_eights(Arguments... arguments) {
  if (has_avx512) return in_avx512<Kernel>(arguments...);
  if (has_avx) return in_avx<Kernel>(arguments...);
  return Kernel::template run<Avx>(arguments...);
}

}  // namespace tiprub
