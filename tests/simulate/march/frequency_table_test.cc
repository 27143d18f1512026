// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/rotor_at_speed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate {
namespace {

/// A model that is condensed at each speed: the table must hold what the march moves by, not the whole model.
TEST(FrequencyTable, HoldsTheFrequenciesOfTheModelThatIsMarched) {
  ReducedModel model = testing::synthetic_wheel({});
  model.modes_at_speed = 2;
  const FrequencyTable table = frequency_table(model, Damping{0.002, 0.004}, 2400, 1);
  ASSERT_EQ(table.speed.size(), frequency_speeds);
  EXPECT_EQ(table.speed[0], 0.0);
  EXPECT_EQ(table.speed[frequency_speeds - 1], 2400.0);
  ASSERT_EQ(table.by_nodal_diameter.size(), model.nodal_diameters.size());
  const int half = frequency_speeds / 2;
  const RotorAtSpeed rotor =
      rotor_at_speed(model, table.speed[half], testing::all_nodal_diameters(model), {0.002, 0.004});
  for (const WaveModes& wave : rotor.waves) {
    const Eigen::MatrixXd& curves = table.by_nodal_diameter[static_cast<std::size_t>(wave.nodal_diameter)];
    ASSERT_EQ(curves.rows(), frequency_speeds);
    ASSERT_EQ(curves.cols(), model.contact_dofs() + 2);
    const Eigen::ArrayXd marched = wave.omega / (2 * std::numbers::pi);
    EXPECT_LT((curves.row(half).transpose().array() / marched - 1).abs().maxCoeff(), 1e-10);
    EXPECT_EQ(table.damping_ratio[static_cast<std::size_t>(wave.nodal_diameter)].row(half).transpose(),
              wave.damping_ratio.matrix());
    const Eigen::ArrayXd whole =
        model.nodal_diameters[static_cast<std::size_t>(wave.nodal_diameter)].natural_frequencies(table.speed[half]);
    EXPECT_GT((whole.head(marched.size()) / marched - 1).abs().maxCoeff(), 1e-6) << "the condensation shows";
  }
}

TEST(FrequencyTable, IsTheSameWithThreads) {
  const ReducedModel model = testing::synthetic_wheel({});
  const FrequencyTable one = frequency_table(model, Damping{0.002, 0.004}, 2400, 1),
                       three = frequency_table(model, Damping{0.002, 0.004}, 2400, 3);
  EXPECT_EQ(one.by_nodal_diameter, three.by_nodal_diameter);
}

/// omega^2 = k/m - Omega^2: -sqrt(-omega^2) beyond 100 rad/s, where a march is refused.
TEST(FrequencyTable, IsNegativeWhereTheRotorIsUnstable) {
  ReducedModel model = testing::uncoupled_blades(4, 1.0, 1e4);
  model.nodal_diameters[2].K[1] = -Eigen::MatrixXcd::Identity(3, 3);
  const FrequencyTable table = frequency_table(model, Damping{0.002, 0.004}, 200, 1);
  for (int i = 0; i < frequency_speeds; ++i) {
    const double square = 1e4 - table.speed[i] * table.speed[i];
    EXPECT_NEAR(table.by_nodal_diameter[2](i, 0),
                std::copysign(std::sqrt(std::abs(square)), square) / (2 * std::numbers::pi), 1e-6);
    EXPECT_NEAR(table.by_nodal_diameter[1](i, 0), 100 / (2 * std::numbers::pi), 1e-9);
  }
}

}  // namespace
}  // namespace tiprub::simulate
