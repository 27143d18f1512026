// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/needed_terms.h"

#include <gtest/gtest.h>

#include <numbers>

#include "reduce/model/nodal_diameter.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate {
namespace {

constexpr double stiffness = 2e6;  // N/m
constexpr double speed = 1000;     // rad/s

/// A random motion of all nodal diameters; standing waves are real.
RotorCycle random_cycle(const ReducedModel& model, const std::vector<int>& diameters, int samples) {
  RotorCycle cycle;
  for (const int n : diameters) {
    Eigen::MatrixXcd u = 1e-3 * Eigen::MatrixXcd::Random(model.nodal_diameters[n].M.rows(), samples);
    if (is_standing(n, model.sector_count)) u = u.real().cast<std::complex<double>>().eval();
    cycle.displacement.push_back(u);
  }
  return cycle;
}

/// Blades that are not tied to each other hold k u_j^2 / 2 each.
TEST(ElasticEnergy, IsTheSumOverBlades) {
  for (const int sectors : {1, 5, 6}) {
    const ReducedModel model = testing::uncoupled_blades(sectors, 0.1, stiffness);
    const std::vector<int> diameters = testing::all_nodal_diameters(model);
    const int samples = 7;
    const RotorCycle cycle = random_cycle(model, diameters, samples);
    const Eigen::MatrixXd K = model.nodal_diameters[0].stiffness(speed).real();
    double largest = 0;
    for (int s = 0; s < samples; ++s) {
      double energy = 0;
      for (int j = 0; j < sectors; ++j) {
        Eigen::VectorXd u = Eigen::VectorXd::Zero(K.rows());
        for (std::size_t i = 0; i < diameters.size(); ++i)
          u += (cycle.displacement[i].col(s) * sector_phase(diameters[i], j, sectors)).real();
        energy += 0.5 * u.dot(K * u);
      }
      largest = std::max(largest, energy);
    }
    EXPECT_NEAR(largest_elastic_energy(cycle, diameters, model, speed), largest, 1e-12 * largest) << sectors;
  }
}

PeakVariation row(Variation what, double setting, double at, const RotorCycle& cycle) {
  PeakVariation varied;
  varied.what = what;
  varied.setting = setting;
  varied.speed = at;
  varied.cycle = cycle;
  return varied;
}

/// A critical speed and its budget: friction moves it by 1 % and raises all displacements by 30 %.
SpeedResponse budgeted(const ReducedModel& model, const std::vector<int>& diameters) {
  SpeedResponse response;
  response.speed = speed;
  response.cycle = random_cycle(model, diameters, 5);
  RotorCycle larger = *response.cycle;
  for (Eigen::MatrixXcd& u : larger.displacement) u *= 1.3;
  response.budget = {row(Variation::friction, 0.1, 1.01 * speed, larger),
                     row(Variation::gap, 2, 0.95 * speed, *response.cycle),
                     row(Variation::gap, 1, 0.95 * speed, larger), row(Variation::damping, 0.002, speed, larger)};
  return response;
}

TEST(TermEffects, AreThoseOfFrictionAndOfASecondOrder) {
  const ReducedModel model = testing::uncoupled_blades(6, 0.1, stiffness);
  const std::vector<int> diameters = {0, 2};
  const std::vector<TermEffect> effects = term_effects(budgeted(model, diameters), diameters, model);
  ASSERT_EQ(effects.size(), 2u);
  EXPECT_EQ(effects[0].term, Variation::friction);
  EXPECT_NEAR(effects[0].shift, 0.01, 1e-12);
  EXPECT_NEAR(effects[0].stress, 0.3, 1e-3);  // K of the blades hardly changes with speed
  EXPECT_EQ(effects[1].term, Variation::gap);
  EXPECT_NEAR(effects[1].shift, -0.05, 1e-12);
  EXPECT_NEAR(effects[1].stress, 0.0, 1e-3);
  EXPECT_TRUE(term_effects(SpeedResponse{}, diameters, model).empty());
}

TEST(Decision, IsByTheSpeedOrTheStressThatChangesMost) {
  const std::vector<TermEffect> effects = {{Variation::friction, 0.1, 1000, "", -0.004, 0.01},
                                           {Variation::friction, 0.1, 2000, "", 0.001, -0.25},
                                           {Variation::gap, 2, 1000, "", -0.018, 0.003}};
  const Decision friction = decide(Variation::friction, effects, 0.02), gap = decide(Variation::gap, effects, 0.02);
  EXPECT_TRUE(friction.is_needed);
  EXPECT_EQ(friction.reason,
            "friction of 0.1 is on: at 19099 rev/min it changes the critical speed by +0.1 % and "
            "stress by about -25 %, more than accuracy = 0.02");
  EXPECT_FALSE(gap.is_needed);
  EXPECT_EQ(gap.reason,
            "the second order of the gap is off: at 9549 rev/min it changes the critical speed by -1.8 % "
            "and stress by about +0.3 %, not more than accuracy = 0.02");
  EXPECT_TRUE(decide(Variation::gap, effects, 0.017).is_needed);
  EXPECT_FALSE(decide(Variation::friction, effects, 0.25).is_needed);
}

TEST(Decision, SaysWhatIsNotKnown) {
  const Decision alone = decide(Variation::friction, {{Variation::friction, 0.3, 1000, "it jams"}}, 0.02);
  EXPECT_FALSE(alone.is_needed);
  EXPECT_EQ(alone.reason, "friction of 0.3 is off, but what it does at 9549 rev/min is not known: it jams");
  const Decision beside =
      decide(Variation::friction,
             {{Variation::friction, 0.3, 1000, "it jams"}, {Variation::friction, 0.3, 2000, "", 0, 0}}, 0.02);
  EXPECT_NE(beside.reason.find("; what it does at 9549 rev/min is not known: it jams"), std::string::npos);
  const Decision none = decide(Variation::gap, {}, 0.02);
  EXPECT_FALSE(none.is_needed);
  EXPECT_EQ(none.reason, "the second order of the gap is off: no critical speed was found to judge it by");
}

}  // namespace
}  // namespace tiprub::simulate
