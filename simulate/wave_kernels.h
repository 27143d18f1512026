// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace tiprub::kernels {

/// Contact nodes are padded to whole vectors of this many doubles, modes to twice as many.
constexpr std::size_t lane_count = 4;
constexpr std::size_t mode_block = 8;

/// The inner loops of the march, in real arithmetic on split real and imaginary parts, compiled for several
/// instruction sets and chosen when the program starts. No sum is reordered at run time: same machine, same bits.

/// next = a q - b previous, over `count` modes.
void advance(const double* a, const double* b, const double* q, const double* previous, double* next,
             std::size_t count);

/// p = Y q. `rows`: for each mode the real parts of its column of Y over `width` nodes, then (travelling only) the
/// imaginary parts.
void to_nodes_travelling(const double* rows, const double* q_re, const double* q_im, std::size_t modes,
                         std::size_t width, double* p_re, double* p_im);
void to_nodes_standing(const double* rows, const double* q, std::size_t modes, std::size_t width, double* p);

/// q -= c Y^H f over the nodes listed. `columns`: for each node the real parts of its row of Y over `modes` (a
/// multiple of mode_block), then (travelling only) the imaginary parts.
void add_force_travelling(const double* columns, const double* c, const double* f_re, const double* f_im,
                          const int* nodes, std::size_t node_count, std::size_t modes, double* q_re, double* q_im);
void add_force_standing(const double* columns, const double* c, const double* f, const int* nodes,
                        std::size_t node_count, std::size_t modes, double* q);

/// gap = clearance - ramp * distortion - displacement over `width` nodes; whether any is negative.
bool gap_of_sector(const double* clearance, const double* distortion, double ramp, const double* displacement,
                   std::size_t width, double* gap);

/// displacement += cosine * p_re - sine * p_im over `width` nodes.
void add_wave(const double* p_re, const double* p_im, double cosine, double sine, std::size_t width,
              double* displacement);

}  // namespace tiprub::kernels
