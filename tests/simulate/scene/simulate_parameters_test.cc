// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/simulate_parameters.h"

#include <string>

#include "tests/cases/temporary_folder.h"

namespace tiprub::simulate {
namespace {

class SpeedsOfACase : public TemporaryFolder {
 protected:
  SpeedChoice choice(const std::string& lines) const {
    write(path("case.toml"), "[simulate]\n" + lines);
    CaseTable table = CaseFile(path("case.toml")).table("simulate");
    return read_simulate_parameters(table).speed_choice;
  }
};

/// Symptom: a sweep that said nothing of its speeds kept to those of the grid, however far apart, and 0.113 mm were
/// reported where the wheel moves by 0.152 mm.
TEST_F(SpeedsOfACase, AreAddedUnlessItSaysNo) {
  const std::string range = "speed_min_rpm = 9000\nspeed_max_rpm = 12000\nspeed_count = 4\n";
  EXPECT_EQ(choice(range), SpeedChoice::adaptive);
  EXPECT_EQ(choice("speeds_rpm = [9000, 12000]\n"), SpeedChoice::adaptive);
  EXPECT_EQ(choice(range + "speeds = \"given\"\n"), SpeedChoice::given);
}

TEST_F(SpeedsOfACase, HaveNothingBesideASingleOne) {
  EXPECT_EQ(choice("speeds_rpm = [9000]\n"), SpeedChoice::given);
  EXPECT_EQ(choice("speeds_rpm = [9000]\nspeeds = \"adaptive\"\n"), SpeedChoice::given);
}

}  // namespace
}  // namespace tiprub::simulate
