// SPDX-License-Identifier: GPL-3.0-or-later
// The executable on a made scene: what it writes, what it says, how it ends.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "program_fixture.h"
#include "reduce/model/reduced_model_file.h"
#include "simulate/response/response_file.h"
#include "tests/simulate/written_response.h"

namespace fs = std::filesystem;

namespace tiprub::postprocess {
namespace {

constexpr const char* figures[] = {"response",
                                   "interaction_map_leading_edge",
                                   "interaction_map_trailing_edge",
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
  for (const char* column : {"tip |u| [mm]", "wave", "share", "motion", "outside validity"})
    EXPECT_NE(outcome.out.find(column), std::string::npos) << column;
  EXPECT_LT(outcome.out.find('\n'), 130U) << "wider than a terminal";
  for (const char* column : {"family", "signed nodal diameter", "engine order", "wave share [1]", "other waves"})
    EXPECT_NE(text_of(report / "critical_speeds.csv").find(column), std::string::npos) << column;
  EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
  EXPECT_NE(outcome.error.find("report/report.html"), std::string::npos);
}

TEST_F(Program, SameInputSameBytes) {
  ASSERT_EQ(run("case.toml model.h5 response.h5 -o one").exit_code, 0);
  ASSERT_EQ(run("case.toml model.h5 response.h5 -o two").exit_code, 0);
  const auto page = [&](const char* report) {  // without what says when and how it was made
    const std::string text = text_of(folder_ / report / "report.html");
    const std::size_t run = text.find("<div id=\"run\">");
    EXPECT_NE(run, std::string::npos);
    return text.substr(0, run) + text.substr(text.find("</div>", run));
  };
  EXPECT_EQ(page("one"), page("two"));
  EXPECT_EQ(text_of(folder_ / "one" / "summary.json"), text_of(folder_ / "two" / "summary.json"));
  EXPECT_EQ(text_of(folder_ / "one/figures/interaction_map_leading_edge.png"),
            text_of(folder_ / "two/figures/interaction_map_leading_edge.png"));
}

TEST_F(Program, DrawsASingleSpeedAndASingleBlade) {
  ReducedModel rotor = synthetic::model(1);
  SimulatedScene scene = synthetic::two_lobes();
  scene.model_digest = digest(rotor);
  scene.sector_count = scene.independent_sectors = 1;
  scene.nodal_diameters = {0};
  Response response{scene, "made", {}, synthetic::frequencies(rotor)};
  response.speeds.push_back(synthetic::speed(scene, rotor.contact, 1500, {{2, 0, 1e-5, 0}}, 1));
  write_model(rotor, folder_ / "one_blade.h5", "test");
  write_response(response, folder_ / "one_speed.h5", "test");
  const Outcome outcome = run("case.toml one_blade.h5 one_speed.h5 -o single");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
}

TEST_F(Program, DrawsAWheelThatNeverTouchesNorMoves) {
  ReducedModel rotor = synthetic::model();
  Response response{synthetic::two_lobes(), "made", {}, synthetic::frequencies(rotor)};
  response.scene.clearance.setConstant(1.0);
  for (const double speed : {1200.0, 1300.0, 1400.0})
    response.speeds.push_back(synthetic::speed(response.scene, rotor.contact, speed, {}, 2));
  write_response(response, folder_ / "still.h5", "test");
  const Outcome outcome = run("case.toml model.h5 still.h5 -o still");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
}

/// Symptom: gnuplot drew no axis between two speeds whose difference it could not tell.
TEST_F(Program, DrawsSpeedsThatAreNearlyEqual) {
  const ReducedModel rotor = synthetic::model();
  Response response{synthetic::two_lobes(), "made", {}, synthetic::frequencies(rotor)};
  for (const double speed : {1200.0, std::nextafter(1200.0, 2000.0)})
    response.speeds.push_back(synthetic::speed(response.scene, rotor.contact, speed, {{2, 2, 1e-300, 0}}, 2));
  write_response(response, folder_ / "near.h5", "test");
  const Outcome outcome = run("case.toml model.h5 near.h5 -o near");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
}

TEST_F(Program, LeavesNothingWhenInterrupted) {
  const fs::path part = folder_ / "stopped.tiprub.part";
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
}  // namespace tiprub::postprocess
