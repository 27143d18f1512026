// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/rotor_at_speed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "simulate/motion/attempt.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate {
namespace {

/// eq. 12: each nodal diameter is a block of its own.
TEST(RotorAtSpeed, HasTheModelsFrequenciesAndNormalRows) {
  const ReducedModel model = testing::synthetic_wheel({});
  const double speed = 1200;
  const RotorAtSpeed rotor = rotor_at_speed(model, speed, {0, 1, 3}, {0.01, 0.002});
  ASSERT_EQ(rotor.waves.size(), 3u);
  double lowest = HUGE_VAL;
  for (const NodalDiameterModel& at : model.nodal_diameters)
    lowest = std::min(lowest, at.natural_frequencies(speed)[0]);
  EXPECT_NEAR(rotor.first_frequency, lowest, 1e-9 * lowest);
  for (const WaveModes& wave : rotor.waves) {
    const NodalDiameterModel& at = model.nodal_diameters[wave.nodal_diameter];
    const Eigen::ArrayXd expected = 2 * std::numbers::pi * at.natural_frequencies(speed).array();
    EXPECT_LT((wave.omega / expected - 1).abs().maxCoeff(), 1e-11);
    EXPECT_EQ(wave.kind, wave.nodal_diameter == 1 ? WaveKind::travelling : WaveKind::standing);
    EXPECT_EQ(wave.damping_ratio[0], 0.01);
    EXPECT_EQ(wave.damping_ratio.tail(wave.omega.size() - 1).maxCoeff(), 0.002);
    // Phi Phi^H = M^-1, seen at the contact dofs
    const Eigen::MatrixXcd inverse = at.M.inverse().topLeftCorner(9, 9);
    EXPECT_LT((wave.contact_rows * wave.contact_rows.adjoint() - inverse).norm(), 1e-11 * inverse.norm());
  }
}

TEST(RotorAtSpeed, RefusesAnUnstableOneAndSaysWhere) {
  ReducedModel model = testing::uncoupled_blades(4, 1.0, 1e4);
  model.nodal_diameters[2].K[1] = -Eigen::MatrixXcd::Identity(3, 3);
  EXPECT_NO_THROW(rotor_at_speed(model, 99, {0}, {0.0}));
  try {
    rotor_at_speed(model, 101, {0}, {0.0});  // nodal diameter 2 is looked at although it isn't asked for
    FAIL();
  } catch (const NoMotion& error) {
    EXPECT_NE(std::string(error.what()).find("nodal diameter 2"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("statically unstable"), std::string::npos);
  }
}

}  // namespace
}  // namespace tiprub::simulate
