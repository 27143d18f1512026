// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub {
namespace {

constexpr double rounding = 1e-12;

/// Contact unknowns on a main blade and on a splitter.
ContactLine line_of(ContactKind kind, int main, int splitter) {
  ContactLine line;
  line.kind = kind;
  line.splitter_nodes = splitter;
  line.arc_length.setZero(main + splitter);
  return line;
}

/// Blades of one contact node, whose paths have different radii and middles.
TEST(BladeExcursions, AreThoseOfEachBlade) {
  const std::vector<double> radii = {4e-3, 1e-3, 2e-3, 3e-3};
  constexpr int samples = 12;
  Eigen::MatrixXd displacement = Eigen::MatrixXd::Constant(samples, 12, 0.1);
  for (int s = 0; s < samples; ++s)
    for (std::size_t j = 0; j < radii.size(); ++j) {
      const double turn = 2 * std::numbers::pi * s / samples;
      displacement.block<1, 2>(s, 3 * static_cast<int>(j)) += radii[j] * Eigen::RowVector2d(cos(turn), sin(turn));
    }
  const ContactLine node = line_of(ContactKind::points, 1, 0);
  const BladeExcursions four = blade_excursions(displacement, node),
                        three = blade_excursions(displacement.leftCols(9), node);
  EXPECT_NEAR(four.least, 1e-3, rounding);
  EXPECT_NEAR(four.median, 2.5e-3, rounding);
  EXPECT_NEAR(four.largest, 4e-3, rounding);
  EXPECT_NEAR(three.median, 2e-3, rounding);
  EXPECT_NEAR(largest_excursion(displacement, node), four.largest, rounding);
}

/// The means of a function over the segments of a tip of length 1: with hats on equal steps, half of one at each end.
template <class Function>
std::vector<double> means_of(const Function& value, int segments) {
  constexpr int places = 20000;
  std::vector<double> sums(static_cast<std::size_t>(segments)), weights(sums.size());
  for (int i = 0; i < places; ++i) {
    const double s = (i + 0.5) / places;
    for (std::size_t k = 0; k < sums.size(); ++k) {
      const double away = std::abs(s * std::max(segments - 1, 1) - static_cast<double>(k));
      const double hat = segments == 1 ? 1 : std::max(0.0, 1 - away);
      weights[k] += hat;
      sums[k] += hat * value(s);
    }
  }
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] /= weights[k];
  return sums;
}

/// All segments swing along theta, in phase, by the means of a shape.
Eigen::MatrixXd swinging(const std::vector<double>& means) {
  constexpr int samples = 8;
  Eigen::MatrixXd displacement = Eigen::MatrixXd::Zero(samples, 3 * static_cast<Eigen::Index>(means.size()));
  for (int s = 0; s < samples; ++s)
    for (std::size_t k = 0; k < means.size(); ++k)
      displacement(s, 3 * static_cast<Eigen::Index>(k) + 1) = means[k] * std::cos(2 * std::numbers::pi * s / samples);
  return displacement;
}

/// Shapes that the extrapolation holds exactly have their largest value at an edge, which no mean reaches.
TEST(BladeExcursions, ReachTheEdgesOfBladesOnSegments) {
  constexpr double integration = 1e-6;
  const auto constant = [](double) { return 2.0; };
  const auto line = [](double s) { return 1 + 3 * s; };
  const auto parabola = [](double s) { return 5 - 7 * s + 3 * s * s; };
  const auto farthest = [](const auto& shape, int segments) {
    return largest_excursion(swinging(means_of(shape, segments)), line_of(ContactKind::segments, segments, 0));
  };
  EXPECT_NEAR(farthest(constant, 1), 2, integration);
  for (const int segments : {2, 3, 4, 14}) EXPECT_NEAR(farthest(line, segments), 4, integration) << segments;
  for (const int segments : {4, 5, 14}) EXPECT_NEAR(farthest(parabola, segments), 5, integration) << segments;
}

/// The edges of a splitter are its own, although its segments follow those of the main blade.
TEST(BladeExcursions, ReachTheEdgesOfSplitters) {
  constexpr double integration = 1e-6;
  for (const double slope : {-1.0, 1.0}) {
    std::vector<double> means = means_of([](double) { return 1.0; }, 4);
    const auto tilted = [slope](double s) { return 3 + slope * (s - 0.5); };
    for (const double mean : means_of(tilted, 5)) means.push_back(mean);
    EXPECT_NEAR(largest_excursion(swinging(means), line_of(ContactKind::segments, 4, 5)), 3.5, integration);
    EXPECT_NEAR(largest_excursion(swinging(means), line_of(ContactKind::points, 4, 5)), means[slope > 0 ? 8 : 4],
                integration);
  }
}

}  // namespace
}  // namespace tiprub
