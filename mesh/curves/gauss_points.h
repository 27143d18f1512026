// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace tiprub {

/// A point of a quadrature rule on [-1, 1]. Not Boost's Gauss rules: 1.74 computes those of few points at run time,
/// and one weight of five and one of three differ from these in the last bit, which would move the nodes of every
/// mesh.
struct GaussPoint {
  double x;
  double weight;
};

/// Exact for polynomials of degree 5.
inline constexpr std::array<GaussPoint, 3> gauss_3 = {
    {{-0.7745966692414834, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {0.7745966692414834, 5.0 / 9.0}}};

/// Exact for polynomials of degree 9.
inline constexpr std::array<GaussPoint, 5> gauss_5 = {{{-0.9061798459386640, 0.2369268850561891},
                                                       {-0.5384693101056831, 0.4786286704993665},
                                                       {0.0, 128.0 / 225.0},
                                                       {0.5384693101056831, 0.4786286704993665},
                                                       {0.9061798459386640, 0.2369268850561891}}};

}  // namespace tiprub
