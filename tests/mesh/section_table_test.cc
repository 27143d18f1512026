// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/blades/blade_files.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <ostream>
#include <sstream>

namespace tiprub::mesh::section_table_test {
namespace {

constexpr FileUnits centimetres{0.01, 1.0};

const std::string sound =
    "# two sections of three points\n"
    "section 1 hub\n"
    "0.0 10.0 0.01 -0.01\n"
    "1.0 10.0 0.02 -0.02  # the middle\n"
    "2.0 10.0 0.01 -0.01\n"
    "\n"
    "section 2\r\n"
    "0.0 12.0 0.01 -0.01\r\n"
    "1.0 12.0 0.02 -0.02\r\n"
    "2.0 12.0 0.01 -0.01\r\n";

std::string complaint(const std::string& text) {
  try {
    read_section_table({"blade.txt", text}, centimetres);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string changed(const std::string& from, const std::string& to) {
  std::string text = sound;
  text.replace(text.find(from), from.size(), to);
  return text;
}

TEST(SectionTable, BecomesMeanLineAndHalfWidthInMetres) {
  const FileBlade blade = read_section_table({"blade.txt", sound}, centimetres);
  ASSERT_EQ(blade.sections.size(), 2U);
  ASSERT_EQ(blade.sections[1].size(), 3U);
  EXPECT_DOUBLE_EQ(blade.sections[1][1].at.z, 0.01);
  EXPECT_DOUBLE_EQ(blade.sections[1][1].at.r, 0.12);
  EXPECT_DOUBLE_EQ(blade.sections[1][1].theta, 0.0);
  EXPECT_DOUBLE_EQ(blade.sections[1][1].half_width, 0.02);
}

TEST(SectionTable, TakesTheSidesInEitherOrder) {
  std::string text = sound;
  for (std::size_t at = 0; (at = text.find("0.01 -0.01", at)) != std::string::npos;)
    text.replace(at, 10, "-0.01 0.01");
  for (std::size_t at = 0; (at = text.find("0.02 -0.02", at)) != std::string::npos;)
    text.replace(at, 10, "-0.02 0.02");
  EXPECT_DOUBLE_EQ(read_section_table({"blade.txt", text}, centimetres).sections[0][1].half_width, 0.02);
}

/// Symptom: a table whose angles jump from pi to -pi, between points, sides or sections, gave inverted elements.
TEST(SectionTable, CountsTheAnglesOn) {
  const auto blade = [](double turn) {
    std::ostringstream text;
    for (int k = 0; k < 3; ++k) {
      text << "section\n";
      for (int i = 0; i < 4; ++i) {
        const double theta = turn + 0.2 * k + 0.1 * i;
        text << i << " " << 10 + k << " " << std::remainder(theta + 0.03, 2 * EIGEN_PI) << " "
             << std::remainder(theta - 0.03, 2 * EIGEN_PI) << "\n";
      }
    }
    return read_section_table({"blade.txt", text.str()}, centimetres);
  };
  const FileBlade at_zero = blade(0.0), across = blade(2.9);
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(across.sections[k][i].theta - at_zero.sections[k][i].theta, 2.9, 1e-4);
      EXPECT_NEAR(across.sections[k][i].half_width, 0.03, 1e-4);
    }
}

struct Wrong {
  const char* name;
  const char* from;
  const char* to;
  const char* phrase;
};

void PrintTo(const Wrong& wrong, std::ostream* out) {
  *out << wrong.name;
}

class WrongTable : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongTable, IsRefusedAtItsLine) {
  EXPECT_EQ(complaint(changed(GetParam().from, GetParam().to)), GetParam().phrase);
}

INSTANTIATE_TEST_SUITE_P(
    SectionTable, WrongTable,
    ::testing::Values(
        Wrong{"word", "0.02 -0.02", "thick -0.02",
              "blade.txt:4: \"thick\" stands for theta of side 1, which must be a finite number"},
        Wrong{"nan", "0.02 -0.02", "nan -0.02",
              "blade.txt:4: \"nan\" stands for theta of side 1, which must be a finite number"},
        Wrong{"turns", "0.02 -0.02", "1e300 -0.02",
              "blade.txt:4: \"1e300\" stands for theta of side 1, which must be within 100 turns"},
        Wrong{"columns", "0.02 -0.02", "0.02",
              "blade.txt:4: holds 3 words; a point is four numbers, z, r, theta of one side and of the other, and a "
              "new section begins with the word \"section\""},
        Wrong{"no_section", "section 1 hub\n", "",
              "blade.txt:2: must begin with a line \"section\", then its points"},
        Wrong{"millimetres", "1.0 10.0", "1.0 10000.0",
              "blade.txt:4: a point at r = 100 m, z = 0.01 m; r must be more than 0 and at most 10 m, and z at most "
              "that far off: is [mesh] length_unit right?"},
        Wrong{"few_points", "2.0 10.0 0.01 -0.01\n", "",
              "blade.txt:2: the section that begins here has 2 points, and needs 3"},
        Wrong{
            "standing_still", "1.0 10.0", "0.0 10.0",
            "blade.txt:2: two points at the same z and r at point 2 of 3 of the section that begins here; they must "
            "go on from leading to trailing edge"},
        Wrong{"crossing_sides", "0.02 -0.02", "-0.02 0.02",
              "blade.txt:2: the sides of the blade change places at point 1 of 3 of the section that begins here; "
              "each must keep to its own"},
        Wrong{"one_section", "section 2\r\n0.0 12.0 0.01 -0.01\r\n1.0 12.0 0.02 -0.02\r\n2.0 12.0 0.01 -0.01\r\n", "",
              "blade.txt: holds 1 sections of a blade; it must hold two or more, from hub to tip"},
        Wrong{
            "from_the_tip", "section 1 hub\n0.0 10.0 0.01 -0.01\n1.0 10.0 0.02 -0.02  # the middle\n2.0 10.0",
            "section 1 tip\n0.0 14.0 0.01 -0.01\n1.0 14.0 0.02 -0.02  # the middle\n2.0 14.0",
            "blade.txt: section 2 of 2 lies below section 1; write sections from hub to tip, and a wheel whose flow "
            "runs towards smaller z with the signs of z and theta changed"},
        Wrong{"against", "0.0 12.0 0.01 -0.01\r\n1.0 12.0 0.02 -0.02\r\n2.0 12.0",
              "2.0 12.0 0.01 -0.01\r\n1.0 12.0 0.02 -0.02\r\n0.0 12.0",
              "blade.txt: section 2 of 2 runs against section 1; all must run from leading to trailing edge"}));

}  // namespace
}  // namespace tiprub::mesh::section_table_test
