// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/report/report_folder.h"

#include "postprocess/compare/comparison.h"
#include "postprocess/records/critical_speed_record.h"
#include "postprocess/records/exactness_record.h"
#include "postprocess/records/study_records.h"
#include "postprocess/report/json_summary.h"

namespace tiprub {

namespace {

void write_figures(const std::vector<Figure>& figures, const std::filesystem::path& folder, Progress::Shown shown) {
  std::filesystem::create_directories(folder);
  Progress progress("drawing", figures.size(), shown);
  draw_figures(figures, folder, [&] { progress.advance(); });
}

void write_tables(const Study& study, const FieldResults& fields, const std::filesystem::path& folder) {
  write_csv(critical_speed_record(study, fields), folder / "critical_speeds.csv");
  write_text(aligned_text(critical_speed_overview(study, fields)), folder / "critical_speeds.txt");
  write_csv(linear_criterion_record(study), folder / "linear_criterion.csv");
  write_csv(rule_score_record(study.rules), folder / "linear_rules.csv");
  write_csv(speed_record(study), folder / "speeds.csv");
  write_csv(exactness_record(study), folder / "exactness.csv");
  write_csv(drift_record(study.contact, study.model.contact), folder / "contact_drift.csv");
  if (!study.response.branches.empty()) write_csv(branch_record(study.response.branches), folder / "branches.csv");
  if (!study.sweeps.empty())
    write_csv(sweep_record(study.response.speeds, study.amplitudes, study.sweeps), folder / "sweeps.csv");
}

}  // namespace

void write_report_folder(ReportContents& contents, const std::filesystem::path& folder, Progress::Shown shown) {
  if (contents.fields) {
    write_vtu_files(*contents.fields, folder / "fields");
    write_csv(mode_record(*contents.fields), folder / "modes.csv");
    if (!contents.fields->peaks.empty()) write_csv(stress_peak_record(*contents.fields), folder / "stress_peaks.csv");
  }
  write_figures(contents.figures, folder / "figures", shown);
  write_tables(contents.study, contents.field_results, folder);
  write_csv(scene_needs_record(contents.needs), folder / "scene_needs.csv");
  if (contents.other) write_csv(comparison_record(contents.numbers, *contents.other), folder / "comparison.csv");
  write_text(contents.source.case_text, folder / "case.toml");
  write_text(json_summary(contents), folder / "summary.json");
  write_text(to_json(contents.numbers), folder / numbers_file);
  contents.run.done("pictures and tables");
  write_text(report_page(contents, folder), folder / "report.html");
}

}  // namespace tiprub
