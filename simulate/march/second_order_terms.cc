// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/second_order_terms.h"

#include <numbers>

#include "cases/program/vector_lanes.h"

namespace tiprub::simulate {

namespace {

constexpr std::size_t lanes = 4;
constexpr double full_turn = 2 * std::numbers::pi;

struct Terms {
  const double *doubled, *turns, *first, *second;  ///< the latter two: d' and d'' of the phase
  std::size_t coordinates, width;
};

TIPRUB_CLONES bool narrow_gaps(const Terms& terms, const double* y, double grown, double* gap) {
  const std::size_t p = terms.coordinates, width = terms.width;
  using Signs [[gnu::vector_size(lanes * sizeof(long long))]] = long long;
  Signs negative = {};
  for (std::size_t k = 0; k < width; k += lanes) {
    Lanes4 narrowed = {}, turn = {};
    const double* doubled = terms.doubled + k;
    for (std::size_t a = 0; a < p; ++a, doubled += p * width) {
      Lanes4 of_a = 0.5 * y[a] * lanes4(doubled + a * width);
      for (std::size_t b = a + 1; b < p; ++b) of_a += y[b] * lanes4(doubled + b * width);
      narrowed += y[a] * of_a;
      turn += y[a] * lanes4(terms.turns + a * width + k);
    }
    narrowed += grown * turn * (lanes4(terms.first + k) + 0.5 * turn * lanes4(terms.second + k));
    Lanes4& left = lanes4(gap + k);
    left -= narrowed;
    negative |= left < 0;
  }
  return (negative[0] | negative[1] | negative[2] | negative[3]) != 0;
}

TIPRUB_CLONES void slopes_of_gaps(const Terms& terms, const double* y, double grown, double* columns,
                                  std::size_t stride) {
  const std::size_t p = terms.coordinates, width = terms.width;
  for (std::size_t k = 0; k < width; k += lanes) {
    Lanes4 turn = {};
    for (std::size_t a = 0; a < p; ++a) turn += y[a] * lanes4(terms.turns + a * width + k);
    const Lanes4 tilt = grown * (lanes4(terms.first + k) + turn * lanes4(terms.second + k));
    const double* doubled = terms.doubled + k;
    for (std::size_t a = 0; a < p; ++a) {
      Lanes4 slope = tilt * lanes4(terms.turns + a * width + k);
      for (std::size_t b = 0; b < p; ++b, doubled += width) slope += y[b] * lanes4(doubled);
      lanes4(columns + a * stride + k) = slope;
    }
  }
}

/// d' [m] and d'' [m] of the distortion over a tip, by differences.
Eigen::Vector2d derivatives(const Obstacle& obstacle, int tip, double turn) {
  const double step = 1e-4 * full_turn / obstacle.lobes();
  const double before = obstacle.distortion(tip, turn - step), here = obstacle.distortion(tip, turn),
               after = obstacle.distortion(tip, turn + step);
  return {(after - before) / (2 * step), (after - 2 * here + before) / (step * step)};
}

}  // namespace

SecondOrderTerms::SecondOrderTerms(const ContactLine& tips, const Obstacle& obstacle, int steps_per_revolution,
                                   std::size_t width)
    : coordinates_(static_cast<std::size_t>(tips.second_order->coordinates.cols())),
      width_(width),
      doubled_(coordinates_ * coordinates_ * width, 0.0),
      turns_(coordinates_ * width, 0.0) {
  const SecondOrderGap& terms = *tips.second_order;
  const Eigen::MatrixXd &V = terms.coordinates, told = V * (V.transpose() * V).inverse();
  for (int k = 0; k < tips.size(); ++k) {
    const Eigen::Vector3d normal = tips.normal.row(k), along = normal.cross(Eigen::Vector3d::UnitY()).normalized();
    const Eigen::RowVectorXd u_theta = told.row(3 * k + 1), u_m = along.transpose() * told.middleRows<3>(3 * k);
    const Eigen::MatrixXd doubled = 2 * terms.displacement[static_cast<std::size_t>(k)] +
                                    terms.curvature(k, 0) * u_theta.transpose() * u_theta +
                                    terms.curvature(k, 1) * u_m.transpose() * u_m;
    for (std::size_t a = 0; a < coordinates_; ++a) {
      turns_[a * width + k] = u_theta[static_cast<Eigen::Index>(a)] / tips.position(k, 0);
      for (std::size_t b = 0; b < coordinates_; ++b)
        doubled_[(a * coordinates_ + b) * width + k] =
            doubled(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
    }
  }
  const std::int64_t phases = steps_per_revolution / obstacle.lobes();
  tilt_.assign(2 * static_cast<std::size_t>(phases) * width, 0.0);
  for (std::int64_t phase = 0; phase < phases; ++phase)
    for (int k = 0; k < tips.size(); ++k) {
      const Eigen::Vector2d tilt =
          derivatives(obstacle, k, full_turn * static_cast<double>(phase) / steps_per_revolution);
      for (int order = 0; order < 2; ++order) tilt_[(2 * phase + order) * width + k] = tilt[order];
    }
}

bool SecondOrderTerms::narrow(const double* y, const Place& place, double* gap) const {
  const double* tilt = tilt_.data() + 2 * place.phase * width_;
  return narrow_gaps({doubled_.data(), turns_.data(), tilt, tilt + width_, coordinates_, width_}, y, place.grown,
                     gap);
}

void SecondOrderTerms::slopes(const double* y, const Place& place, double* columns, std::size_t stride) const {
  const double* tilt = tilt_.data() + 2 * place.phase * width_;
  slopes_of_gaps({doubled_.data(), turns_.data(), tilt, tilt + width_, coordinates_, width_}, y, place.grown, columns,
                 stride);
}

}  // namespace tiprub::simulate
