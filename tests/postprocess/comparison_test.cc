// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/compare/comparison.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>

#include "cases/program/errors.h"
#include "synthetic_scene.h"

namespace tiprub::postprocess {
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
  const ReportNumbers here = report_numbers(study, fields);
  ReportNumbers other;
  for (std::size_t i = 1; i < study.critical.size(); ++i) {
    const CriticalSpeed& critical = study.critical[i];
    other.peaks.push_back({critical.speed * 30 / std::numbers::pi / 1.02, 0.5e3 * critical.amplitude,
                           critical.rising.engine_order, critical.rising.signed_nodal_diameter,
                           critical.rising.family + 1, std::nullopt});
  }
  other.peaks.push_back({99999, 0.25, 3, 3, 1, 100});
  const Table table = comparison_record(here, other);
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

/// All that is compared comes over, up to the engine orders that are drawn.
TEST(Comparison, ReadsTheNumbersOfAReport) {
  const Study study = made_study();
  ReportNumbers here = report_numbers(study, field_results(std::nullopt, study.critical));
  here.peaks.front().stress = 125;
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir());
  write_text(to_json(here), folder / numbers_file);
  const ReportNumbers there = read_other_report(folder, study);
  EXPECT_EQ(there.speed, here.speed);
  EXPECT_EQ(there.amplitude, here.amplitude);
  ASSERT_EQ(there.peaks.size(), here.peaks.size());
  EXPECT_EQ(there.peaks.front().stress, 125);
  for (const auto& row : comparison_record(here, there).rows) EXPECT_EQ(number(row[3]), 0);
  ASSERT_EQ(there.leading_map.columns.size(), here.leading_map.columns.size());
  for (std::size_t i = 0; i < there.leading_map.columns.size(); ++i) {
    const MapColumn &a = here.leading_map.columns[i], &b = there.leading_map.columns[i];
    EXPECT_LE(a.spectrum.engine_order(a.spectrum.lines() - 1), study.parameters.engine_order_max);
    ASSERT_EQ(a.total.size(), b.total.size());
    EXPECT_TRUE(a.total.isApprox(b.total, 1e-14));
    EXPECT_TRUE(a.total.isApprox(study.waves.first().columns[i].total.head(a.total.size()), 1e-14));
  }
}

TEST(Comparison, RefusesWhatIsNoReport) {
  const Study study = made_study();
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "no_report";
  std::filesystem::create_directories(folder);
  const auto message = [&] {
    try {
      read_other_report(folder, study);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  std::filesystem::remove(folder / numbers_file);
  EXPECT_NE(message().find("has no numbers.json to compare with"), std::string::npos) << message();
  const std::string sound = to_json(report_numbers(study, field_results(std::nullopt, study.critical)));
  std::string old = sound, lost = sound;
  old.replace(old.find("\"schema_version\":1"), 18, "\"schema_version\":0");
  lost.replace(lost.find("\"largest_mm\":["), 14, "\"largest_mm\":[1,");
  for (const std::string& text : {std::string("{"), std::string("{}"), std::string("[1, null]"), old, lost}) {
    write_text(text, folder / numbers_file);
    EXPECT_NE(message().find("numbers.json: "), std::string::npos) << text.substr(0, 80) << message();
  }
}

}  // namespace
}  // namespace tiprub::postprocess
