// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/response_file.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace tiprub {
namespace {

TEST(ResponseFile, GivesBackWhatItTook) {
  Response response;
  response.key = "abc";
  response.scene.sector_count = 4;
  response.scene.independent_sectors = 2;
  response.scene.nodal_diameters = {0, 2};
  response.scene.casing_angle = response.scene.casing_distortion = Eigen::VectorXd::LinSpaced(5, 0, 1);
  response.scene.lobes = 2;
  response.scene.clearance = Eigen::VectorXd::Constant(3, 1e-4);
  response.scene.clearance_state = "cold";
  SpeedResponse good;
  good.speed = 100;
  good.samples_per_revolution = 4;
  good.recorded_revolutions = 2;
  good.motion = MotionClass::subharmonic;
  good.displacement = Eigen::MatrixXd::Random(8, 2 * 3 * 3);
  good.contact_force = Eigen::MatrixXd::Random(8, 2 * 3);
  good.contact_count.setConstant(6, 20, 7);
  good.contact_steps = 123456789012;
  good.snapshot = RotorSnapshot{5, 12.5, {Eigen::VectorXcd::Random(4), Eigen::VectorXcd::Random(7)}};
  good.audit.acceleration = {AccelerationReport::Outcome::fell_back, 25, 1e-3};
  SpeedResponse bad;
  bad.speed = 200;
  bad.failure = "why";
  response.speeds = {good, bad};
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "tiprub_response_file_test.h5";
  write_response(response, path, "test");
  const Response back = read_response(path);
  std::filesystem::remove(path);
  EXPECT_EQ(back.key, "abc");
  EXPECT_EQ(back.scene.nodal_diameters, response.scene.nodal_diameters);
  EXPECT_EQ(back.scene.clearance, response.scene.clearance);
  ASSERT_EQ(back.speeds.size(), 2u);
  EXPECT_EQ(back.speeds[0].displacement, good.displacement);
  EXPECT_EQ(back.speeds[0].contact_force, good.contact_force);
  EXPECT_EQ(back.speeds[0].contact_count, good.contact_count);
  EXPECT_EQ(back.speeds[0].contact_steps, good.contact_steps);
  ASSERT_TRUE(back.speeds[0].snapshot.has_value());
  EXPECT_EQ(back.speeds[0].snapshot->sample, 5);
  EXPECT_EQ(back.speeds[0].snapshot->force, 12.5);
  EXPECT_EQ(back.speeds[0].snapshot->displacement, good.snapshot->displacement);
  EXPECT_FALSE(back.speeds[1].snapshot.has_value());
  EXPECT_EQ(back.speeds[0].motion, MotionClass::subharmonic);
  EXPECT_EQ(back.speeds[0].audit.acceleration.outcome, AccelerationReport::Outcome::fell_back);
  EXPECT_EQ(back.speeds[0].audit.acceleration.revolutions, 25);
  EXPECT_EQ(back.speeds[0].audit.acceleration.residual, 1e-3);
  EXPECT_EQ(back.speeds[1].audit.acceleration.outcome, AccelerationReport::Outcome::none);
  EXPECT_EQ(back.speeds[1].failure, "why");
}

}  // namespace
}  // namespace tiprub
