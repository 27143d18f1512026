// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/scene.h"

#include <gtest/gtest.h>

#include <numbers>

#include "simulate/motion/attempt.h"

namespace tiprub::simulate {
namespace {

SimulateParameters asked() {
  SimulateParameters parameters;
  parameters.samples_per_revolution = 240;
  parameters.steps_per_period = 400;
  return parameters;
}

/// eq. 17: by trying all alpha and k.
TEST(SceneScope, HoldsTheNodalDiametersThatTheCasingsOrdersReach) {
  for (int sectors : {1, 7, 10, 13})
    for (int lobes : {1, 2, 3, 4, 5, 10}) {
      std::vector<int> reached;
      for (int n = 0; n <= sectors / 2; ++n) {
        bool found = false;
        for (int k = 0; k <= sectors; ++k) found |= (k * lobes - n) % sectors == 0 || (k * lobes + n) % sectors == 0;
        if (found) reached.push_back(n);
      }
      EXPECT_EQ(find_scope(sectors, lobes, asked()).nodal_diameters, reached) << sectors << " and " << lobes;
    }
}

TEST(SceneScope, HoldsMultiplesOfTheCommonDivisor) {
  const auto diameters = [](int lobes) { return find_scope(10, lobes, asked()).nodal_diameters; };
  EXPECT_EQ(diameters(1), (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(diameters(2), (std::vector<int>{0, 2, 4}));
  EXPECT_EQ(diameters(3), (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(diameters(5), (std::vector<int>{0, 5}));
  EXPECT_EQ(diameters(10), (std::vector<int>{0}));
  EXPECT_EQ(find_scope(10, 2, asked()).independent_sectors, 5);
  EXPECT_EQ(find_scope(1, 3, asked()).nodal_diameters, std::vector<int>{0});
}

TEST(SceneScope, GivesAllWhenAsked) {
  SimulateParameters parameters = asked();
  parameters.nodal_diameters = DiameterChoice::all;
  const SceneScope scope = find_scope(10, 2, parameters);
  EXPECT_EQ(scope.nodal_diameters.size(), 6u);
  EXPECT_EQ(scope.independent_sectors, 10);
  EXPECT_EQ(scope.symmetry, 1);
}

TEST(SceneScope, StepsAreMultiplesOfSamplesSectorsAndLobes) {
  for (int sectors : {1, 7, 10, 13})
    for (int lobes : {1, 2, 3, 5}) {
      const SceneScope scope = find_scope(sectors, lobes, asked());
      EXPECT_GE(scope.samples_per_revolution, 240);
      EXPECT_EQ(scope.samples_per_revolution % sectors, 0);
      EXPECT_EQ(scope.samples_per_revolution % lobes, 0);
      const int steps = steps_per_revolution(scope, asked(), 900, 1000);
      EXPECT_EQ(steps % scope.samples_per_revolution, 0);
      EXPECT_GE(steps, 400 * 900 * 2 * std::numbers::pi / 1000);
      EXPECT_LT(steps - scope.samples_per_revolution, 400 * 900 * 2 * std::numbers::pi / 1000);
    }
}

TEST(SceneScope, RefusesUncountableSteps) {
  EXPECT_THROW(steps_per_revolution(find_scope(10, 2, asked()), asked(), 1e6, 1e-3), NoMotion);
}

TEST(SceneScope, GivesAReasonForEachChoice) {
  const SceneScope scope = find_scope(10, 2, asked());
  EXPECT_EQ(scope.reasons.size(), 4u);
  EXPECT_NE(scope.reasons.back().find(
                "400 a period of the lowest frequency, halved until that changes the motion by less than 0.005"),
            std::string::npos);
}

/// Symptom: with 24 lobes and ten samples for each, the amplitude was a fifth too small.
TEST(SceneScope, SamplesEachLobe) {
  SimulateParameters parameters;
  parameters.samples_per_revolution = 240;
  parameters.samples_per_lobe = 20;
  EXPECT_EQ(find_scope(6, 24, parameters).samples_per_revolution, 480);
  EXPECT_EQ(find_scope(6, 2, parameters).samples_per_revolution, 240);
}

}  // namespace
}  // namespace tiprub::simulate
