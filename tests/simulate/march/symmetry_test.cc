// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numbers>

#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate::symmetry_test {
namespace {

using testing::Bench;
using testing::make_bench;

constexpr int steps = 1200, revolutions = 6;

/// The symmetric nodal diameters alone against the whole wheel, transient included.
TEST(Symmetry, GivesTheWholeWheel) {
  const ReducedModel model = testing::synthetic_wheel({});
  for (int lobes : {2, 3, 6}) {
    const Casing casing = testing::lobed_casing(lobes, 2e-4, 1.5e-4);
    Bench whole =
        make_bench(model, casing, 900, 0.01, {Scheme::trigonometric, ContactRule::complementarity, steps, 1});
    Bench part =
        make_bench(model, casing, 900, 0.01, {Scheme::trigonometric, ContactRule::complementarity, steps, lobes});
    EXPECT_EQ(part.march.sectors(), 6 / lobes);
    int contacts = 0;
    double difference = 0, largest = 0;
    for (int i = 0; i < revolutions * steps; ++i) {
      whole.march.step();
      part.march.step();
      contacts += whole.march.contact().closed().empty() ? 0 : 1;
      const Eigen::VectorXd repeated = part.march.displacement().replicate(lobes, 1);
      difference = std::max(difference, (whole.march.displacement() - repeated).cwiseAbs().maxCoeff());
      largest = std::max(largest, repeated.cwiseAbs().maxCoeff());
    }
    EXPECT_GT(contacts, 1000);
    EXPECT_LT(difference, 1e-12 * largest) << lobes << " lobes";
  }
}

/// The casing turned by alpha is the same scene with its sectors relabelled.
TEST(Symmetry, TurningTheCasingRelabelsTheSectors) {
  const ReducedModel model = testing::synthetic_wheel({});
  Casing casing = testing::lobed_casing(1, 2e-4, 1.5e-4);
  const MarchSetup setup{Scheme::trigonometric, ContactRule::complementarity, steps, 1};
  Bench here = make_bench(model, casing, 900, 0.01, setup);
  casing.crest_angle = 2 * std::numbers::pi / model.sector_count;
  Bench turned = make_bench(model, casing, 900, 0.01, setup);
  const Eigen::Index width = here.march.width();
  double difference = 0, largest = 0;
  for (int i = 0; i < revolutions * steps; ++i) {
    here.march.step();
    turned.march.step();
    for (int j = 0; j < model.sector_count; ++j) {
      const int other =
          (j + 1) % model.sector_count;  // sector j+1 meets the turned crest when sector j met the old one
      const auto moved = turned.march.displacement().segment(other * width, width);
      difference =
          std::max(difference, (moved - here.march.displacement().segment(j * width, width)).cwiseAbs().maxCoeff());
      largest = std::max(largest, moved.cwiseAbs().maxCoeff());
    }
  }
  EXPECT_LT(difference, 1e-12 * largest);
}

/// Lengths, and matrices, are free: everything twice as large, or all matrices times a power of two, moves alike to
/// the last bit.
TEST(Symmetry, ScalesInLengthAndInMatrices) {
  ReducedModel model = testing::synthetic_wheel({});
  const MarchSetup setup{Scheme::trigonometric, ContactRule::complementarity, steps, 1};
  Bench here = make_bench(model, testing::lobed_casing(2, 2e-4, 1.5e-4), 900, 0.01, setup);
  Bench longer = make_bench(model, testing::lobed_casing(2, 4e-4, 3e-4), 900, 0.01, setup);
  for (NodalDiameterModel& at : model.nodal_diameters)
    for (Eigen::MatrixXcd* matrix : {&at.K[0], &at.K[1], &at.M}) *matrix *= 4.0;
  Bench heavier = make_bench(model, testing::lobed_casing(2, 2e-4, 1.5e-4), 900, 0.01, setup);
  for (int i = 0; i < 3 * steps; ++i)
    for (Bench* bench : {&here, &longer, &heavier}) bench->march.step();
  EXPECT_GT(here.march.displacement().norm(), 0);
  EXPECT_LT((2 * here.march.displacement() - longer.march.displacement()).norm(),
            1e-12 * longer.march.displacement().norm());
  EXPECT_LT((here.march.displacement() - heavier.march.displacement()).norm(),
            1e-12 * here.march.displacement().norm());
}

}  // namespace
}  // namespace tiprub::simulate::symmetry_test
