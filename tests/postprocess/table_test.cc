// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/tables/table.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "cases/program/errors.h"
#include "postprocess/report/report.h"

namespace tiprub::postprocess {
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

TEST_F(TableFile, QuotesTexts) {
  write_csv({{"a, \"b\" [mm]", "c"}, {{1.25, std::string("x,\ny")}, {-3e-7, std::string()}}}, path_);
  EXPECT_EQ(read_text(path_), "\"a, \"\"b\"\" [mm]\",c\n1.25,\"x,\ny\"\n-3e-07,\n");
}

/// What a stage notes with --times, as the page tells it.
TEST_F(TableFile, OfTimesIsRead) {
  const std::string heading = "program,wall time [s],processor time [s],processors\n";
  write_text(heading + "tiprub-reduce 0.1.0,12.34,20.1,2\n", path_);
  EXPECT_EQ(RunRecord({}, {path_}).in_words().back().text,
            path_.stem().string() + ": tiprub-reduce 0.1.0, 12.3 s, 20.1 s of processor time on 2 processors");
  for (const char* line : {"", "tiprub-reduce 0.1.0,12.34,20.1\n", "tiprub-reduce 0.1.0,-1,20.1,2\n",
                           "tiprub-reduce 0.1.0,nan,20.1,2\n"}) {
    write_text(heading + line, path_);
    EXPECT_THROW(RunRecord({}, {path_}), InputError) << line;
  }
}

/// Symptom: the message of a failed speed in a response.h5 from elsewhere stood in speeds.csv as a formula.
TEST_F(TableFile, HoldsNoFormulas) {
  write_csv({{"a", "b", "c"}, {{"=HYPERLINK(\"x\")", "-2+cmd", "-2.5"}}}, path_);
  EXPECT_EQ(read_text(path_), "a,b,c\n\"'=HYPERLINK(\"\"x\"\")\",'-2+cmd,-2.5\n");
}

}  // namespace
}  // namespace tiprub::postprocess
