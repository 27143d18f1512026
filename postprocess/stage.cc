// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/stage.h"

#include <cblas.h>

#include <cstdio>
#include <future>
#include <utility>

#include "cases/program/output_file.h"
#include "cases/program/progress.h"
#include "cases/program/signal_cleanup.h"
#include "cases/program/text.h"
#include "postprocess/analysis/input_check.h"
#include "postprocess/compare/comparison.h"
#include "postprocess/fields/node_stress.h"
#include "postprocess/figures/drawing.h"
#include "postprocess/figures/study_figures.h"
#include "postprocess/records/study_records.h"
#include "postprocess/report/report.h"
#include "reduce/model/reduced_model_file.h"
#include "simulate/response/response_file.h"

namespace fs = std::filesystem;

namespace tiprub::postprocess {

namespace {

struct Inputs {
  std::string title, case_text;  ///< of the case
  PostprocessParameters parameters;
  std::optional<MaterialStrength> strength;
  ReducedModel model;
  Response response;
  SweepFiles sweeps;
  RunRecord run{{}, {}};
};

Inputs read_inputs(const StageArguments& arguments, const PostprocessOptions& options) {
  const CaseFile file(arguments.inputs[0], arguments.settings);
  CaseTable table = file.table("postprocess");
  Inputs inputs;
  std::vector<fs::path> files = arguments.inputs;
  for (const fs::path& fields : {options.fields_file, options.budget_fields})
    if (!fields.empty()) files.push_back(fields);
  files.insert(files.end(), options.compared.begin(), options.compared.end());
  inputs.run = RunRecord(files, options.runs);
  inputs.parameters = read_postprocess_parameters(table);
  inputs.strength = read_material_strength(file);
  if (arguments.verbosity == Verbosity::verbose) say(arguments, "[postprocess]\n" + table.resolved());
  inputs.title = file.title();
  inputs.case_text = file.source();
  inputs.model = read_model(arguments.inputs[1]);
  inputs.response = read_response(arguments.inputs[2]);
  check_together(inputs.model, inputs.response, arguments.inputs[2].string());
  if (file.has("casing"))
    check_casing(file.table("casing").written(), inputs.response.scene, arguments.inputs[2].string());
  const auto beside_response = [&](const std::string& name) {
    return name.empty() ? fs::path() : arguments.inputs[2].parent_path() / name;
  };
  inputs.sweeps = {beside_response(inputs.parameters.response_up), beside_response(inputs.parameters.response_down)};
  std::vector<fs::path> others = options.runs;
  others.insert(others.end(), options.compared.begin(), options.compared.end());
  others.insert(others.end(), {options.fields_file, options.budget_fields, inputs.sweeps.up, inputs.sweeps.down});
  refuse_overwriting({arguments.output}, others);
  require_gnuplot();
  return inputs;
}

Study study_of(Inputs& inputs) {
  return make_study(inputs.parameters, std::move(inputs.model), std::move(inputs.response), inputs.sweeps);
}

void print(const std::string& table) {
  if (std::fputs(table.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
    throw RunError("stdout: can't be written to its end; is the disk full?");
}

std::optional<FieldsReader> open_fields(const PostprocessOptions& options, const ReducedModel& model) {
  if (options.fields_file.empty()) return std::nullopt;
  FieldsReader fields(options.fields_file);
  check_fields(fields, model);
  return fields;
}

/// Those of the model that error budgets compare with.
std::optional<FieldsReader> open_budget_fields(const PostprocessOptions& options, const Response& response) {
  if (options.budget_fields.empty()) return std::nullopt;
  FieldsReader fields(options.budget_fields);
  check_budget_fields(fields, response);
  return fields;
}

std::vector<SceneNeed> needs_of(const Study& study, const std::optional<FieldsReader>& fields) {
  return scene_needs(study, fields ? field_effects(*fields, study.model, study.critical) : FieldEffects());
}

/// Draws while the caller goes on.
std::future<void> start_drawing(std::vector<Figure> figures, const fs::path& folder) {
  return std::async(std::launch::async,
                    [figures = std::move(figures), folder] { draw_figures(figures, folder / "figures"); });
}

/// Checks the inputs and prints what the scene needs, which takes no pictures and no stress.
void check(Inputs inputs, const PostprocessOptions& options) {
  const std::optional<FieldsReader> fields = open_fields(options, inputs.model);
  open_budget_fields(options, inputs.response);
  const Study study = study_of(inputs);
  for (const fs::path& other : options.compared) read_other_report(other, study);
  print(aligned_text(scene_needs_record(needs_of(study, fields))));
}

/// All contents, with their figures in the folder; those that show full fields may still be drawn there.
std::pair<ReportContents, std::future<void>> run(Inputs inputs, const PostprocessOptions& options,
                                                 const fs::path& folder, Progress::Shown shown) {
  const std::optional<FieldsReader> fields = open_fields(options, inputs.model);
  const std::optional<FieldsReader> others = open_budget_fields(options, inputs.response);
  inputs.run.done("reading");
  ReportContents contents{.study = study_of(inputs), .title = inputs.title, .case_text = inputs.case_text};
  const Study& study = contents.study;
  inputs.run.done("study");
  for (const fs::path& other : options.compared) {
    contents.others.push_back(read_other_report(other, study));
    compare_cases(contents.others.back(),
                  fs::is_directory(other) ? contents.case_text : study.response.scene.swept_case());
  }
  const std::vector<Figure> figures = study_figures(study);
  std::future<void> drawing = start_drawing(figures, folder);
  if (fields) contents.fields = recover_fields(*fields, others ? &*others : nullptr, study, inputs.strength, shown);
  contents.field_results = field_results(contents.fields, study.critical);
  contents.numbers = report_numbers(study, contents.field_results);
  contents.needs = needs_of(study, fields);
  contents.figures = response_figures(study, contents.field_results);
  std::vector<Figure> last;
  if (contents.fields) last = sector_figures(study, *contents.fields);
  if (!contents.others.empty())
    last = joined<Figure>({last,
                           {comparison_figure(contents.numbers, contents.others),
                            comparison_map_figure(study, contents.numbers, contents.others.front())}});
  drawing.get();
  drawing = start_drawing(joined<Figure>({contents.figures, last}), folder);
  contents.figures = joined<Figure>({contents.figures, figures, last});
  inputs.run.done("fields");
  contents.run = std::move(inputs.run);
  return {std::move(contents), std::move(drawing)};
}

void report(const StageArguments& arguments, const ReportContents& contents) {
  const Study& study = contents.study;
  print(printed_critical_speeds(study, contents.field_results));
  if (arguments.verbosity == Verbosity::verbose) {
    for (const Answer& answer : verdict(study, contents.field_results, contents.needs))
      say(arguments, answer.question + ": " + answer.text);
    for (const std::string& line : summary(study)) say(arguments, line);
    for (const Answer& answer : contents.run.in_words()) say(arguments, answer.question + ": " + answer.text);
  }
  say(arguments, (arguments.output / "report.html").lexically_normal().string() + ": " + doubts(study.model) +
                     std::to_string(study.critical.size()) + " critical speeds, " +
                     std::to_string(study.response.speeds.size()) + " speeds, " +
                     std::to_string(contents.figures.size()) + " figures");
}

}  // namespace

std::string postprocess_tables(const CaseFile& file) {
  std::string text =
      "title = " + in_quotes(file.title()) + "\n" + file.resolved("postprocess", read_postprocess_parameters);
  if (file.has("material")) text += file.resolved("material", read_strength);
  return text;
}

void run_postprocess(const StageArguments& arguments, const PostprocessOptions& options) try {
  openblas_set_num_threads(1);  // this program's own threads share its products
  if (arguments.action == Action::check) return check(read_inputs(arguments, options), options);
  const OutputLock lock(arguments.output);
  OutputFile output(arguments.output, OutputFile::Kind::folder);
  Inputs inputs = read_inputs(arguments, options);
  note_interruptions();
  const Progress::Shown shown =
      arguments.verbosity == Verbosity::quiet ? Progress::Shown::never : Progress::Shown::on_a_terminal;
  auto [contents, drawing] = run(std::move(inputs), options, output.scratch(), shown);
  write_report_folder(contents, std::move(drawing), output.scratch());
  stop_if_interrupted();
  output.commit();
  report(arguments, contents);
} catch (const Interrupted&) {  // everything is cleaned up; leave as the other stages do
  constexpr int exit_by_signal = 128;
  tell_interruption();
  std::_Exit(exit_by_signal + interruption());
}

}  // namespace tiprub::postprocess
