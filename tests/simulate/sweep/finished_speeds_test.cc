// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/finished_speeds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/cases/temporary_folder.h"

namespace tiprub::simulate {
namespace {

namespace fs = std::filesystem;

class Finished : public TemporaryFolder {
 protected:
  FinishedSpeeds open() const { return {path("r.h5"), scene(), "key", "test"}; }
  static SimulatedScene scene() {
    SimulatedScene scene;
    scene.sector_count = scene.independent_sectors = 1;
    scene.nodal_diameters = {0};
    scene.lobes = 2;
    scene.casing_angle = Eigen::VectorXd::LinSpaced(3, 0, 6);
    scene.casing_distortion = Eigen::VectorXd::Zero(3);
    scene.clearance = Eigen::VectorXd::Constant(1, 1e-4);
    scene.clearance_state = ClearanceState::running;
    return scene;
  }
  static SpeedResponse failed_at(double speed) {
    SpeedResponse response;
    response.speed = speed;
    response.failure = "it blew up";
    return response;
  }
  fs::path part() const { return fs::directory_iterator(path("r.h5.speeds"))->path(); }
};

TEST_F(Finished, AreTakenOverByTheNextRun) {
  open().keep(failed_at(1000));
  const FinishedSpeeds next = open();
  EXPECT_TRUE(next.has(1000, Depth::full));
  EXPECT_EQ(next.read(1000, Depth::full).failure, "it blew up");
}

/// Symptom: a speed that the run before had examined passed for a critical speed of this one.
TEST_F(Finished, AreForgottenIfTheyAreDeeperThanAsked) {
  SpeedResponse examined = failed_at(1000);
  examined.depth = Depth::examined;
  FinishedSpeeds finished = open();
  finished.keep(examined);
  EXPECT_FALSE(finished.forget_deeper(1000, Depth::examined));
  EXPECT_FALSE(finished.forget_deeper(2000, Depth::full));
  EXPECT_TRUE(finished.forget_deeper(1000, Depth::full));
  EXPECT_FALSE(finished.has(1000, Depth::full));
}

/// Symptom: the amplitude was 0, so that the last speed before the failures passed for a peak and was examined.
TEST_F(Finished, HaveNoAmplitudeWhereTheyFailed) {
  FinishedSpeeds finished = open();
  finished.keep(failed_at(1000));
  EXPECT_TRUE(std::isnan(finished.amplitude(1000, Depth::full)));
}

/// A resumed sweep took the full result for the scan at the same speed, and went on to other speeds than before.
TEST_F(Finished, KeepAScanBesideTheFullResult) {
  SpeedResponse scan = failed_at(1000);
  scan.failure = "scanned";
  scan.depth = Depth::scanned;
  open().keep(scan);
  EXPECT_FALSE(open().has(1000, Depth::full));
  open().keep(failed_at(1000));
  const FinishedSpeeds next = open();
  EXPECT_EQ(next.read(1000, Depth::scanned).failure, "scanned");
  EXPECT_EQ(next.read(1000, Depth::full).failure, "it blew up");
}

/// Any byte: HDF5 itself notices few of them.
TEST_F(Finished, WithAFlippedByteAreComputedAgain) {
  open().keep(failed_at(1000));
  const auto size = static_cast<std::streamoff>(fs::file_size(part()));
  for (std::streamoff at = 0; at < size; at += 97) {
    std::fstream file(part(), std::ios::binary | std::ios::in | std::ios::out);
    file.seekg(at);
    const char byte = static_cast<char>(file.get() ^ 4);
    file.seekp(at);
    file.put(byte);
    file.close();
    EXPECT_FALSE(open().has(1000, Depth::full)) << "byte " << at << " of " << size;
    open().keep(failed_at(1000));
  }
}

TEST_F(Finished, DontTakeOtherPeoplesFilesAway) {
  open().keep(failed_at(1000));
  const fs::path mine = path("r.h5.speeds") / "notes.txt", halved = part().string() + ".tmp";
  std::ofstream(mine) << "mine";
  std::ofstream(halved) << "mine";
  FinishedSpeeds next = open();
  EXPECT_TRUE(next.has(1000, Depth::full));
  next.remove();
  EXPECT_TRUE(fs::exists(mine));
  EXPECT_TRUE(fs::exists(halved));
  EXPECT_EQ(std::distance(fs::directory_iterator(path("r.h5.speeds")), fs::directory_iterator{}), 2);
}

}  // namespace
}  // namespace tiprub::simulate
