// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/report/json_summary.h"

#include <nlohmann/json.hpp>

#include "cases/program/command_line.h"
#include "postprocess/compare/comparison.h"
#include "postprocess/records/critical_speed_record.h"
#include "postprocess/records/exactness_record.h"
#include "postprocess/records/study_records.h"
#include "postprocess/report/verdict.h"

namespace tiprub {

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

}  // namespace

std::string json_summary(const ReportContents& contents) {
  const Study& study = contents.study;
  ordered_json summary = {{"schema", "tiprub-summary"},
                          {"schema_version", 1},
                          {"generator", program_version("tiprub-postprocess")},
                          {"title", contents.source.title},
                          {"verdict", answers_of(verdict(study, contents.field_results, contents.needs))},
                          {"scene", answers_of(scene_in_brief(study))},
                          {"critical_speeds", rows_of(critical_speed_record(study, contents.field_results))},
                          {"speeds", rows_of(speed_record(study))},
                          {"exactness", rows_of(exactness_record(study))},
                          {"scene_needs", rows_of(scene_needs_record(contents.needs))},
                          {"linear_rules", rows_of(rule_score_record(study.rules))}};
  if (contents.other) summary["comparison"] = rows_of(comparison_record(contents.numbers, *contents.other));
  // What is no UTF-8 in a case's title is shown as such, not a failure.
  return summary.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace tiprub
