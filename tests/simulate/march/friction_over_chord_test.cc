// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simulate/motion/attempt.h"
#include "tests/simulate/march/rubbing_blade.h"

namespace tiprub::simulate {
namespace {

using testing::radius;
using testing::rotor_of_modes;
using testing::rubbing;

/// Two contact nodes at one place, a chord of 0.1 m apart along the tip line.
ContactLine two_tips() {
  ContactLine tips = testing::one_sector().contact;
  tips.position = tips.position.replicate(2, 1).eval();
  tips.normal = tips.normal.replicate(2, 1).eval();
  tips.arc_length = Eigen::Vector2d(0, 0.1);
  return tips;
}

/// Nodes that move apart from each other: friction divides the force of each by its own 1 + mu t/n.
TEST(Friction, OverTheChordChangesTheForceOfEachNode) {
  const Eigen::Vector2d n(3, 2), t(-4, 5), mu(0.2, 0.1);
  RotorAtSpeed rotor = rotor_of_modes({{6000, 0, 0, 0}, {8000, 0, 0, 0}}, 1000, 0.01);
  WaveModes& wave = rotor.waves[0];
  wave.normal_rows = n.cast<std::complex<double>>().asDiagonal();
  wave.sliding_rows = Eigen::MatrixXcd::Zero(4, 2);
  wave.sliding_rows(0, 0) = t[0];
  wave.sliding_rows(2, 1) = t[1];
  wave.contact_rows = Eigen::MatrixXcd::Zero(6, 2);
  const ContactLine tips = two_tips();
  Casing casing = testing::lobed_casing(1, 2e-4, 1e-4);
  casing.friction = {{0.0, mu[0]}, {1.0, mu[1]}};
  const auto march = [&](const Eigen::VectorXd& friction) {
    MarchSetup setup = rubbing(Scheme::trigonometric, 1200, 0);
    setup.friction = friction;
    return testing::march_of(rotor, casing, tips, Eigen::Vector2d::Constant(1e-4), setup);
  };
  TimeMarch slides = march(casing.friction_at(tips)), rests = march({});
  for (int i = 0; i < 6 * 1200; ++i) {
    slides.step();
    rests.step();
    for (int k = 0; k < 2; ++k) {
      const double force = rests.contact().multipliers()[k];
      ASSERT_NEAR(slides.contact().multipliers()[k], force / (1 + mu[k] * t[k] / n[k]), 1e-7 * force + 1e-7) << i;
    }
  }
}

/// Symptom: where the casing is rough over a part of the chord only, a tip on the smooth part ended the march if it
/// slid backward, although no friction acts on it.
TEST(Friction, LetsATipWithoutFrictionSlideBackward) {
  RotorAtSpeed rotor = rotor_of_modes({{20, 0, 0, 0}, {1, 0, 0, 0}, {20, 0, 0, 0}}, 1 / radius);
  WaveModes& wave = rotor.waves[0];
  wave.normal_rows = Eigen::MatrixXcd::Zero(2, 3);
  wave.normal_rows(0, 0) = wave.normal_rows(1, 2) = 1;
  wave.sliding_rows = Eigen::MatrixXcd::Zero(4, 3);
  wave.sliding_rows(0, 1) = 1;  // the first node swings along the belt
  wave.contact_rows = Eigen::MatrixXcd::Zero(6, 3);
  const ContactLine tips = two_tips();
  const auto swing = [&](const Eigen::Vector2d& friction) {
    MarchSetup setup = rubbing(Scheme::trigonometric, 400, 0);
    setup.friction = friction;
    TimeMarch march =
        testing::march_of(rotor, testing::lobed_casing(1, 0, 0), tips, Eigen::Vector2d::Constant(-1e-3), setup);
    march.set_state(0, Eigen::Vector3cd(-1e-3, 1.1, -1e-3), Eigen::Vector3cd(0, 0, 0));
    for (int i = 0; i < 2000; ++i) march.step();
    EXPECT_EQ(march.contact().closed().size(), 2u);
  };
  EXPECT_NO_THROW(swing({0, 0.1}));
  EXPECT_THROW(swing({0.1, 0}), NoMotion);
}

}  // namespace
}  // namespace tiprub::simulate
