// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/compare/comparison.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>

#include "cases/program/errors.h"
#include "synthetic_scene.h"

namespace tiprub {
namespace {

Study made_study() {
  ReducedModel model = synthetic::model();
  Response response = synthetic::resonant_sweep(model);
  return make_study({}, std::move(model), std::move(response), {});
}

double number(const Cell& cell) {
  return std::get<double>(cell);
}

/// Peaks of the same wave 2 % lower and half as high; one that only the other has, one that only this has.
TEST(Comparison, PairsPeaksByTheirWaves) {
  const Study study = made_study();
  const FieldResults fields = field_results(std::nullopt, study.critical);
  ASSERT_GE(study.critical.size(), 2U);
  OtherReport other;
  for (std::size_t i = 1; i < study.critical.size(); ++i) {
    const CriticalSpeed& critical = study.critical[i];
    other.peaks.push_back({critical.speed * 30 / std::numbers::pi / 1.02, 0.5e3 * critical.amplitude,
                           critical.rising.engine_order, critical.rising.signed_nodal_diameter,
                           critical.rising.family + 1, std::nullopt});
  }
  other.peaks.push_back({99999, 0.25, 3, 3, 1, 100});
  const Table table = comparison_record(study, fields, other);
  ASSERT_EQ(table.rows.size(), study.critical.size() + 1);
  EXPECT_EQ(std::get<std::string>(table.rows.front()[2]), "");  // none there
  for (std::size_t i = 1; i < study.critical.size(); ++i) {
    EXPECT_NEAR(number(table.rows[i][3]), 2, 1e-9);
    EXPECT_NEAR(number(table.rows[i][6]), 100, 1e-9);
    EXPECT_EQ(std::get<std::string>(table.rows[i][9]), "");  // no stress here
  }
  EXPECT_EQ(std::get<std::string>(table.rows.back()[0]), "EO 3 ND +3");
  EXPECT_EQ(std::get<std::string>(table.rows.back()[1]), "");
  EXPECT_EQ(number(table.rows.back()[8]), 100);
}

TEST(Comparison, ReadsWhatWasWritten) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "read.csv";
  write_csv({{"a, \"b\" [mm]", "c"}, {{1.25, std::string("x,\ny")}, {-3e-7, std::string()}}}, file);
  const CsvTable table = read_csv(file);
  EXPECT_EQ(table.header[0], "a, \"b\" [mm]");
  EXPECT_EQ(table.numbers(table.header[0]), Eigen::Vector2d(1.25, -3e-7));
  EXPECT_EQ(table.rows[0][1], "x,\ny");
  EXPECT_THROW(table.numbers("c"), InputError);
  EXPECT_THROW(table.numbers("d"), InputError);
  std::ofstream(file) << "a,b\n1,2\n3\n";
  EXPECT_THROW(read_csv(file), InputError);
  std::ofstream(file) << "a\nnan\n";
  EXPECT_THROW(read_csv(file).numbers("a"), InputError);
}

}  // namespace
}  // namespace tiprub
