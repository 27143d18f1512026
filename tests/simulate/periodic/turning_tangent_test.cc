// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "simulate/periodic/marched_map.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate {
namespace {

/// What turns the forces of a march.
struct Turning {
  const char* name;
  std::vector<double> friction;  ///< of the contact nodes, or of all
  GapOrder gap;
};
const Turning kinds[] = {{"friction", {0.2}, GapOrder::linear},
                         {"friction at some nodes", {0, 0.1, 0.2}, GapOrder::linear},
                         {"curvature", {}, GapOrder::second_order},
                         {"both", {0.2}, GapOrder::second_order}};

/// A march of a wheel that rubs an oval casing, grown and settled for some revolutions.
testing::Bench rubbing_wheel(Scheme scheme, const Turning& turning, double speed) {
  MarchSetup setup{scheme, ContactRule::complementarity, 1200, 2};
  setup.friction = Eigen::VectorXd::Map(turning.friction.data(), static_cast<Eigen::Index>(turning.friction.size()));
  setup.gap = turning.gap;
  testing::Bench bench =
      testing::make_bench(testing::curved_wheel(), testing::lobed_casing(2, 2e-4, 1.5e-4), speed, 0.02, setup);
  for (int i = 0; i < 30 * 1200; ++i) bench.march.step();
  return bench;
}

/// The derivative of a map along a direction, against the difference of two images beside a state.
double derivative_error(MarchedMap& map, double length) {
  const Eigen::VectorXd state = map.symmetric().state();
  std::mt19937 source(3);
  Eigen::VectorXd direction = Eigen::VectorXd::NullaryExpr(
      state.size(), [&](Eigen::Index) { return 2.0 * source() / std::mt19937::max() - 1.0; });
  direction *= length * state.norm() / direction.norm();
  const MapImage image = map.image(state);
  const Eigen::VectorXd tangent = map.tangent(image.pattern, direction);
  const Eigen::VectorXd difference = (map.image(state + direction).state - map.image(state - direction).state) / 2;
  return (tangent - difference).norm() / difference.norm();
}

/// The directions in which the tips slide and the slopes of their gaps turn with the motion.
TEST(TurningTangent, IsTheDerivativeOfTheMap) {
  for (const Turning& turning : kinds)
    for (const Scheme scheme : {Scheme::trigonometric, Scheme::central_differences})
      for (const double speed : {300.0, 900.0}) {
        testing::Bench bench = rubbing_wheel(scheme, turning, speed);
        MarchedMap map(bench.march);
        EXPECT_LT(derivative_error(map, 1e-8), 1e-5)
            << turning.name << ", scheme " << static_cast<int>(scheme) << " at " << speed;
      }
}

/// Of the nodal diameters that symmetry leaves out: the tangent over the difference of two whole wheels, one of them
/// disturbed.
double followed_over_marched(const Turning& turning) {
  const testing::Bench bench = rubbing_wheel(Scheme::trigonometric, turning, 900);
  TimeMarch march(bench.march.scene());
  for (int i = 0; i < 30 * 1200; ++i) march.step();
  MarchedMap map(march);
  const Eigen::VectorXd state = map.symmetric().state();
  const MapImage image = map.image(state);
  map.put(state);
  TangentMarch excluded(march, Disturbance::excluded, 1);

  MarchedScene whole = march.scene();
  const auto rotor = std::make_shared<RotorAtSpeed>(*whole.rotor);
  rotor->waves.insert(rotor->waves.end(), rotor->others.begin(), rotor->others.end());
  whole.rotor = rotor;
  whole.setup.symmetry = 1;
  TimeMarch all(whole);
  const std::size_t first = march.wave_count();
  for (std::size_t i = 0; i < first; ++i) {
    const Eigen::Index modes = march.wave(i).modes();
    const Eigen::VectorXcd now = march.coordinates(i).head(modes);
    all.set_state(i, now, march.increments(i).head(modes));
  }
  all.set_step(march.step_count());
  const SymmetricMap one(all);
  const EnergyState left_out(all, first);
  Eigen::VectorXd direction = Eigen::VectorXd::LinSpaced(excluded.size(), -1, 1);
  direction *= 1e-8 * map.symmetric().state().norm() / direction.norm();
  left_out.put(direction, all);
  for (int i = 0; i < one.steps(); ++i) all.step();
  const Eigen::VectorXd moved = left_out.of(all);
  const Eigen::VectorXd tangent = excluded(image.pattern, direction);
  return tangent.norm() / moved.norm();  // the map also shifts the sectors, which keeps the norm
}

TEST(TurningTangent, FollowsWhatSymmetryLeavesOut) {
  for (const Turning& turning : kinds) EXPECT_NEAR(followed_over_marched(turning), 1, 1e-5) << turning.name;
}

}  // namespace
}  // namespace tiprub::simulate
