// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/recording.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/simulate/synthetic_wheel.h"

namespace tiprub {
namespace {

/// The snapshot is the recorded motion at the sample with the largest contact force, for the whole wheel as for the
/// part that symmetry leaves.
TEST(Recording, SnapshotIsTheSampleOfTheLargestForce) {
  constexpr int samples = 60, steps = 1200, warm_up = 3, recorded = 2;
  const ReducedModel model = testing::synthetic_wheel({});
  for (const int symmetry : {1, 2}) {
    testing::Bench bench =
        testing::make_bench(model, testing::lobed_casing(2, 2e-4, 1.5e-4), 900, 0.01,
                            {Scheme::trigonometric, ContactRule::complementarity, steps, symmetry});
    for (int i = 0; i < warm_up; ++i) march_revolution(bench.march, samples);
    Recording recording(bench.march, bench.rotor, model.contact, {samples, recorded, 20, 1e-12});
    for (int i = 0; i < recorded; ++i) recording.revolution(bench.march);
    SpeedResponse response;
    recording.finish(bench.march, response);
    ASSERT_TRUE(response.snapshot.has_value());
    const RotorSnapshot& snapshot = *response.snapshot;
    const Eigen::VectorXd forces = response.contact_force.rowwise().sum();
    EXPECT_GT(forces.maxCoeff(), 0);
    EXPECT_DOUBLE_EQ(forces[snapshot.sample], forces.maxCoeff());
    EXPECT_NEAR(snapshot.force, symmetry * forces.maxCoeff(), 1e-12 * snapshot.force);
    ASSERT_EQ(snapshot.displacement.size(), bench.rotor.waves.size());
    const Eigen::Index dofs = model.contact_dofs();
    Eigen::VectorXd wheel = Eigen::VectorXd::Zero(bench.march.sectors() * dofs);
    for (std::size_t i = 0; i < snapshot.displacement.size(); ++i) {
      const int n = bench.rotor.waves[i].nodal_diameter;
      ASSERT_EQ(snapshot.displacement[i].size(), model.nodal_diameters[n].M.rows());
      for (int j = 0; j < bench.march.sectors(); ++j)
        wheel.segment(j * dofs, dofs) +=
            (snapshot.displacement[i].head(dofs) * std::polar(1.0, 2 * std::numbers::pi * n * j / model.sector_count))
                .real();
    }
    const Eigen::VectorXd there = response.displacement.row(snapshot.sample).transpose();
    EXPECT_GT(there.norm(), 0);
    EXPECT_LT((wheel - there).norm(), 1e-12 * there.norm());
  }
}

}  // namespace
}  // namespace tiprub
