// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/compare/comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "cases/program/errors.h"
#include "synthetic_scene.h"

namespace tiprub::postprocess::comparison_test {
namespace {

Study made_study() {
  ReducedModel model = synthetic::model();
  Response response = synthetic::resonant_sweep(model);
  return make_study({}, std::move(model), std::move(response), {});
}

double number(const Cell& cell) {
  return std::get<double>(cell);
}

/// Symptom: of one critical speed that different waves make in two reports, each had a row, and no change was told.
TEST(Comparison, PairsPeaksOfOtherWavesByTheirPlaces) {
  ReportNumbers here, other;
  here.peaks = {{10000, 0.2, 6, -4, 1, std::nullopt}, {12000, 0.1, 10, 0, 2, std::nullopt}};
  other.peaks = {{9960, 0.1, 10, 0, 2, std::nullopt}, {14000, 0.3, 8, 2, 1, std::nullopt}};
  const Table table = comparison_record(here, other);
  ASSERT_EQ(table.rows.size(), 3U);  // 12,000 rpm has the wave of 9960 rpm, which comes before the place
  EXPECT_EQ(std::get<std::string>(table.rows[1][0]), "EO 10 ND 0");
  here.peaks.pop_back();
  const Table by_place = comparison_record(here, other);
  ASSERT_EQ(by_place.rows.size(), 2U);
  EXPECT_EQ(std::get<std::string>(by_place.rows[0][0]), "EO 6 ND -4, there EO 10 ND 0");
  EXPECT_NEAR(number(by_place.rows[0][3]), 100 * (10000 / 9960.0 - 1), 1e-9);
}

/// What differs: the worst peaks, the keys, the grids.
TEST(Comparison, TellsWhatDiffers) {
  ReportNumbers here, other;
  here.speed = here.amplitude = Eigen::VectorXd::LinSpaced(5, 1000, 2000);
  other.speed = other.amplitude = Eigen::VectorXd::LinSpaced(3, 1000, 2000);
  here.peaks = {{1100, 0.3, 6, -4, 1, std::nullopt}};
  other.peaks = {{1000, 0.2, 6, -4, 1, std::nullopt}};
  other.case_text =
      "title = \"Wide\"\n[casing]\nlobes = 2  # as before\nclearance = [[0.0, 3e-4],\n"
      "  [1.0, 3e-4]]\n# --set simulate.budget=\"none\"\n";
  compare_cases(other, "title = \"Narrow\"\n[casing]\nclearance = [[0.0, 2e-4], [1.0, 2e-4]]\nlobes = 2\n");
  EXPECT_EQ(other.name, "Wide");
  EXPECT_EQ(other.changes, (std::vector<std::string>{
                               "casing.clearance: [[0, 0.0002], [1, 0.0002]], there [[0, 0.0003], [1, 0.0003]]",
                               "simulate.budget: not given, there \"none\""}));
  const std::string words = comparison_in_words(here, other);
  for (const char* part : {"0.300 mm at 1100 rpm (EO 6 ND -4) here", "speed +10.0 %, amplitude +50.0 %",
                           "differ in casing.clearance", "5 from 1000 to 2000 rpm here, 3 from"})
    EXPECT_NE(words.find(part), std::string::npos) << part << "\n" << words;
}

/// Symptom: of a response that was compared, no key was told to differ. Its provenance holds the case of its model
/// too.
TEST(Comparison, TakesTheCaseOfAResponseFromItsProvenance) {
  Response response;
  response.scene.provenance = "# case\n[casing]\nlobes = 3\n\n# model\n# case\n[casing]\nlobes = 2\n";
  ReportNumbers other;
  other.case_text = response.scene.swept_case();
  compare_cases(other, "[casing]\nlobes = 4\n");
  EXPECT_EQ(other.changes, std::vector<std::string>{"casing.lobes: 4, there 3"});
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

/// Of several reports a table has a row for each, with the largest peak and the bands; the other one says which peaks
/// are whose.
TEST(Comparison, TellsWorstPeaksAndBandsOfSeveral) {
  ReportNumbers here, wide, still;
  here.peaks = {{10000, 0.2, 6, -4, 1, 400.0, 0.8}, {12000, 0.3, 10, 0, 2, 500.0, 1.2}};
  here.avoid = "11900 to 12100 rpm (Goodman above 1).";
  wide.peaks = {{9000, 0.1, 6, -4, 1, std::nullopt}};
  wide.name = "Wide";
  wide.changes = {"casing.lobes: 2, there 3", "simulate.gap: \"linear\", there not given"};
  still.name = "Still";
  const Table table = reports_record(here, {wide, still});
  ASSERT_EQ(table.rows.size(), 3U);
  const auto cell = [&](std::size_t row, const char* name) {
    const auto column = std::find(table.header.begin(), table.header.end(), name) - table.header.begin();
    return csv_cell(table.rows[row].at(static_cast<std::size_t>(column)));
  };
  EXPECT_EQ(cell(0, "largest [rpm]"), "12000");
  EXPECT_EQ(cell(0, "its Goodman"), "1.2");
  EXPECT_EQ(cell(0, "speeds to avoid"), here.avoid);
  EXPECT_EQ(cell(1, "report"), "Wide");
  EXPECT_NE(cell(1, "keys that differ").find("casing.lobes: 2, there 3; simulate.gap"), std::string::npos);
  EXPECT_EQ(cell(1, "its stress with spin [MPa]"), "");
  EXPECT_EQ(cell(2, "critical speeds"), "0");
  EXPECT_EQ(cell(2, "largest [rpm]"), "");
  const Table pairs = comparison_record(here, std::vector{wide, still});
  ASSERT_EQ(pairs.rows.size(), 4U);
  EXPECT_EQ(pairs.header.front(), "report");
  EXPECT_EQ(std::get<std::string>(pairs.rows.front().front()), "Wide");
  EXPECT_EQ(std::get<std::string>(pairs.rows.back().front()), "Still");
  EXPECT_EQ(comparison_record(here, std::vector{wide}).header, comparison_record(here, wide).header);
}

/// All that is compared comes over, up to the engine orders that are drawn.
TEST(Comparison, ReadsTheNumbersOfAReport) {
  const Study study = made_study();
  ReportNumbers here = report_numbers(study, field_results(std::nullopt, study.critical));
  here.peaks.front().stress = 125;
  here.peaks.front().goodman = 0.75;
  here.avoid = "1000 to 1100 rpm (Goodman above 1).";
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir());
  write_text(to_json(here), folder / numbers_file);
  const ReportNumbers there = read_other_report(folder, study);
  EXPECT_EQ(there.speed, here.speed);
  EXPECT_EQ(there.amplitude, here.amplitude);
  ASSERT_EQ(there.peaks.size(), here.peaks.size());
  EXPECT_EQ(there.peaks.front().stress, 125);
  EXPECT_EQ(there.peaks.front().goodman, 0.75);
  EXPECT_EQ(there.avoid, here.avoid);
  EXPECT_EQ(there.component, "displacement along the casing normal");
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

/// Symptom: an axial displacement was compared with one along the normal.
TEST(Comparison, TellsThatComponentsDiffer) {
  const Study study = made_study();
  const ReportNumbers here = report_numbers(study, field_results(std::nullopt, study.critical));
  ReportNumbers there = here;
  const auto told = [&] { return comparison_in_words(here, there).find("cannot be compared") != std::string::npos; };
  const auto has_change = [&] { return std::holds_alternative<double>(comparison_record(here, there).rows[0][6]); };
  EXPECT_FALSE(told());
  EXPECT_TRUE(has_change());
  there.component = name_of(Component::axial);
  EXPECT_TRUE(told());
  EXPECT_FALSE(has_change());
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
}  // namespace tiprub::postprocess::comparison_test
