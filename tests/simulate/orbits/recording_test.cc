// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "simulate/motion/casing_areas.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate::recording_test {
namespace {

constexpr int samples = 60;

struct RecordedBench {
  testing::Bench bench;
  RecordedMotion recorded;
};

/// Some revolutions of a wheel that hits two lobes.
RecordedBench recorded_motion(const ReducedModel& model, int symmetry, int revolutions, int cycle_revolutions) {
  constexpr int steps = 1200, warm_up = 3;
  RecordedBench made{testing::make_bench(model, testing::lobed_casing(2, 2e-4, 1.5e-4), 900, 0.01,
                                         {Scheme::trigonometric, ContactRule::complementarity, steps, symmetry}),
                     {}};
  for (int i = 0; i < warm_up; ++i) march_revolution(made.bench.march, samples);
  Recording recording(made.bench.march, {samples, revolutions, 20, 1e-12, 60, cycle_revolutions});
  for (int i = 0; i < revolutions; ++i) recording.revolution();
  made.recorded = recording.finish();
  return made;
}

/// r, theta, z of the contact nodes of all modelled sectors, from the states of the nodal diameters.
Eigen::VectorXd contact_motion(const std::vector<Eigen::VectorXcd>& states, const RecordedBench& made,
                               const ReducedModel& model) {
  const Eigen::Index dofs = model.contact_dofs();
  Eigen::VectorXd wheel = Eigen::VectorXd::Zero(made.bench.march.sectors() * dofs);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const int n = made.bench.rotor.waves[i].nodal_diameter;
    EXPECT_EQ(states[i].size(), model.nodal_diameters[n].M.rows());
    for (int j = 0; j < made.bench.march.sectors(); ++j)
      wheel.segment(j * dofs, dofs) +=
          (states[i].head(dofs) * std::polar(1.0, 2 * std::numbers::pi * n * j / model.sector_count)).real();
  }
  return wheel;
}

/// The snapshot is the recorded motion at the sample with the largest contact force, for the whole wheel as for the
/// part that symmetry leaves.
TEST(Recording, SnapshotIsTheSampleOfTheLargestForce) {
  const ReducedModel model = testing::synthetic_wheel({});
  for (const int symmetry : {1, 2}) {
    const RecordedBench made = recorded_motion(model, symmetry, 2, 0);
    const RecordedMotion& recorded = made.recorded;
    EXPECT_FALSE(recorded.cycle.has_value());
    const RotorSnapshot& snapshot = *recorded.snapshot;
    const Eigen::VectorXd forces = recorded.contact_force.rowwise().sum();
    EXPECT_GT(forces.maxCoeff(), 0);
    EXPECT_DOUBLE_EQ(forces[snapshot.sample], forces.maxCoeff());
    EXPECT_NEAR(snapshot.force, symmetry * forces.maxCoeff(), 1e-12 * snapshot.force);
    ASSERT_EQ(snapshot.displacement.size(), made.bench.rotor.waves.size());
    const Eigen::VectorXd there = recorded.displacement.row(snapshot.sample).transpose();
    EXPECT_GT(there.norm(), 0);
    EXPECT_LT((contact_motion(snapshot.displacement, made, model) - there).norm(), 1e-12 * there.norm());
  }
}

/// The cycle's columns are the recorded motion at the samples of the last revolutions, and the snapshot is one of
/// them.
TEST(Recording, CycleHoldsEverySampleOfTheLastRevolutions) {
  const ReducedModel model = testing::synthetic_wheel({});
  for (const int kept : {1, 3, 5}) {
    const RecordedBench made = recorded_motion(model, 2, 3, kept);
    const RecordedMotion& recorded = made.recorded;
    ASSERT_TRUE(recorded.cycle.has_value());
    const RotorCycle& cycle = *recorded.cycle;
    EXPECT_EQ(cycle.first_sample, (3 - std::min(kept, 3)) * samples);
    ASSERT_EQ(cycle.displacement.size(), made.bench.rotor.waves.size());
    ASSERT_EQ(cycle.displacement[0].cols(), 3 * samples - cycle.first_sample);
    const double size = recorded.displacement.norm();
    for (Eigen::Index column = 0; column < cycle.displacement[0].cols(); ++column) {
      std::vector<Eigen::VectorXcd> states;
      for (const Eigen::MatrixXcd& wave : cycle.displacement) states.emplace_back(wave.col(column));
      const Eigen::Index sample = cycle.first_sample + column;
      const Eigen::VectorXd there = recorded.displacement.row(sample).transpose();
      EXPECT_LT((contact_motion(states, made, model) - there).norm(), 1e-12 * size) << "sample " << sample;
      if (sample != recorded.snapshot->sample) continue;
      for (std::size_t i = 0; i < states.size(); ++i)
        EXPECT_LT((states[i] - recorded.snapshot->displacement[i]).norm(), 1e-12 * size);
    }
  }
}

/// A casing that holds every tip: a node is closed in all of its steps, so its counts are its steps over each area,
/// of areas that divide them or don't, or that are narrower than a step.
TEST(Recording, CountsTheStepsThatAnAreaHas) {
  constexpr int steps = 600, warm_up = 20, revolutions = 2;
  const ReducedModel model = testing::synthetic_wheel({});
  for (const int areas : {20, 70, 700}) {
    testing::Bench bench = testing::make_bench(model, testing::lobed_casing(2, 1e-5, -1e-3), 900, 0.05,
                                               {Scheme::trigonometric, ContactRule::complementarity, steps, 2});
    for (int i = 0; i < warm_up; ++i) march_revolution(bench.march, samples);
    Recording recording(bench.march, {samples, revolutions, areas, 1e-12, 0});
    for (int i = 0; i < revolutions; ++i) recording.revolution();
    const RecordedMotion recorded = recording.finish();
    for (int sector = 0; sector < bench.march.sectors(); ++sector)
      for (int node = 0; node < model.contact.size(); ++node) {
        const CasingSteps way{model.contact.position(node, 1), sector, model.sector_count, steps};
        const Eigen::VectorXi counts = recorded.contact_count.row(sector * model.contact.size() + node);
        EXPECT_EQ(counts, revolutions * steps_over_areas(way, areas)) << sector << " " << node << " " << areas;
      }
  }
}

}  // namespace
}  // namespace tiprub::simulate::recording_test
