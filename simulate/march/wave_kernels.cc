// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/wave_kernels.h"

#include "simulate/march/vector_lanes.h"

namespace tiprub::simulate::kernels {

namespace {

constexpr std::size_t eight = 8;
constexpr std::size_t node_group = 4;
static_assert(mode_block == 2 * eight && lane_count == node_group);

/// The sums over the lanes of eight vectors, in order.
TIPRUB_INLINE void sum_lanes(const Lanes8 (&v)[eight], Lanes8& sums) {
  Lanes8 pairs[4];
  for (std::size_t i = 0; i < 4; ++i)
    pairs[i] = __builtin_shufflevector(v[2 * i], v[2 * i + 1], 0, 8, 2, 10, 4, 12, 6, 14) +
               __builtin_shufflevector(v[2 * i], v[2 * i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  Lanes8 fours[2];
  for (std::size_t i = 0; i < 2; ++i)
    fours[i] = __builtin_shufflevector(pairs[2 * i], pairs[2 * i + 1], 0, 1, 8, 9, 4, 5, 12, 13) +
               __builtin_shufflevector(pairs[2 * i], pairs[2 * i + 1], 2, 3, 10, 11, 6, 7, 14, 15);
  sums = __builtin_shufflevector(fours[0], fours[1], 0, 1, 2, 3, 8, 9, 10, 11) +
         __builtin_shufflevector(fours[0], fours[1], 4, 5, 6, 7, 12, 13, 14, 15);
}

/// `count` nodes, at most four, whose shapes begin at `shapes`.
template <std::size_t count>
TIPRUB_INLINE void travelling_group(const double* shapes, const double* q_re, const double* q_im, std::size_t modes,
                                    std::size_t nodes, double* p_re, double* p_im) {
  Lanes8 sums[eight] = {};  // real parts of four nodes, then imaginary parts
  for (std::size_t m = 0; m < modes; m += mode_block, shapes += 2 * mode_block * nodes)
    for (std::size_t half = 0; half < mode_block; half += eight) {
      const Lanes8 re = lanes8(q_re + m + half), im = lanes8(q_im + m + half);
      for (std::size_t k = 0; k < count; ++k) {
        const double* own = shapes + 2 * mode_block * k + half;
        Lanes8 y_re, y_im;
        read_once(own, y_re);
        read_once(own + mode_block, y_im);
        sums[k] += y_re * re;
        sums[4 + k] += y_re * im;
        sums[k] -= y_im * im;
        sums[4 + k] += y_im * re;
      }
    }
  Lanes8 all;
  sum_lanes(sums, all);
  lanes4(p_re) = __builtin_shufflevector(all, all, 0, 1, 2, 3);
  lanes4(p_im) = __builtin_shufflevector(all, all, 4, 5, 6, 7);
}

TIPRUB_INLINE void take(const Lanes8& change, const Modes& modes, std::size_t offset) {
  lanes8(modes.q + offset) -= change;
  lanes8(modes.increment + offset) -= change;
}

/// The two halves of a block are summed separately, which halves the chain of additions.
template <std::size_t count>
TIPRUB_INLINE void standing_group(const double* shapes, const double* q, std::size_t modes, std::size_t nodes,
                                  double* p) {
  Lanes8 sums[eight] = {};
  for (std::size_t m = 0; m < modes; m += mode_block, shapes += mode_block * nodes)
    for (std::size_t half = 0; half < 2; ++half)
      for (std::size_t k = 0; k < count; ++k)
        sums[4 * half + k] += lanes8(shapes + mode_block * k + eight * half) * lanes8(q + m + eight * half);
  Lanes8 all;
  sum_lanes(sums, all);
  lanes4(p) = __builtin_shufflevector(all, all, 0, 1, 2, 3) + __builtin_shufflevector(all, all, 4, 5, 6, 7);
}

}  // namespace

TIPRUB_CLONES
void advance(const double* r, const double* k, const double* increment, double* q, double* next, std::size_t count) {
  for (std::size_t m = 0; m < count; m += eight) {
    const Lanes8 now = lanes8(q + m), last = lanes8(increment + m);
    const Lanes8 change = last - lanes8(r + m) * last - lanes8(k + m) * now;
    lanes8(next + m) = change;
    lanes8(q + m) = now + change;
  }
}

TIPRUB_CLONES
void to_nodes_travelling(const double* shapes, const double* q_re, const double* q_im, std::size_t modes,
                         std::size_t nodes, double* p_re, double* p_im) {
  for (std::size_t offset = 0; offset < nodes; offset += node_group) {
    const double* from = shapes + 2 * mode_block * offset;
    switch (nodes - offset) {
      case 1:
        travelling_group<1>(from, q_re, q_im, modes, nodes, p_re + offset, p_im + offset);
        break;
      case 2:
        travelling_group<2>(from, q_re, q_im, modes, nodes, p_re + offset, p_im + offset);
        break;
      case 3:
        travelling_group<3>(from, q_re, q_im, modes, nodes, p_re + offset, p_im + offset);
        break;
      default:
        travelling_group<4>(from, q_re, q_im, modes, nodes, p_re + offset, p_im + offset);
    }
  }
}

TIPRUB_CLONES
void to_nodes_standing(const double* shapes, const double* q, std::size_t modes, std::size_t nodes, double* p) {
  for (std::size_t offset = 0; offset < nodes; offset += node_group) {
    const double* from = shapes + mode_block * offset;
    switch (nodes - offset) {
      case 1:
        standing_group<1>(from, q, modes, nodes, p + offset);
        break;
      case 2:
        standing_group<2>(from, q, modes, nodes, p + offset);
        break;
      case 3:
        standing_group<3>(from, q, modes, nodes, p + offset);
        break;
      default:
        standing_group<4>(from, q, modes, nodes, p + offset);
    }
  }
}

/// Eight sums at once: the four products of real and imaginary parts, for two vectors of modes.
TIPRUB_CLONES
void add_force_travelling(const double* shapes, const double* c, const double* f_re, const double* f_im,
                          const ForcedNodes& forced, std::size_t modes, const Modes& re, const Modes& im) {
  for (std::size_t m = 0; m < modes; m += mode_block, shapes += 2 * mode_block * forced.nodes) {
    Lanes8 rr[2] = {}, ii[2] = {}, ri[2] = {}, ir[2] = {};
    for (std::size_t i = 0; i < forced.count; ++i) {
      const int k = forced.index[i];
      const double* own = shapes + 2 * mode_block * k;
      const double force_re = f_re[k], force_im = f_im[k];
      for (std::size_t half = 0; half < 2; ++half) {
        Lanes8 y_re, y_im;
        read_once(own + eight * half, y_re);
        read_once(own + mode_block + eight * half, y_im);
        rr[half] += y_re * force_re;
        ii[half] += y_im * force_im;
        ri[half] += y_re * force_im;
        ir[half] += y_im * force_re;
      }
    }
    for (std::size_t half = 0; half < 2; ++half) {
      const std::size_t offset = m + eight * half;
      take(lanes8(c + offset) * (rr[half] + ii[half]), re, offset);
      take(lanes8(c + offset) * (ri[half] - ir[half]), im, offset);
    }
  }
}

TIPRUB_CLONES
void add_force_standing(const double* shapes, const double* c, const double* f, const ForcedNodes& forced,
                        std::size_t modes, const Modes& re) {
  for (std::size_t m = 0; m < modes; m += mode_block, shapes += mode_block * forced.nodes) {
    Lanes8 sum[2] = {};
    for (std::size_t i = 0; i < forced.count; ++i)
      for (std::size_t half = 0; half < 2; ++half)
        sum[half] += lanes8(shapes + mode_block * forced.index[i] + eight * half) * f[forced.index[i]];
    for (std::size_t half = 0; half < 2; ++half) {
      const std::size_t offset = m + eight * half;
      take(lanes8(c + offset) * sum[half], re, offset);
    }
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
