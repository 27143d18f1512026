// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/tables/table.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "cases/program/errors.h"

namespace tiprub {
namespace {

class TableFile : public ::testing::Test {
 protected:
  ~TableFile() override { std::filesystem::remove(path_); }

  const std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("tiprub-table-" + std::to_string(getpid()) + ".csv");
};

/// Once stresses that were no numbers became 0 MPa, or NaN, in a table that looked sound.
TEST_F(TableFile, RefusesANumberThatIsNone) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) try {
      write_csv({{"speed [rpm]", "stress [MPa]"}, {{1000.0, 1.0}, {1100.0, bad}}}, path_);
      ADD_FAILURE() << "accepted";
    } catch (const RunError& error) {
      const std::string expected =
          path_.filename().string() + ": column \"stress [MPa]\", row 2: the number is not finite";
      EXPECT_EQ(std::string(error.what()).substr(0, expected.size()), expected);
    }
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(TableFile, SaysWhereThereIsNoNumber) {
  const Table table{{"a", "b"}, {{1.5, NoNumber{}}, {number_if_any(std::nan("")), number_if_any(2)}}};
  write_csv(table, path_);
  EXPECT_EQ(read_text(path_), "a,b\n1.5,NaN\nNaN,2\n");
  EXPECT_EQ(aligned_text(table), "  a  b\n1.5   \n     2\n");
}

}  // namespace
}  // namespace tiprub
