// SPDX-License-Identifier: GPL-3.0-or-later
#include <cblas.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <sstream>

#include "cases/program/case_file.h"
#include "cases/program/command_line.h"
#include "cases/program/output_file.h"
#include "reduce/calculix_deck.h"
#include "reduce/linear_results.h"
#include "reduce/model/matrix_market.h"
#include "reduce/model/nodal_diameter.h"
#include "reduce/model/reduced_model_file.h"
#include "reduce/model/verification.h"
#include "reduce/reduction.h"

namespace {

constexpr double tolerable_misfit = 0.01;  // of a frequency, by eq. 7 alone
constexpr double bytes_per_gib = 1024.0 * 1024 * 1024;

std::string summary(const tiprub::ReducedModel& model, const tiprub::ReductionReport& report) {
  const int contact = model.contact_dofs();
  int dofs = 0, dofs_at_speed = 0;
  for (std::size_t n = 0; n < model.nodal_diameters.size(); ++n) {
    const int waves = tiprub::wave_count(static_cast<int>(n), model.sector_count);
    const int generalized = static_cast<int>(model.nodal_diameters[n].M.rows()) - contact;
    dofs += waves * (contact + generalized);
    dofs_at_speed +=
        waves * (contact + (model.modes_at_speed > 0 ? std::min(model.modes_at_speed, generalized) : generalized));
  }
  const tiprub::ModelError verified = tiprub::model_error(model);
  std::ostringstream line;
  line << model.sector_count << " sectors of " << report.sector_dofs << " dofs -> " << dofs << " dofs, "
       << dofs_at_speed << " at any one speed (" << model.sector_count * contact << " of contact); first "
       << verified.frequencies << " frequencies within " << 100 * verified.error << " % at "
       << model.verification.speeds.size() << " speeds";
  if (model.verification.polynomial_misfit.size() > 0)
    line << ", eq. 7 through " << report.polynomial_speeds << " speeds alone within "
         << 100 * model.verification.polynomial_misfit.maxCoeff() << " %; shapes under spin in "
         << report.newton_steps << " Newton steps to " << report.newton_residual;
  return line.str();
}

/// What only this stage has on its command line.
struct Options {
  std::string calculix_folder;
  std::string modes_file;
  std::string matrix_market_folder;
  std::string fields_file;
};

void check(const tiprub::StageArguments& arguments, const tiprub::SectorMesh& mesh,
           const tiprub::ReductionParameters& parameters) {
  tiprub::check_sector(mesh, parameters);
  tiprub::say(arguments, "tiprub-reduce: the case and the sector are sound: " + std::to_string(mesh.sector_count) +
                             " sectors, " + std::to_string(mesh.node_count()) + " nodes, " +
                             std::to_string(mesh.cell_count()) + " bricks of " +
                             std::to_string(mesh.nodes_per_cell()) + " nodes");
}

void export_decks(const tiprub::StageArguments& arguments, const tiprub::SectorMesh& mesh,
                  const tiprub::ReductionParameters& parameters, const std::string& folder) {
  tiprub::write_calculix_decks(mesh, parameters, folder);
  tiprub::say(arguments, "tiprub-reduce: " + folder + ": CalculiX decks for " +
                             std::to_string(parameters.verification_speeds.size()) + " speeds");
}

void find_modes(const tiprub::StageArguments& arguments, const tiprub::SectorMesh& mesh,
                const tiprub::ReductionParameters& parameters, const std::string& file,
                const std::string& provenance) {
  tiprub::OutputFile output(file);
  const tiprub::LinearResults results = tiprub::linear_results(mesh, parameters);
  tiprub::write_linear_results(results, output.scratch(), tiprub::program_version("tiprub-reduce"), provenance);
  output.commit();
  tiprub::print(std::cout, results);
  tiprub::say(arguments, "tiprub-reduce: " + file + ": " + std::to_string(parameters.verification_modes) +
                             " modes of " + std::to_string(results.nodal_diameters.size()) + " nodal diameters at " +
                             std::to_string(results.speed_count()) + " speeds");
}

/// Reduces, and writes the full fields beside it if a file is named for them.
tiprub::ReducedModel reduce_with_fields(const tiprub::StageArguments& arguments, const tiprub::SectorMesh& mesh,
                                        const tiprub::ReductionParameters& parameters, const std::string& fields_file,
                                        tiprub::ReductionReport& report) {
  const auto shown = arguments.verbosity == tiprub::Verbosity::quiet ? tiprub::Progress::Shown::never
                                                                     : tiprub::Progress::Shown::on_a_terminal;
  if (fields_file.empty()) return tiprub::reduce(mesh, parameters, shown, report);
  tiprub::OutputFile output(fields_file);
  tiprub::ReducedModel model = [&] {
    tiprub::FieldsWriter fields(output.scratch(), tiprub::program_version("tiprub-reduce"));
    return tiprub::reduce(mesh, parameters, shown, report, &fields);
  }();
  output.commit();
  return model;
}

tiprub::ReducedModel make_model(const tiprub::StageArguments& arguments, const tiprub::SectorMesh& mesh,
                                const tiprub::ReductionParameters& parameters, const std::string& provenance,
                                const std::string& fields_file) {
  { const tiprub::OutputFile writable(arguments.output); }  // complain before the work, not after it
  tiprub::ReductionReport report;
  tiprub::ReducedModel model = reduce_with_fields(arguments, mesh, parameters, fields_file, report);
  tiprub::OutputFile output(arguments.output);
  if (arguments.verbosity == tiprub::Verbosity::verbose) {
    tiprub::say(arguments, "memory: " + std::to_string(report.memory_needed / bytes_per_gib) + " GiB expected");
    for (const auto& [what, seconds] : report.seconds)
      tiprub::say(arguments, what + ": " + std::to_string(seconds) + " s");
    for (std::size_t n = 0; n < report.corrections.size(); ++n)
      tiprub::say(arguments, "nodal diameter " + std::to_string(n) + ": " +
                                 std::to_string(report.generalized_dofs[n]) + " generalized dofs, " +
                                 std::to_string(report.corrections[n]) + " of them from modes between the speeds; " +
                                 std::to_string(report.dropped[n]) + " shapes dropped");
  }
  model.provenance = provenance;
  tiprub::write_model(model, output.scratch(), tiprub::program_version("tiprub-reduce"));
  output.commit();
  tiprub::say(arguments, "tiprub-reduce: " + arguments.output.string() + ": " + summary(model, report));
  if (const Eigen::MatrixXd& misfit = model.verification.polynomial_misfit;
      misfit.size() > 0 && misfit.maxCoeff() > tolerable_misfit)
    tiprub::say(arguments,
                "tiprub-reduce: warning: the shape changes too much for eq. 7 between its speeds; lower "
                "speed_max_rpm, or take prestress = \"linear\", for which eq. 7 is exact");
  return model;
}

void run(const tiprub::StageArguments& arguments, const Options& options) {
  const tiprub::CaseFile case_file(arguments.inputs[0], arguments.settings);
  tiprub::CaseTable table = case_file.table("reduce");
  const auto parameters = tiprub::ReductionParameters::read(table);
  table.close();
  if (arguments.verbosity == tiprub::Verbosity::verbose)
    tiprub::say(arguments, "[reduce]\n" + table.resolved() + "BLAS: " + openblas_get_config());
  const tiprub::SectorMesh mesh = tiprub::read_sector_mesh(arguments.inputs[1], parameters.cyclic_tolerance);
  if (arguments.action == tiprub::Action::check) return check(arguments, mesh, parameters);
  if (!options.calculix_folder.empty()) return export_decks(arguments, mesh, parameters, options.calculix_folder);
  if (!options.modes_file.empty())
    return find_modes(arguments, mesh, parameters, options.modes_file, case_file.source());
  const tiprub::ReducedModel model = make_model(arguments, mesh, parameters, case_file.source(), options.fields_file);
  if (!options.matrix_market_folder.empty()) {
    tiprub::write_matrix_market(model, options.matrix_market_folder);
    tiprub::say(arguments, "tiprub-reduce: " + options.matrix_market_folder + ": K0, K1, K2, M of " +
                               std::to_string(model.nodal_diameters.size()) + " nodal diameters in Matrix Market");
  }
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  const tiprub::Stage stage{
      .name = "tiprub-reduce",
      .summary = "Reduces a sector of a wheel to a small model that knows its speed.",
      .inputs = {{"case.toml", "the scene; its table [reduce] is read"}, {"sector.msh", "one sector of the wheel"}},
      .output = "model.h5",
      .add_options = [&](CLI::App& app) {
        app.add_option("--export-ccx", options.calculix_folder,
                       "write the sector as CalculiX decks, one a verification speed, into this folder, and stop");
        app.add_option(
            "--modes", options.modes_file,
            "write modes and static state of the unreduced sector at the verification speeds into this file "
            "and onto stdout, and stop");
        app.add_option("--export-matrix-market", options.matrix_market_folder,
                       "also write the model's matrices in Matrix Market format into this folder");
        app.add_option("--fields", options.fields_file,
                       "also write the basis on all nodes into this file (fields.h5), for displacement and stress of "
                       "the whole wheel");
      }};
  return tiprub::run_stage(argc, argv, stage,
                           [&](const tiprub::StageArguments& arguments) { run(arguments, options); });
}
