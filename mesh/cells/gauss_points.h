// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

namespace tiprub {

/// A point of a quadrature rule on [-1, 1].
struct GaussPoint {
  double x;
  double weight;
};

/// The rule of 2 to 5 points, exact for polynomials of degree 2 count - 1. Boost's Gauss rules don't serve: version
/// 1.74 computes those of few points at run time, and two of its weights differ from these in the last bit, which
/// would move the nodes of every mesh.
inline std::span<const GaussPoint> gauss_points(int count) {
  static constexpr std::array<GaussPoint, 2> two = {{{-0.5773502691896258, 1.0}, {0.5773502691896258, 1.0}}};
  static constexpr std::array<GaussPoint, 3> three = {
      {{-0.7745966692414834, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {0.7745966692414834, 5.0 / 9.0}}};
  static constexpr std::array<GaussPoint, 4> four = {{{-0.8611363115940526, 0.34785484513745385},
                                                      {-0.3399810435848563, 0.6521451548625462},
                                                      {0.3399810435848563, 0.6521451548625462},
                                                      {0.8611363115940526, 0.34785484513745385}}};
  static constexpr std::array<GaussPoint, 5> five = {{{-0.9061798459386640, 0.2369268850561891},
                                                      {-0.5384693101056831, 0.4786286704993665},
                                                      {0.0, 128.0 / 225.0},
                                                      {0.5384693101056831, 0.4786286704993665},
                                                      {0.9061798459386640, 0.2369268850561891}}};
  if (count == 2) return two;
  if (count == 3) return three;
  if (count == 4) return four;
  return five;
}

}  // namespace tiprub
