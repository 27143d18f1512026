// SPDX-License-Identifier: GPL-3.0-or-later
#include <cblas.h>

#include <CLI/CLI.hpp>
#include <sstream>

#include "cases/case_file.h"
#include "cases/command_line.h"
#include "cases/output_file.h"
#include "reduce/calculix_deck.h"
#include "reduce/reduced_model_file.h"
#include "reduce/reduction.h"

namespace {

constexpr int verified_frequencies = 50;  // of the whole wheel, as the paper counts them

std::string summary(const tiprub::ReducedModel& model, const tiprub::ReductionReport& report) {
  int dofs = 0;
  for (std::size_t n = 0; n < model.nodal_diameters.size(); ++n)
    dofs += static_cast<int>(model.nodal_diameters[n].M.rows()) *
            (n == 0 || 2 * static_cast<int>(n) == model.sector_count ? 1 : 2);
  std::ostringstream line;
  line << model.sector_count << " sectors of " << report.sector_dofs << " dofs -> " << dofs << " dofs ("
       << model.sector_count * model.contact_dofs() << " of contact); first " << verified_frequencies
       << " frequencies within " << 100 * tiprub::verification_error(model, verified_frequencies) << " % at "
       << model.verification.speeds.size() << " speeds";
  return line.str();
}

void run(const tiprub::StageArguments& arguments, const std::string& calculix_folder) {
  const tiprub::CaseFile case_file(arguments.inputs[0]);
  tiprub::CaseTable table = case_file.table("reduce");
  const auto parameters = tiprub::ReductionParameters::read(table);
  table.close();
  if (arguments.verbosity == tiprub::Verbosity::verbose)
    tiprub::say(arguments, "[reduce]\n" + table.resolved() + "BLAS: " + openblas_get_config());
  const tiprub::SectorMesh mesh = tiprub::read_sector_mesh(arguments.inputs[1], parameters.cyclic_tolerance);
  if (arguments.action == tiprub::Action::check) {
    tiprub::check_sector(mesh, parameters);
    return tiprub::say(arguments,
                       "tiprub-reduce: the case and the sector are sound: " + std::to_string(mesh.sector_count) +
                           " sectors, " + std::to_string(mesh.node_count()) + " nodes, " +
                           std::to_string(mesh.cell_count()) + " bricks of " + std::to_string(mesh.nodes_per_cell()) +
                           " nodes");
  }
  if (!calculix_folder.empty()) {
    tiprub::write_calculix_decks(mesh, parameters, calculix_folder);
    return tiprub::say(arguments, "tiprub-reduce: " + calculix_folder + ": CalculiX decks for " +
                                      std::to_string(parameters.verification_speeds.size()) + " speeds");
  }
  tiprub::OutputFile output(arguments.output);
  tiprub::ReductionReport report;
  tiprub::ReducedModel model =
      tiprub::reduce(mesh, parameters,
                     arguments.verbosity == tiprub::Verbosity::quiet ? tiprub::Progress::Shown::never
                                                                     : tiprub::Progress::Shown::on_a_terminal,
                     report);
  model.provenance = case_file.source();
  tiprub::write_model(model, output.scratch(), tiprub::program_version("tiprub-reduce"));
  output.commit();
  tiprub::say(arguments, "tiprub-reduce: " + arguments.output.string() + ": " + summary(model, report));
}

}  // namespace

int main(int argc, char** argv) {
  std::string calculix_folder;
  const tiprub::Stage stage{
      .name = "tiprub-reduce",
      .summary = "Reduces a sector of a wheel to a small model that knows its speed.",
      .inputs = {{"case.toml", "the scene; its table [reduce] is read"}, {"sector.msh", "one sector of the wheel"}},
      .output = "model.h5",
      .add_options = [&](CLI::App& app) {
        app.add_option("--export-ccx", calculix_folder,
                       "write the sector as CalculiX decks, one a verification speed, into this folder, and stop");
      }};
  return tiprub::run_stage(argc, argv, stage,
                           [&](const tiprub::StageArguments& arguments) { run(arguments, calculix_folder); });
}
