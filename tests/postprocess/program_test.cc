// SPDX-License-Identifier: GPL-3.0-or-later
// The executable on a made scene: what it writes, what it says, how it ends.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "program_fixture.h"
#include "reduce/model/fields_file.h"
#include "reduce/model/hdf5_file.h"
#include "reduce/model/reduced_model_file.h"
#include "simulate/response/response_file.h"

namespace fs = std::filesystem;

namespace tiprub {
namespace {

constexpr const char* figures[] = {"interaction_map",
                                   "response",
                                   "interaction_map_parts",
                                   "contact_map_leading_edge",
                                   "contact_map_trailing_edge",
                                   "campbell",
                                   "interference",
                                   "tip_motion",
                                   "tip_spectrum",
                                   "contact_force",
                                   "force_of_sectors",
                                   "force_spectrum",
                                   "harmonic_bars",
                                   "nodal_diameter_tracking",
                                   "engine_order_tracking",
                                   "waterfall",
                                   "casing"};

TEST_F(Program, MakesTheWholeReport) {
  const Outcome outcome = run("case.toml model.h5 response.h5 -o report");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const fs::path report = folder_ / "report";
  for (const std::string name : figures) {
    const std::string png = text_of(report / "figures" / (name + ".png"));
    const std::string svg = text_of(report / "figures" / (name + ".svg"));
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n") << name;
    EXPECT_NE(png.find("IEND"), std::string::npos) << name;
    EXPECT_NE(svg.find("<svg"), std::string::npos) << name;
    EXPECT_NE(svg.find("</svg>"), std::string::npos) << name;
    EXPECT_GT(text_of(report / "figures" / (name + ".csv")).size(), 100U) << name;
  }
  for (const char* label : {"family 1", "family 5", "EO 2"})
    EXPECT_NE(text_of(report / "figures" / "interference.svg").find(label), std::string::npos) << label;
  for (const fs::directory_entry& entry : fs::directory_iterator(report / "figures"))
    EXPECT_TRUE(entry.path().extension() == ".png" || entry.path().extension() == ".svg" ||
                entry.path().extension() == ".csv")
        << entry.path();
  for (const char* column : {"family", "nodal diameter", "engine order", "wave"}) {
    EXPECT_NE(outcome.out.find(column), std::string::npos);
    EXPECT_NE(text_of(report / "critical_speeds.csv").find(column), std::string::npos);
  }
  EXPECT_NE(outcome.out.find("forward"), std::string::npos);
  EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
  EXPECT_NE(outcome.error.find("report/report.html"), std::string::npos);
}

TEST_F(Program, SameInputSameBytes) {
  ASSERT_EQ(run("case.toml model.h5 response.h5 -o one").exit_code, 0);
  ASSERT_EQ(run("case.toml model.h5 response.h5 -o two").exit_code, 0);
  EXPECT_EQ(text_of(folder_ / "one" / "report.html"), text_of(folder_ / "two" / "report.html"));
  EXPECT_EQ(text_of(folder_ / "one/figures/interaction_map.png"),
            text_of(folder_ / "two/figures/interaction_map.png"));
}

TEST_F(Program, ReplacesAnOldReport) {
  fs::create_directories(folder_ / "again");
  std::ofstream(folder_ / "again" / "old.txt") << "old";
  ASSERT_EQ(run("case.toml model.h5 response.h5 -o again/").exit_code, 0);
  EXPECT_TRUE(fs::exists(folder_ / "again" / "report.html"));
  EXPECT_FALSE(fs::exists(folder_ / "again" / "old.txt"));
  EXPECT_FALSE(fs::exists(folder_ / "again.part"));
}

TEST_F(Program, CheckWritesNothing) {
  const Outcome outcome = run("case.toml model.h5 response.h5 -o wrong --check");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_FALSE(fs::exists(folder_ / "wrong"));
}

TEST_F(Program, DrawsASingleSpeedAndASingleBlade) {
  ReducedModel rotor = synthetic::model(1);
  SimulatedScene scene = synthetic::two_lobes();
  scene.sector_count = scene.independent_sectors = 1;
  scene.nodal_diameters = {0};
  Response response{scene, "made", {}};
  response.speeds.push_back(synthetic::speed(scene, rotor.contact, 1500, {{2, 0, 1e-5, 0}}, 1));
  write_model(rotor, folder_ / "one_blade.h5", "test");
  write_response(response, folder_ / "one_speed.h5", "test");
  const Outcome outcome = run("case.toml one_blade.h5 one_speed.h5 -o single");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
}

TEST_F(Program, DrawsAWheelThatNeverTouchesNorMoves) {
  ReducedModel rotor = synthetic::model();
  Response response{synthetic::two_lobes(), "made", {}};
  response.scene.clearance.setConstant(1.0);
  for (const double speed : {1200.0, 1300.0, 1400.0})
    response.speeds.push_back(synthetic::speed(response.scene, rotor.contact, speed, {}, 2));
  write_response(response, folder_ / "still.h5", "test");
  const Outcome outcome = run("case.toml model.h5 still.h5 -o still");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
}

TEST_F(Program, RefusesAnUnknownKey) {
  write_case("unknown.toml", "[postprocess]\ncolour = 3\n");
  expect_failure(run("unknown.toml model.h5 response.h5 -o wrong"), 2, "unknown.toml:2:1: unknown key \"colour\"");
}

TEST_F(Program, RefusesAValueOutOfRange) {
  write_case("range.toml", "[postprocess]\nfamilies = 0\n");
  expect_failure(run("range.toml model.h5 response.h5 -o wrong"), 2, "families = 0 must be");
}

TEST_F(Program, RefusesAMissingFile) {
  expect_failure(run("case.toml model.h5 nowhere.h5 -o wrong"), 1, "nowhere.h5");
  expect_failure(run("nowhere.toml model.h5 response.h5 -o wrong"), 1, "nowhere.toml: can't be read");
}

TEST_F(Program, RefusesAWrongSchema) {
  expect_failure(run("case.toml response.h5 model.h5 -o wrong"), 1, "response.h5");
}

TEST_F(Program, RefusesFilesOfDifferentRotors) {
  write_model(synthetic::model(9), folder_ / "nine.h5", "test");
  expect_failure(run("case.toml nine.h5 response.h5 -o wrong"), 2, "has 10 sectors, the model has 9");
}

TEST_F(Program, RefusesFieldsOfAnotherRotor) {
  expect_failure(run("case.toml model.h5 response.h5 --fields model.h5 -o wrong"), 1,
                 "expected tiprub-fields version 1");
  expect_failure(run("case.toml model.h5 response.h5 --fields none.h5 -o wrong"), 1, "none.h5: no such file");
  SectorFields sector;
  sector.sector_count = 1;
  sector.nodes = Eigen::Matrix3Xd::Random(3, 20);
  sector.cells = Eigen::VectorXi::LinSpaced(20, 0, 19);
  sector.node_sets = {{"clamped", {}}, {"contact", {0}}, {"cyclic_low", {}}, {"cyclic_high", {}}};
  sector.static_displacement_1 = sector.static_displacement_2 = Eigen::Matrix3Xd::Zero(3, 20);
  {
    FieldsWriter writer(folder_ / "other_fields.h5", "test");
    writer.write_sector(sector);
    writer.write_basis(0, 1, true, [](Eigen::Index) { return Eigen::VectorXcd(Eigen::VectorXcd::Ones(60)); });
  }
  expect_failure(run("case.toml model.h5 response.h5 --fields other_fields.h5 -o wrong"), 2,
                 "other_fields.h5: has 1 sectors, the model has 10");
  expect_failure(run("case.toml model.h5 response.h5 --fields other_fields.h5 --check -o wrong"), 2,
                 "give the fields that were written with the model");
}

TEST_F(Program, RefusesNumbersThatAreNone) {
  const ReducedModel rotor = synthetic::model();
  Response response{synthetic::two_lobes(), "made", {}};
  response.speeds.push_back(synthetic::speed(response.scene, rotor.contact, 1500, {}, 1));
  response.speeds[0].displacement(3, 2) = std::nan("");
  write_response(response, folder_ / "nan.h5", "test");
  expect_failure(run("case.toml model.h5 nan.h5 -o wrong"), 1, "nan.h5");
}

TEST_F(Program, RefusesASweepOfFailures) {
  Response response{synthetic::two_lobes(), "made", {}};
  response.speeds.resize(1);
  response.speeds[0].speed = 1500;
  response.speeds[0].failure = "it blew up";
  write_response(response, folder_ / "failed.h5", "test");
  expect_failure(run("case.toml model.h5 failed.h5 -o wrong"), 1, "it blew up");
}

TEST_F(Program, SaysWhatToInstallWithoutGnuplot) {
  expect_failure(run("case.toml model.h5 response.h5 -o wrong", "PATH=/nowhere"), 1,
                 "install it (Debian: gnuplot-nox)");
}

TEST_F(Program, LeavesNothingWhenInterrupted) {
  const fs::path part = folder_ / "stopped.part";
  const pid_t child = fork();
  if (child == 0) {
    if (chdir(folder_.c_str()) != 0) _exit(99);
    execl(TIPRUB_POSTPROCESS, TIPRUB_POSTPROCESS, "case.toml", "model.h5", "response.h5", "-o", "stopped", "-q",
          static_cast<char*>(nullptr));
    _exit(98);
  }
  for (int wait = 0; wait < 2000 && !fs::exists(part / "figures"); ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ASSERT_TRUE(fs::exists(part / "figures"));
  kill(child, SIGTERM);
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 128 + SIGTERM);
  EXPECT_FALSE(fs::exists(part));
  EXPECT_FALSE(fs::exists(folder_ / "stopped"));
}

}  // namespace
}  // namespace tiprub
