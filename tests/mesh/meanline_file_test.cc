// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/blades/blade_files.h"

#include <gtest/gtest.h>

#include <ostream>

namespace tiprub::mesh::meanline_file_test {
namespace {

const std::string sound =
    "12\n0\n0.5\n2 N\n"
    "0.0 3\n0.10 0.00 0.00 0.001\n0.10 0.01 0.01 0.002\n0.10 0.02 0.02 0.001\n"
    "1.0 3\n0.12 0.00 0.00 0.001\n0.12 0.01 0.01 0.002\n0.12 0.02 0.02 0.001\n";

struct Wrong {
  const char* name;
  const char* from;
  const char* to;
  const char* phrase;  ///< what is said; empty if it is taken
};

void PrintTo(const Wrong& wrong, std::ostream* out) {
  *out << wrong.name;
}

class WrongMeanline : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongMeanline, IsRefusedAtItsLine) {
  std::string text = sound, said;
  text.replace(text.find(GetParam().from), std::string(GetParam().from).size(), GetParam().to);
  try {
    read_meanline({"blade.rtzt", text}, 1.0);
  } catch (const InputError& error) {
    said = error.what();
  }
  EXPECT_EQ(said, GetParam().phrase);
}

INSTANTIATE_TEST_SUITE_P(
    Meanline, WrongMeanline,
    ::testing::Values(
        Wrong{"nothing", "0.5", "0.5", ""}, Wrong{"flag_below", "2 N", "2\nt", ""},
        Wrong{"both", "0.0 3", "0.0 3 at", ""},
        Wrong{"count", "12\n", "many\n",
              "blade.rtzt:1: \"many\" stands for the number of blades, which must be a whole number from 1 to 1000"},
        Wrong{"splitters", "12\n0\n", "12\n2\n",
              "blade.rtzt:2: \"2\" stands for the number of splitters, which must be a whole number from 0 to 1"},
        Wrong{"splitter_missing", "12\n0\n", "12\n1\n", "blade.rtzt:12: ends before the pitch fraction"},
        Wrong{
            "no_flag", "2 N", "2",
            "blade.rtzt:4: the number of layers must be followed by N or T: is thickness normal to the mean line, or "
            "along the circle?"},
        Wrong{"angle_alone", "0.0 3", "0.0 3 a",
              "blade.rtzt:5: a layer for the angle or the thickness alone can't be taken; write layers for both"},
        Wrong{"fewer_points", "1.0 3", "1.0 2",
              "blade.rtzt:9: the section that begins here has 2 points, and needs 3"},
        Wrong{"more_points", "0.0 3", "0.0 4", "blade.rtzt:9: holds 2 words; a point is r, theta, z, thickness"},
        Wrong{"cut_off", "0.12 0.02 0.02 0.001\n", "", "blade.rtzt:11: ends before the last point of a layer"},
        Wrong{"negative", "0.12 0.01 0.01 0.002", "0.12 0.01 0.01 -0.002",
              "blade.rtzt:11: a thickness must be at least 0, and less than the radius"},
        Wrong{"off_the_axis", "0.12 0.01", "-0.12 0.01",
              "blade.rtzt:11: a point at r = -0.12 m, z = 0.01 m; r must be more than 0 and at most 10 m, and z at "
              "most "
              "that far off: is [mesh] length_unit right?"}));

}  // namespace
}  // namespace tiprub::mesh::meanline_file_test
