// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace tiprub::simulate::kernels {

/// Contact nodes are padded to multiples of `lane_count`, modes to multiples of `mode_block`, two vectors of eight.
constexpr std::size_t lane_count = 4;
constexpr std::size_t mode_block = 16;

/// The inner loops of the march, in real arithmetic on separate real and imaginary parts.
///
/// `shapes` holds Y in one order for both maps: for each block of modes and each of `nodes` nodes, the real parts of
/// Y over the block, then (for travelling waves) the imaginary parts. The part of Y of one nodal diameter stays in
/// the innermost cache if add_force and the to_nodes of the next step follow each other directly.

/// The free step of StepCoefficients over `count` modes: next = increment - r increment - k q, q += next.
void advance(const double* r, const double* k, const double* increment, double* q, double* next, std::size_t count);

/// p = Y q over `nodes` nodes, written in whole vectors.
void to_nodes_travelling(const double* shapes, const double* q_re, const double* q_im, std::size_t modes,
                         std::size_t nodes, double* p_re, double* p_im);
void to_nodes_standing(const double* shapes, const double* q, std::size_t modes, std::size_t nodes, double* p);

/// The same for a few modes and any rows: for each mode, `shapes` holds the real parts of its rows, padded to
/// `width`, then (for travelling waves) the imaginary parts.
void to_rows_travelling(const double* shapes, const double* q_re, const double* q_im, std::size_t modes,
                        std::size_t width, double* p_re, double* p_im);
void to_rows_standing(const double* shapes, const double* q, std::size_t modes, std::size_t width, double* p);

/// The indices of the nodes that have a force, out of `nodes`.
struct ForcedNodes {
  const int* index;
  std::size_t count;
  std::size_t nodes;
};
/// The coordinates q of some modes, and their increments in the last step.
struct Modes {
  double *q, *increment;
};
/// Subtracts c Y^H f, summed over the listed nodes, from q and from the increment.
void add_force_travelling(const double* shapes, const double* c, const double* f_re, const double* f_im,
                          const ForcedNodes& forced, std::size_t modes, const Modes& re, const Modes& im);
void add_force_standing(const double* shapes, const double* c, const double* f, const ForcedNodes& forced,
                        std::size_t modes, const Modes& re);

/// gap = clearance - ramp * distortion - displacement over `width` nodes. Returns whether any gap is negative.
bool gap_of_sector(const double* clearance, const double* distortion, double ramp, const double* displacement,
                   std::size_t width, double* gap);

/// Sums the waves at one sector: displacement = sum over waves of cosine p_re - sine p_im. For each wave, `p` holds
/// `width` real parts, then `width` imaginary parts, and `phases` its cosine, then its sine.
void add_waves(const double* p, const double* phases, std::size_t waves, std::size_t width, double* displacement);

/// The adjoint of add_waves for one wave: f_re + i f_im = sum over the listed sectors of (cosine - i sine) values.
void gather_sectors(const double* values, const double* cosine, const double* sine, const int* sectors,
                    std::size_t count, std::size_t width, double* f_re, double* f_im);

}  // namespace tiprub::simulate::kernels
