// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "reduce/model/condensation.h"
#include "reduce/model/reduced_model_file.h"
#include "tests/simulate/march/dense_ring.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate {
namespace {

using testing::DenseRing;

constexpr int early_steps = 30;

/// What two programs for the same equations came to.
struct Comparison {
  int contact_steps = 0;
  double early_difference = 0;  ///< after the first `early_steps` in contact, over the largest displacement then
  double difference = 0;        ///< after all of them
};

/// The model as it stands at one speed: condensed, and constant.
ReducedModel at_one_speed(ReducedModel model, double speed) {
  for (NodalDiameterModel& n : model.nodal_diameters) {
    const CondensedModel at = condense(n, speed, model.contact_dofs(), model.modes_at_speed);
    n = {{{at.K}}, at.M};
  }
  model.modes_at_speed = 0;
  return model;
}

/// Each lobe's crest moves along the casing from the leading to the trailing edge.
CasingProfile travelling_crest(int lobes, double height) {
  return {{0.0, 0.4, 1.0},
          {{{0.0, height}, {0.8, 0}, {1.6, 0}, {2.4, 0}},
           {{0.0, 0}, {0.8, height}, {1.6, 0}, {2.4, -height}},
           {{0.0, 0}, {0.8, 0}, {1.6, height}, {2.4, height / 2}}},
          2 * std::numbers::pi / lobes};
}

/// eq. 13, eq. 14, eq. 15 on the whole wheel (eq. 11, eq. 12) against the march.
/// The wheel rubs two lobes at a speed at which its first family meets engine order 4. The casing is scaled to what
/// the wheel is: its crest reaches over the clearance by half.
Comparison compare(const ReducedModel& given, ContactRule rule, int contact_steps,
                   CasingShape shape = CasingShape::cosine, const std::vector<double>& blade_clearance = {}) {
  const double amplitude = 2e-4, clearance = 1.5e-4, damping_ratio = 0.01;
  const int order = 4, lobes = 2;
  const double frequency = given.nodal_diameters[0].natural_frequencies(0)[0];
  const double speed = std::min(2 * std::numbers::pi * frequency / order, given.speed_max);
  const ReducedModel model = at_one_speed(given, speed);
  Casing casing = testing::lobed_casing(lobes, amplitude, clearance);
  casing.ramp_revolutions = 0.5;
  casing.profile = travelling_crest(lobes, amplitude);
  casing.shape = shape;
  casing.blade_clearance = blade_clearance;
  const RotorAtSpeed rotor = rotor_at_speed(model, speed, testing::all_nodal_diameters(model), {damping_ratio});
  const int unit = model.sector_count * lobes;
  const double limit = std::numbers::pi / speed * rotor.omega_max;  // steps a revolution at h = 2/omega_max
  const int steps = unit * static_cast<int>(std::ceil(1.1 * limit / unit));
  TimeMarch march = testing::march_of(rotor, casing, model.contact, casing.running_clearance(model.contact, speed),
                                      {Scheme::central_differences, rule, steps, 1});
  DenseRing dense(model, casing, speed, damping_ratio, steps, rule);
  Comparison comparison;
  double largest = 0;
  for (long i = 0; comparison.contact_steps < contact_steps && i < 40L * steps; ++i) {
    march.step();
    dense.step();
    const Eigen::VectorXd there = dense.normal_displacement();
    for (int j = 0; j < march.sectors(); ++j) {
      const auto here = march.displacement().segment(j * march.width(), march.node_count());
      comparison.difference =
          std::max(comparison.difference,
                   (here - there.segment(j * march.node_count(), march.node_count())).cwiseAbs().maxCoeff());
    }
    largest = std::max(largest, there.cwiseAbs().maxCoeff());
    if (dense.multipliers().cwiseAbs().maxCoeff() == 0) continue;
    if (++comparison.contact_steps == early_steps) comparison.early_difference = comparison.difference / largest;
  }
  comparison.difference /= largest;
  return comparison;
}

TEST(DenseRing, EqualsTheModalMarchInACasingThatVariesOverTheChord) {
  const Comparison seen =
      compare(testing::synthetic_wheel({}), ContactRule::complementarity, 1000, CasingShape::profile);
  EXPECT_EQ(seen.contact_steps, 1000);
  EXPECT_LT(seen.difference, 2e-12);
}

TEST(DenseRing, EqualsTheModalMarchWithComplementarity) {
  const Comparison seen = compare(testing::synthetic_wheel({}), ContactRule::complementarity, 1000);
  EXPECT_EQ(seen.contact_steps, 1000);
  RecordProperty("difference", std::to_string(seen.difference * 1e12) + "e-12");
  EXPECT_LT(seen.difference, 2e-12);
}

TEST(DenseRing, EqualsTheModalMarchWithBladesOfUnequalLength) {
  const Comparison seen = compare(testing::synthetic_wheel({}), ContactRule::complementarity, 1000,
                                  CasingShape::cosine, {0, 3e-5, 1e-5, 0, 5e-5, 2e-5});
  EXPECT_EQ(seen.contact_steps, 1000);
  EXPECT_LT(seen.difference, 2e-12);
}

TEST(DenseRing, EqualsTheModalMarchWithAnOddNumberOfSectors) {
  const Comparison seen = compare(testing::synthetic_wheel({5, 2, 3}), ContactRule::complementarity, 500);
  EXPECT_EQ(seen.contact_steps, 500);
  EXPECT_LT(seen.difference, 2e-12);
}

/// The paper's rule is a discontinuous map: two programs part sooner or later through rounding alone, so this one is
/// compared over fewer steps.
TEST(DenseRing, EqualsTheModalMarchWithThePapersRule) {
  const Comparison seen = compare(testing::synthetic_wheel({}), ContactRule::paper, 300);
  EXPECT_EQ(seen.contact_steps, 300);
  RecordProperty("difference", std::to_string(seen.difference * 1e12) + "e-12");
  EXPECT_LT(seen.difference, 1e-9);
}

/// The same on any model.h5: TIPRUB_MODEL=model.h5 simulate_test --gtest_filter=DenseRing.*
/// Rounding in the dense matrices, or in the eigenproblem, shifts the square of the lowest frequency by about
/// epsilon (omega_max/omega_1)^2, 1e-10 on a real tip mesh: the difference grows with the square of the time.
TEST(DenseRing, EqualsTheModalMarchOnAGivenModel) {
  const char* path = std::getenv("TIPRUB_MODEL");
  if (path == nullptr) GTEST_SKIP() << "set TIPRUB_MODEL to a model.h5";
  const ReducedModel model = read_model(path);
  const Comparison complementarity = compare(model, ContactRule::complementarity, 1000);
  std::printf("complementarity: %.1e, then %.1e\n", complementarity.early_difference, complementarity.difference);
  EXPECT_EQ(complementarity.contact_steps, 1000);
  EXPECT_LT(complementarity.early_difference, 1e-10);
  EXPECT_LT(complementarity.difference, 1e-6);
  const Comparison paper = compare(model, ContactRule::paper, 100);
  std::printf("the paper's rule: %.1e, then %.1e\n", paper.early_difference, paper.difference);
  EXPECT_EQ(paper.contact_steps, 100);
  EXPECT_LT(paper.early_difference, 1e-10);
  EXPECT_LT(paper.difference, 1e-8);
}

}  // namespace
}  // namespace tiprub::simulate
