// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/response_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "reduce/model/hdf5_file.h"
#include "simulate/response/speed_group.h"
#include "tests/cases/full_disk.h"
#include "tests/reduce/complaint.h"

namespace tiprub {
namespace {

SpeedResponse settled_speed() {
  SpeedResponse speed;
  speed.speed = 100;
  speed.samples_per_revolution = 4;
  speed.recorded_revolutions = 2;
  speed.motion = MotionClass::subharmonic;
  speed.clearance = Eigen::Vector3d(1e-4, 2e-4, 3e-4);
  speed.displacement = Eigen::MatrixXd::Random(8, 2 * 3 * 3);
  speed.contact_force = Eigen::MatrixXd::Random(8, 2 * 3);
  speed.contact_count.setConstant(6, 20, 7);
  speed.contact_steps = 123456789012;
  speed.snapshot = RotorSnapshot{5, 12.5, {Eigen::VectorXcd::Random(4), Eigen::VectorXcd::Random(7)}};
  speed.cycle = RotorCycle{4, {Eigen::MatrixXcd::Random(4, 4), Eigen::MatrixXcd::Random(7, 4)}};
  speed.audit.acceleration = {AccelerationReport::Outcome::fell_back, 25, 1e-3};
  return speed;
}

Response two_speeds() {
  Response response;
  response.key = "abc";
  response.scene.sector_count = 4;
  response.scene.independent_sectors = 2;
  response.scene.nodal_diameters = {0, 2};
  response.scene.casing_angle = response.scene.casing_distortion = Eigen::VectorXd::LinSpaced(5, 0, 1);
  response.scene.lobes = 2;
  response.scene.clearance = Eigen::VectorXd::Constant(3, 1e-4);
  response.scene.clearance_state = "cold";
  SpeedResponse failed;
  failed.speed = 200;
  failed.failure = "why";
  response.speeds = {settled_speed(), failed};
  response.frequencies = {Eigen::VectorXd::LinSpaced(5, 0, 200), {}};
  for (int modes : {3, 4, 5}) response.frequencies.by_nodal_diameter.emplace_back(Eigen::MatrixXd::Random(5, modes));
  return response;
}

class ResponseFile : public ::testing::Test {
 protected:
  ~ResponseFile() override { std::filesystem::remove(path_); }

  Response written_and_read(const Response& response) const {
    write_response(response, path_, "test");
    return read_response(path_);
  }

  const std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("tiprub-response-" + std::to_string(getpid()) + ".h5");
};

TEST_F(ResponseFile, GivesBackTheScene) {
  const Response response = two_speeds(), back = written_and_read(response);
  EXPECT_EQ(back.key, "abc");
  EXPECT_EQ(back.scene.nodal_diameters, response.scene.nodal_diameters);
  EXPECT_EQ(back.scene.clearance, response.scene.clearance);
  EXPECT_EQ(back.frequencies.speed, response.frequencies.speed);
  EXPECT_EQ(back.frequencies.by_nodal_diameter, response.frequencies.by_nodal_diameter);
}

TEST_F(ResponseFile, SaysThatTheDiskIsFull) {
  write_response(two_speeds(), path_, "test");
  const auto size = static_cast<rlim_t>(std::filesystem::file_size(path_));
  constexpr int cuts = 20;
  for (int cut = 0; cut < cuts; ++cut) {
    std::filesystem::remove(path_);
    const test::FullDisk disk(cut * size / cuts);
    EXPECT_THROW(write_response(two_speeds(), path_, "test"), RunError) << cut;
  }
}

/// A reader refuses what isn't finite: then all other speeds would be lost with it.
TEST(SpeedResponse, TellsWhetherItIsFinite) {
  const double nan = std::nan("");
  EXPECT_TRUE(is_finite(settled_speed()));
  for (const auto& spoil : std::vector<std::function<void(SpeedResponse&)>>{
           [&](SpeedResponse& s) { s.displacement(1, 1) = nan; },
           [&](SpeedResponse& s) { s.contact_force(0, 0) = nan; }, [&](SpeedResponse& s) { s.change_rate = nan; },
           [&](SpeedResponse& s) { s.audit.halving_difference = nan; },
           [&](SpeedResponse& s) { s.snapshot->displacement[0][2] = nan; },
           [&](SpeedResponse& s) { s.cycle->displacement[1](2, 2) = nan; }}) {
    SpeedResponse speed = settled_speed();
    spoil(speed);
    EXPECT_FALSE(is_finite(speed));
  }
}

TEST_F(ResponseFile, RefusesAByteThatChanged) {
  write_response(two_speeds(), path_, "test");
  const auto middle = static_cast<std::streamoff>(std::filesystem::file_size(path_) / 2);
  std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
  file.seekg(middle);
  const char byte = static_cast<char>(file.get() ^ 1);
  file.seekp(middle);
  file.put(byte);
  file.close();
  EXPECT_EQ(test::complaint<RunError>([&] { read_response(path_); }),
            path_.string() + ": was damaged after it was written (its seal is broken); run tiprub-simulate again");
}

TEST_F(ResponseFile, GivesBackASpeed) {
  const Response response = two_speeds(), back = written_and_read(response);
  const SpeedResponse& given = response.speeds[0];
  ASSERT_EQ(back.speeds.size(), 2u);
  const SpeedResponse& speed = back.speeds[0];
  EXPECT_EQ(speed.clearance, given.clearance);
  EXPECT_EQ(speed.displacement, given.displacement);
  EXPECT_EQ(speed.contact_force, given.contact_force);
  EXPECT_EQ(speed.contact_count, given.contact_count);
  EXPECT_EQ(speed.contact_steps, given.contact_steps);
  EXPECT_EQ(speed.motion, MotionClass::subharmonic);
  ASSERT_TRUE(speed.snapshot.has_value());
  EXPECT_EQ(speed.snapshot->sample, 5);
  EXPECT_EQ(speed.snapshot->force, 12.5);
  EXPECT_EQ(speed.snapshot->displacement, given.snapshot->displacement);
  ASSERT_TRUE(speed.cycle.has_value());
  EXPECT_EQ(speed.cycle->first_sample, 4);
  EXPECT_EQ(speed.cycle->displacement, given.cycle->displacement);
  EXPECT_EQ(speed.audit.acceleration.outcome, AccelerationReport::Outcome::fell_back);
  EXPECT_EQ(speed.audit.acceleration.revolutions, 25);
  EXPECT_EQ(speed.audit.acceleration.residual, 1e-3);
}

TEST_F(ResponseFile, GivesBackWhyASpeedFailed) {
  const Response back = written_and_read(two_speeds());
  ASSERT_EQ(back.speeds.size(), 2u);
  EXPECT_EQ(back.speeds[1].failure, "why");
  EXPECT_FALSE(back.speeds[1].snapshot.has_value());
  EXPECT_FALSE(back.speeds[1].cycle.has_value());
  EXPECT_EQ(back.speeds[1].audit.acceleration.outcome, AccelerationReport::Outcome::none);
}

TEST_F(ResponseFile, SaysWhatToDoWithAnOlderOne) {
  { Hdf5File::create(path_).set_schema("tiprub-response", 1, "test"); }
  for (const auto& read : {+[](const std::filesystem::path& path) { read_response(path); },
                           +[](const std::filesystem::path& path) { read_response_key(path); }})
    try {
      read(path_);
      FAIL();
    } catch (const RunError& error) {
      EXPECT_NE(std::string(error.what()).find("version 1, made by an older tiprub-simulate; run it again"),
                std::string::npos)
          << error.what();
    }
}

TEST_F(ResponseFile, RefusesFrequenciesAtOtherSpeeds) {
  Response response = two_speeds();
  response.frequencies.speed.conservativeResize(4);
  EXPECT_THROW(written_and_read(response), RunError);
}

TEST_F(ResponseFile, RefusesACycleThatEndsElsewhereThanTheRecording) {
  Response response = two_speeds();
  response.speeds[0].cycle->first_sample = 3;
  EXPECT_THROW(written_and_read(response), RunError);
}

}  // namespace
}  // namespace tiprub
