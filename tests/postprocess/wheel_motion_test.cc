// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/wheel_cycle.h"

#include <gtest/gtest.h>

#include <complex>
#include <numbers>

#include "synthetic_scene.h"

namespace tiprub::postprocess {
namespace {

constexpr int samples_per_revolution = 48, revolutions = 2, samples = samples_per_revolution * revolutions,
              first_sample = 17;

/// x e^{i k phi} of one dof of a nodal diameter, over the cycle.
struct MadeWave {
  std::size_t diameter;  ///< index into the scene's
  double engine_order;
  std::complex<double> amplitude;
};

/// The made scene's nodal diameters 0, 2, 4 moving in their dof 2; what stands moves by the real part.
SpeedResponse response_of(const SimulatedScene& scene, const ReducedModel& model,
                          const std::vector<MadeWave>& waves) {
  SpeedResponse response;
  response.samples_per_revolution = samples_per_revolution;
  response.cycle.emplace();
  response.cycle->first_sample = first_sample;
  for (const int n : scene.nodal_diameters)
    response.cycle->displacement.emplace_back(
        Eigen::MatrixXcd::Zero(model.nodal_diameters[static_cast<std::size_t>(n)].M.rows(), samples));
  for (const MadeWave& wave : waves)
    for (int s = 0; s < samples; ++s) {
      const double phi = 2 * std::numbers::pi * (first_sample + s) / samples_per_revolution;
      const std::complex<double> now = wave.amplitude * std::polar(1.0, wave.engine_order * phi);
      const bool stands = scene.nodal_diameters[wave.diameter] == 0;
      response.cycle->displacement[wave.diameter](2, s) += stands ? now.real() : now;
    }
  return response;
}

TEST(WheelMotion, FindsTheWavesOfACycle) {
  const ReducedModel model = synthetic::model();
  const SimulatedScene scene = synthetic::two_lobes();
  ASSERT_EQ(scene.nodal_diameters, (std::vector<int>{0, 2, 4}));
  const std::vector<MadeWave> made = {
      {1, -2.5, {3e-4, 1e-4}}, {2, 6, {0, 2e-4}}, {0, 10, {1e-4, -1e-4}}, {0, 0, {5e-5, 0}}};
  const WheelMotion motion = wheel_motion(response_of(scene, model, made), scene, model, 1e-12, 10);
  EXPECT_EQ(motion.samples, samples);
  ASSERT_EQ(motion.waves.size(), made.size());
  double shares = 0;
  for (const MadeWave& wave : made) {
    const int n = scene.nodal_diameters[wave.diameter];
    bool found = false;
    for (const RotorWave& candidate : motion.waves)
      if (candidate.nodal_diameter == n && candidate.engine_order == wave.engine_order) {
        found = true;
        shares += candidate.share;
        EXPECT_LT(std::abs(candidate.state[2] - wave.amplitude), 1e-15);
      }
    EXPECT_TRUE(found) << n << " " << wave.engine_order;
  }
  EXPECT_NEAR(shares, 1, 1e-12);
  EXPECT_LE(std::abs(motion.left_out), 1e-12);
}

/// The largest come first; what is left out is the rest of the mean square.
TEST(WheelMotion, SaysWhatItLeavesOut) {
  const ReducedModel model = synthetic::model();
  const SimulatedScene scene = synthetic::two_lobes();
  const WheelMotion motion =
      wheel_motion(response_of(scene, model, {{1, 2, 1e-4}, {1, 8, 3e-4}, {1, -4, 2e-4}}), scene, model, 0, 2);
  ASSERT_EQ(motion.waves.size(), 2U);
  EXPECT_EQ(motion.waves[0].engine_order, 8);
  EXPECT_EQ(motion.waves[1].engine_order, -4);
  EXPECT_NEAR(motion.left_out, 1.0 / 14, 1e-12);
}

}  // namespace
}  // namespace tiprub::postprocess
