// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/wave_kernels.h"

#include "cases/program/vector_lanes.h"

namespace tiprub::simulate::kernels {

namespace {

constexpr std::size_t eight = 8;
constexpr std::size_t node_group = 4;
static_assert(mode_block == 2 * eight && lane_count == node_group);

/// Sums of eight products over modes, in the registers of eight modes: each of their lanes is a sum of its own.
template <class Set>
struct Sums {
  Avx512::Register all[eight] = {};
};
template <>
struct Sums<Avx> {
  Lanes4 low[eight] = {}, high[eight] = {};
};

/// The sums over the lanes of eight vectors, in order: of the first four, and of the others.
TIPRUB_INLINE void sum_lanes(const Sums<Avx512>& sums, Lanes4& first, Lanes4& last) {
  const auto& v = sums.all;
  Avx512::Register pairs[4];
  for (std::size_t i = 0; i < 4; ++i)
    pairs[i] = __builtin_shufflevector(v[2 * i], v[2 * i + 1], 0, 8, 2, 10, 4, 12, 6, 14) +
               __builtin_shufflevector(v[2 * i], v[2 * i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  Avx512::Register fours[2];
  for (std::size_t i = 0; i < 2; ++i)
    fours[i] = __builtin_shufflevector(pairs[2 * i], pairs[2 * i + 1], 0, 1, 8, 9, 4, 5, 12, 13) +
               __builtin_shufflevector(pairs[2 * i], pairs[2 * i + 1], 2, 3, 10, 11, 6, 7, 14, 15);
  const Avx512::Register all = __builtin_shufflevector(fours[0], fours[1], 0, 1, 2, 3, 8, 9, 10, 11) +
                               __builtin_shufflevector(fours[0], fours[1], 4, 5, 6, 7, 12, 13, 14, 15);
  first = __builtin_shufflevector(all, all, 0, 1, 2, 3);
  last = __builtin_shufflevector(all, all, 4, 5, 6, 7);
}

TIPRUB_INLINE void sum_fours(const Lanes4* v, Lanes4& sums) {
  const Lanes4 one =
                   __builtin_shufflevector(v[0], v[1], 0, 4, 2, 6) + __builtin_shufflevector(v[0], v[1], 1, 5, 3, 7),
               two =
                   __builtin_shufflevector(v[2], v[3], 0, 4, 2, 6) + __builtin_shufflevector(v[2], v[3], 1, 5, 3, 7);
  sums = __builtin_shufflevector(one, two, 0, 1, 4, 5) + __builtin_shufflevector(one, two, 2, 3, 6, 7);
}
TIPRUB_INLINE void sum_lanes(const Sums<Avx>& sums, Lanes4& first, Lanes4& last) {
  Lanes4 low, high;
  sum_fours(sums.low, low);
  sum_fours(sums.high, high);
  first = low + high;
  sum_fours(sums.low + 4, low);
  sum_fours(sums.high + 4, high);
  last = low + high;
}

/// Adds the products of `count` nodes, at most four, whose shapes begin at `shapes`: the real parts of four nodes,
/// then the imaginary parts.
template <std::size_t count, class Set>
TIPRUB_INLINE void add_travelling(const double* shapes, const double* q_re, const double* q_im, std::size_t modes,
                                  std::size_t nodes, typename Set::Register (&sums)[eight]) {
  for (std::size_t m = 0; m < modes; m += mode_block, shapes += 2 * mode_block * nodes)
    for (std::size_t half = 0; half < mode_block; half += eight) {
      const typename Set::Register re = lanes<Set>(q_re + m + half), im = lanes<Set>(q_im + m + half);
      for (std::size_t k = 0; k < count; ++k) {
        const double* own = shapes + 2 * mode_block * k + half;
        typename Set::Register y_re, y_im;
        read_once<Set>(own, y_re);
        read_once<Set>(own + mode_block, y_im);
        sums[k] += y_re * re;
        sums[4 + k] += y_re * im;
        sums[k] -= y_im * im;
        sums[4 + k] += y_im * re;
      }
    }
}

/// The two halves of a block are summed separately, which halves the chain of additions.
template <std::size_t count, class Set>
TIPRUB_INLINE void add_standing(const double* shapes, const double* q, std::size_t modes, std::size_t nodes,
                                typename Set::Register (&sums)[eight]) {
  for (std::size_t m = 0; m < modes; m += mode_block, shapes += mode_block * nodes)
    for (std::size_t half = 0; half < 2; ++half)
      for (std::size_t k = 0; k < count; ++k)
        sums[4 * half + k] += lanes<Set>(shapes + mode_block * k + eight * half) * lanes<Set>(q + m + eight * half);
}

struct Advance {
  template <class Set>
  TIPRUB_INLINE static void run(const double* r, const double* k, const double* increment, double* q, double* next,
                                std::size_t count) {
    for (std::size_t m = 0; m < count; m += eight / Set::registers) {
      const typename Set::Register now = lanes<Set>(q + m), last = lanes<Set>(increment + m);
      const typename Set::Register change = last - lanes<Set>(r + m) * last - lanes<Set>(k + m) * now;
      lanes<Set>(next + m) = change;
      lanes<Set>(q + m) = now + change;
    }
  }
};

/// Calls Kernel::group for one to four nodes, whose number the compiler then knows.
template <class Kernel, class Set, class... Arguments>
TIPRUB_INLINE void do_group(std::size_t nodes_left, Arguments... arguments) {
  switch (nodes_left) {
    case 1:
      return Kernel::template group<Set, 1>(arguments...);
    case 2:
      return Kernel::template group<Set, 2>(arguments...);
    case 3:
      return Kernel::template group<Set, 3>(arguments...);
    default:
      return Kernel::template group<Set, 4>(arguments...);
  }
}

struct ToNodesTravelling {
  template <class Set, std::size_t count>
  TIPRUB_INLINE static void group(const double* shapes, const double* q_re, const double* q_im, std::size_t modes,
                                  std::size_t nodes, double* p_re, double* p_im) {
    Sums<Set> sums;
    if constexpr (Set::registers == 1) {
      add_travelling<count, Set>(shapes, q_re, q_im, modes, nodes, sums.all);
    } else {
      add_travelling<count, Set>(shapes, q_re, q_im, modes, nodes, sums.low);
      add_travelling<count, Set>(shapes + 4, q_re + 4, q_im + 4, modes, nodes, sums.high);
    }
    sum_lanes(sums, lanes4(p_re), lanes4(p_im));
  }

  template <class Set>
  TIPRUB_INLINE static void run(const double* shapes, const double* q_re, const double* q_im, std::size_t modes,
                                std::size_t nodes, double* p_re, double* p_im) {
    for (std::size_t offset = 0; offset < nodes; offset += node_group)
      do_group<ToNodesTravelling, Set>(nodes - offset, shapes + 2 * mode_block * offset, q_re, q_im, modes, nodes,
                                       p_re + offset, p_im + offset);
  }
};

struct ToNodesStanding {
  template <class Set, std::size_t count>
  TIPRUB_INLINE static void group(const double* shapes, const double* q, std::size_t modes, std::size_t nodes,
                                  double* p) {
    Sums<Set> sums;
    if constexpr (Set::registers == 1) {
      add_standing<count, Set>(shapes, q, modes, nodes, sums.all);
    } else {
      add_standing<count, Set>(shapes, q, modes, nodes, sums.low);
      add_standing<count, Set>(shapes + 4, q + 4, modes, nodes, sums.high);
    }
    Lanes4 first, last;
    sum_lanes(sums, first, last);
    lanes4(p) = first + last;
  }

  template <class Set>
  TIPRUB_INLINE static void run(const double* shapes, const double* q, std::size_t modes, std::size_t nodes,
                                double* p) {
    for (std::size_t offset = 0; offset < nodes; offset += node_group)
      do_group<ToNodesStanding, Set>(nodes - offset, shapes + mode_block * offset, q, modes, nodes, p + offset);
  }
};

template <class Set>
TIPRUB_INLINE void take(const Eight<Set>& change, const Modes& modes, std::size_t offset) {
  lanes8<Set>(modes.q + offset) -= change;
  lanes8<Set>(modes.increment + offset) -= change;
}

/// Four sums for each register of a block: the products of real and imaginary parts.
struct AddForceTravelling {
  template <class Set>
  TIPRUB_INLINE static void run(const double* shapes, const double* c, const double* f_re, const double* f_im,
                                const ForcedNodes& forced, std::size_t modes, const Modes& re, const Modes& im) {
    constexpr std::size_t halves = 2 / Set::registers;  // of a block at once, as many as there are registers
    for (std::size_t m = 0; m < modes; m += mode_block, shapes += 2 * mode_block * forced.nodes)
      for (std::size_t first = 0; first < mode_block; first += halves * eight) {
        Eight<Set> rr[halves] = {}, ii[halves] = {}, ri[halves] = {}, ir[halves] = {};
        for (std::size_t i = 0; i < forced.count; ++i) {
          const int k = forced.index[i];
          const double* own = shapes + 2 * mode_block * k + first;
          const double force_re = f_re[k], force_im = f_im[k];
          for (std::size_t half = 0; half < halves; ++half) {
            Eight<Set> y_re, y_im;
            read_once(own + eight * half, y_re);
            read_once(own + mode_block + eight * half, y_im);
            rr[half] += y_re * force_re;
            ii[half] += y_im * force_im;
            ri[half] += y_re * force_im;
            ir[half] += y_im * force_re;
          }
        }
        for (std::size_t half = 0; half < halves; ++half) {
          const std::size_t offset = m + first + eight * half;
          take(lanes8<Set>(c + offset) * (rr[half] + ii[half]), re, offset);
          take(lanes8<Set>(c + offset) * (ri[half] - ir[half]), im, offset);
        }
      }
  }
};

struct AddForceStanding {
  template <class Set>
  TIPRUB_INLINE static void run(const double* shapes, const double* c, const double* f, const ForcedNodes& forced,
                                std::size_t modes, const Modes& re) {
    for (std::size_t m = 0; m < modes; m += mode_block, shapes += mode_block * forced.nodes) {
      Eight<Set> sum[2] = {};
      for (std::size_t i = 0; i < forced.count; ++i)
        for (std::size_t half = 0; half < 2; ++half)
          sum[half] += lanes8<Set>(shapes + mode_block * forced.index[i] + eight * half) * f[forced.index[i]];
      for (std::size_t half = 0; half < 2; ++half) {
        const std::size_t offset = m + eight * half;
        take(lanes8<Set>(c + offset) * sum[half], re, offset);
      }
    }
  }
};

}  // namespace

void advance(const double* r, const double* k, const double* increment, double* q, double* next, std::size_t count) {
  in_eights<Advance>(r, k, increment, q, next, count);
}

void to_nodes_travelling(const double* shapes, const double* q_re, const double* q_im, std::size_t modes,
                         std::size_t nodes, double* p_re, double* p_im) {
  in_eights<ToNodesTravelling>(shapes, q_re, q_im, modes, nodes, p_re, p_im);
}

void to_nodes_standing(const double* shapes, const double* q, std::size_t modes, std::size_t nodes, double* p) {
  in_eights<ToNodesStanding>(shapes, q, modes, nodes, p);
}

void add_force_travelling(const double* shapes, const double* c, const double* f_re, const double* f_im,
                          const ForcedNodes& forced, std::size_t modes, const Modes& re, const Modes& im) {
  in_eights<AddForceTravelling>(shapes, c, f_re, f_im, forced, modes, re, im);
}

void add_force_standing(const double* shapes, const double* c, const double* f, const ForcedNodes& forced,
                        std::size_t modes, const Modes& re) {
  in_eights<AddForceStanding>(shapes, c, f, forced, modes, re);
}

/// Four sums for each vector of rows, which keeps the chains of additions short.
TIPRUB_CLONES
void to_rows_travelling(const double* shapes, const double* q_re, const double* q_im, std::size_t modes,
                        std::size_t width, double* p_re, double* p_im) {
  for (std::size_t k = 0; k < width; k += lane_count) {
    Lanes4 rr = {}, ii = {}, ri = {}, ir = {};
    const double* own = shapes + k;
    for (std::size_t m = 0; m < modes; ++m, own += 2 * width) {
      rr += lanes4(own) * q_re[m];
      ii += lanes4(own + width) * q_im[m];
      ri += lanes4(own) * q_im[m];
      ir += lanes4(own + width) * q_re[m];
    }
    lanes4(p_re + k) = rr - ii;
    lanes4(p_im + k) = ri + ir;
  }
}

TIPRUB_CLONES
void to_rows_standing(const double* shapes, const double* q, std::size_t modes, std::size_t width, double* p) {
  for (std::size_t k = 0; k < width; k += lane_count) {
    Lanes4 sum = {};
    for (std::size_t m = 0; m < modes; ++m) sum += lanes4(shapes + m * width + k) * q[m];
    lanes4(p + k) = sum;
  }
}

TIPRUB_CLONES
bool gap_of_sector(const double* clearance, const double* distortion, double ramp, const double* displacement,
                   std::size_t width, double* gap) {
  int negative = 0;
  for (std::size_t k = 0; k < width; ++k) {
    gap[k] = clearance[k] - ramp * distortion[k] - displacement[k];
    negative |= gap[k] < 0 ? 1 : 0;
  }
  return negative != 0;
}

TIPRUB_CLONES
void add_waves(const double* p, const double* phases, std::size_t waves, std::size_t width, double* displacement) {
  for (std::size_t k = 0; k < width; k += lane_count) {
    Lanes4 real = {}, imaginary = {};
    for (std::size_t w = 0; w < waves; ++w) {
      real += lanes4(p + 2 * w * width + k) * phases[2 * w];
      imaginary += lanes4(p + (2 * w + 1) * width + k) * phases[2 * w + 1];
    }
    lanes4(displacement + k) = real - imaginary;
  }
}

TIPRUB_CLONES
void gather_sectors(const double* values, const double* cosine, const double* sine, const int* sectors,
                    std::size_t count, std::size_t width, double* f_re, double* f_im) {
  for (std::size_t k = 0; k < width; k += lane_count) {
    Lanes4 real = {}, imaginary = {};
    for (std::size_t i = 0; i < count; ++i) {
      const Lanes4 value = lanes4(values + width * sectors[i] + k);
      real += value * cosine[sectors[i]];
      imaginary -= value * sine[sectors[i]];
    }
    lanes4(f_re + k) = real;
    lanes4(f_im + k) = imaginary;
  }
}

}  // namespace tiprub::simulate::kernels
