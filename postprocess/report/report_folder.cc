// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/report/report.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "cases/program/command_line.h"
#include "postprocess/compare/comparison.h"
#include "postprocess/fields/field_vtu.h"
#include "postprocess/records/error_budget_record.h"
#include "postprocess/records/exactness_record.h"
#include "postprocess/records/study_records.h"

namespace tiprub::postprocess {

namespace {

using nlohmann::ordered_json;

/// A cell without a number or a text is null.
ordered_json value_of(const Cell& cell) {
  if (const auto* value = std::get_if<double>(&cell)) return *value;
  if (const auto* whole = std::get_if<int>(&cell)) return *whole;
  if (const auto* text = std::get_if<std::string>(&cell); text && !text->empty()) return *text;
  return nullptr;
}

ordered_json rows_of(const Table& table) {
  ordered_json rows = ordered_json::array();
  for (const auto& row : table.rows) {
    ordered_json entry = ordered_json::object();
    for (std::size_t i = 0; i < row.size(); ++i) entry[table.header[i]] = value_of(row[i]);
    rows.push_back(std::move(entry));
  }
  return rows;
}

ordered_json answers_of(const std::vector<Answer>& answers) {
  ordered_json entries = ordered_json::object();
  for (const Answer& answer : answers) entries[answer.question] = answer.text;
  return entries;
}

ordered_json lines_of(const std::string& text) {
  ordered_json lines = ordered_json::array();
  std::istringstream source(text);
  for (std::string line; std::getline(source, line);) lines.push_back(line);
  return lines;
}

/// The page's tables and first screen for programs: JSON, schema "tiprub-summary". A row is an object with the
/// columns' names, which have the units.
std::string json_summary(const ReportContents& contents) {
  const Study& study = contents.study;
  ordered_json summary = {{"schema", "tiprub-summary"},
                          {"schema_version", 1},
                          {"generator", program_version("tiprub-postprocess")},
                          {"title", contents.title},
                          {"verdict", answers_of(verdict(study, contents.field_results, contents.needs))},
                          {"scene", answers_of(scene_in_brief(study))},
                          {"scope", lines_of(study.response.scene.scope)},
                          {"critical_speeds", rows_of(critical_speed_record(study, contents.field_results))},
                          {"speeds", rows_of(speed_record(study, contents.field_results))},
                          {"exactness", rows_of(exactness_record(study))},
                          {"scene_needs", rows_of(scene_needs_record(contents.needs))},
                          {"error_budget", rows_of(error_budget_record(study, contents.field_results))},
                          {"linear_rules", rows_of(rule_score_record(study.rules))}};
  if (!contents.others.empty()) {
    summary["comparison"] = rows_of(comparison_record(contents.numbers, contents.others));
    summary["reports"] = rows_of(reports_record(contents.numbers, contents.others));
  }
  // Bytes of a case's title that are not UTF-8 are replaced.
  return summary.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

void write_tables(const Study& study, const FieldResults& fields, const std::filesystem::path& folder) {
  write_csv(critical_speed_record(study, fields), folder / "critical_speeds.csv");
  write_text(printed_critical_speeds(study, fields), folder / "critical_speeds.txt");
  write_csv(linear_criterion_record(study), folder / "linear_criterion.csv");
  write_csv(rule_score_record(study.rules), folder / "linear_rules.csv");
  write_csv(speed_record(study, fields), folder / "speeds.csv");
  write_csv(exactness_record(study), folder / "exactness.csv");
  write_csv(drift_record(study.contact, study.model.contact), folder / "contact_drift.csv");
  if (!study.response.branches.empty()) write_csv(branch_record(study.response.branches), folder / "branches.csv");
  if (const Table budget = error_budget_record(study, fields); !budget.rows.empty())
    write_csv(budget, folder / "error_budget.csv");
  if (!study.sweeps.empty())
    write_csv(sweep_record(study.response.speeds, study.amplitudes, study.sweeps), folder / "sweeps.csv");
}

}  // namespace

void write_report_folder(ReportContents& contents, std::future<void> drawing, const std::filesystem::path& folder) {
  if (contents.fields) {
    write_vtu_files(*contents.fields, folder / "fields");
    write_csv(mode_record(*contents.fields), folder / "modes.csv");
    if (!contents.fields->peaks.empty()) write_csv(stress_peak_record(*contents.fields), folder / "stress_peaks.csv");
  }
  write_tables(contents.study, contents.field_results, folder);
  write_csv(scene_needs_record(contents.needs), folder / "scene_needs.csv");
  if (!contents.others.empty()) {
    write_csv(comparison_record(contents.numbers, contents.others), folder / "comparison.csv");
    write_csv(reports_record(contents.numbers, contents.others), folder / "reports.csv");
  }
  write_text(contents.case_text, folder / "case.toml");
  write_text(json_summary(contents), folder / "summary.json");
  write_text(to_json(contents.numbers), folder / numbers_file);
  drawing.get();
  contents.run.done("pictures and tables");
  write_text(report_page(contents, folder), folder / "report.html");
}

}  // namespace tiprub::postprocess
