// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/wave_kernels.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define TIPRUB_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define TIPRUB_CLONES
#endif

namespace tiprub::kernels {

namespace {

using Lanes [[gnu::vector_size(lane_count * sizeof(double)), gnu::aligned(8), gnu::may_alias]] = double;

inline __attribute__((always_inline)) const Lanes& lanes(const double* from) {
  return *reinterpret_cast<const Lanes*>(from);
}
inline __attribute__((always_inline)) Lanes& lanes(double* from) {
  return *reinterpret_cast<Lanes*>(from);
}

/// Four partial sums a vector of nodes: the chain of additions is one long a mode, not two.
template <std::size_t groups>
inline __attribute__((always_inline)) void travelling_groups(const double* rows, const double* q_re,
                                                             const double* q_im, std::size_t modes, std::size_t width,
                                                             double* p_re, double* p_im) {
  Lanes rr[groups] = {}, ii[groups] = {}, ri[groups] = {}, ir[groups] = {};
  for (std::size_t m = 0; m < modes; ++m, rows += 2 * width) {
    const double re = q_re[m], im = q_im[m];
    for (std::size_t g = 0; g < groups; ++g) {
      const Lanes& y_re = lanes(rows + g * lane_count);
      const Lanes& y_im = lanes(rows + width + g * lane_count);
      rr[g] += y_re * re;
      ii[g] += y_im * im;
      ri[g] += y_re * im;
      ir[g] += y_im * re;
    }
  }
  for (std::size_t g = 0; g < groups; ++g) {
    lanes(p_re + g * lane_count) = rr[g] - ii[g];
    lanes(p_im + g * lane_count) = ri[g] + ir[g];
  }
}

/// Even and odd modes apart, for the same reason.
template <std::size_t groups>
inline __attribute__((always_inline)) void standing_groups(const double* rows, const double* q, std::size_t modes,
                                                           std::size_t width, double* p) {
  Lanes even[groups] = {}, odd[groups] = {};
  for (std::size_t m = 0; m < modes; m += 2, rows += 2 * width)
    for (std::size_t g = 0; g < groups; ++g) {
      even[g] += lanes(rows + g * lane_count) * q[m];
      odd[g] += lanes(rows + width + g * lane_count) * q[m + 1];
    }
  for (std::size_t g = 0; g < groups; ++g) lanes(p + g * lane_count) = even[g] + odd[g];
}

}  // namespace

TIPRUB_CLONES
void advance(const double* a, const double* b, const double* q, const double* previous, double* next,
             std::size_t count) {
  for (std::size_t m = 0; m < count; m += lane_count)
    lanes(next + m) = lanes(a + m) * lanes(q + m) - lanes(b + m) * lanes(previous + m);
}

TIPRUB_CLONES
void to_nodes_travelling(const double* rows, const double* q_re, const double* q_im, std::size_t modes,
                         std::size_t width, double* p_re, double* p_im) {
  std::size_t at = 0;
  for (; at + 3 * lane_count <= width; at += 3 * lane_count)
    travelling_groups<3>(rows + at, q_re, q_im, modes, width, p_re + at, p_im + at);
  for (; at < width; at += lane_count)
    travelling_groups<1>(rows + at, q_re, q_im, modes, width, p_re + at, p_im + at);
}

TIPRUB_CLONES
void to_nodes_standing(const double* rows, const double* q, std::size_t modes, std::size_t width, double* p) {
  std::size_t at = 0;
  for (; at + 3 * lane_count <= width; at += 3 * lane_count) standing_groups<3>(rows + at, q, modes, width, p + at);
  for (; at < width; at += lane_count) standing_groups<1>(rows + at, q, modes, width, p + at);
}

TIPRUB_CLONES
void add_force_travelling(const double* columns, const double* c, const double* f_re, const double* f_im,
                          const int* nodes, std::size_t node_count, std::size_t modes, double* q_re, double* q_im) {
  for (std::size_t m = 0; m < modes; m += mode_block) {
    Lanes re[2] = {}, im[2] = {};
    for (std::size_t i = 0; i < node_count; ++i) {
      const double* column = columns + 2 * modes * nodes[i] + m;
      const double force_re = f_re[nodes[i]], force_im = f_im[nodes[i]];
      for (std::size_t g = 0; g < 2; ++g) {
        const Lanes& y_re = lanes(column + g * lane_count);
        const Lanes& y_im = lanes(column + modes + g * lane_count);
        re[g] += y_re * force_re + y_im * force_im;
        im[g] += y_re * force_im - y_im * force_re;
      }
    }
    for (std::size_t g = 0; g < 2; ++g) {
      const std::size_t at = m + g * lane_count;
      lanes(q_re + at) -= lanes(c + at) * re[g];
      lanes(q_im + at) -= lanes(c + at) * im[g];
    }
  }
}

TIPRUB_CLONES
void add_force_standing(const double* columns, const double* c, const double* f, const int* nodes,
                        std::size_t node_count, std::size_t modes, double* q) {
  for (std::size_t m = 0; m < modes; m += mode_block) {
    Lanes sum[2] = {};
    for (std::size_t i = 0; i < node_count; ++i)
      for (std::size_t g = 0; g < 2; ++g)
        sum[g] += lanes(columns + modes * nodes[i] + m + g * lane_count) * f[nodes[i]];
    for (std::size_t g = 0; g < 2; ++g) lanes(q + m + g * lane_count) -= lanes(c + m + g * lane_count) * sum[g];
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
void add_wave(const double* p_re, const double* p_im, double cosine, double sine, std::size_t width,
              double* displacement) {
  for (std::size_t k = 0; k < width; k += lane_count)
    lanes(displacement + k) += lanes(p_re + k) * cosine - lanes(p_im + k) * sine;
}

}  // namespace tiprub::kernels
