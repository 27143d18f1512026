// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/stage.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <iomanip>
#include <iostream>
#include <list>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include "cases/program/case_file.h"
#include "cases/program/output_file.h"
#include "cases/program/process_group.h"
#include "cases/program/text.h"
#include "cases/program/units.h"
#include "mesh/cells/gmsh_file.h"
#include "reduce/exports.h"
#include "reduce/linear_results.h"
#include "reduce/matrices/matrix_sector.h"
#include "reduce/model/nodal_diameter.h"
#include "reduce/model/reduced_model_file.h"
#include "reduce/reduction.h"
#include "reduce/sector/cubic_bricks.h"
#include "reduce/sector/refinement.h"
#include "reduce/sector/sector_reader.h"

namespace tiprub::reduce {

namespace {

constexpr const char* program = "tiprub-reduce";
constexpr double bytes_per_gib = 1024.0 * 1024 * 1024;

struct Inputs {
  ReductionParameters parameters;
  SectorMesh mesh;
  std::string provenance;
  std::string differences;  ///< for people: keys of [mesh] that the mesh was made with other values of
};

void tell(const StageArguments& arguments, const std::string& line) {
  say(arguments, std::string(program) + ": " + line);
}

/// A mesh in millimetres is recognised by the speed of its tip. No material bears the speeds that are refused here
/// (the best flywheels reach a third of them), and a wheel that is a thousand times too large always exceeds them.
void require_metres(const SectorMesh& mesh, const ReductionParameters& parameters) {
  constexpr double least = 1, most = 5000;  // [m/s]
  const double radius = mesh.nodes.topRows<2>().colwise().norm().maxCoeff();
  const double tip_speed = radius * parameters.speed_max;
  if (parameters.unusual || (tip_speed >= least && tip_speed <= most)) return;
  throw InputError(text_of(mesh.file, ": a wheel of radius ", radius, " m has a tip speed of ", tip_speed,
                           " m/s at [reduce] speed_max_rpm; expected are ", least, " to ", most,
                           (tip_speed > most ? ": is the mesh in millimetres? It must be in metres"
                                             : ": is the speed in rpm, and the mesh in metres?"),
                           "; if it is meant, add unusual = true to [reduce]"));
}

MatrixFiles matrix_files(const ReduceOptions& options) {
  constexpr std::size_t most_speeds = 2;  // besides rest: eq. 7 has three terms
  MatrixFiles files{options.matrices[0], options.matrices[1], options.matrices[2], options.matrix_dofs, {}};
  for (std::size_t k = 0; k < options.matrices_at.size(); k += 2) {
    const std::string& word = options.matrices_at[k];
    const double rpm = number_of<double>(word).value_or(0);
    if (!(rpm > 0 && rpm < 1e8))
      throw InputError("--matrix-at " + word + ": must be a speed in rpm, more than 0, and a file");
    if (k + 1 == options.matrices_at.size())
      throw InputError("--matrix-at " + word + ": must be followed by the file of K at this speed");
    const double speed = rpm / rpm_per_rad_s;
    for (const auto& [other, file] : files.stiffness_at)
      if (other == speed) throw InputError("--matrix-at " + word + ": is given twice");
    files.stiffness_at.emplace_back(speed, options.matrices_at[k + 1]);
  }
  if (files.stiffness_at.size() > most_speeds)
    throw InputError("--matrix-at: K may be given at two speeds besides rest: K0 + Omega^2 K1 + Omega^4 K2");
  return files;
}

/// The sector, as a mesh or by its matrices.
SectorMesh read_sector(const StageArguments& arguments, const ReduceOptions& options,
                       const ReductionParameters& parameters) {
  const std::filesystem::path& mesh = arguments.inputs[1];
  if (options.matrices.empty()) {
    if (mesh.empty()) throw InputError("sector.msh is required; see tiprub-reduce --help");
    if (!options.matrix_dofs.empty() || !options.matrices_at.empty())
      throw InputError("--matrix-dofs and --matrix-at go with --matrices");
    SectorMesh sector = read_sector_mesh(mesh, parameters.cyclic_tolerance);
    for (int k = 0; k < parameters.refine; ++k) sector = refined(sector);
    return parameters.degree == Degree::cubic ? with_cubic_bricks(sector) : sector;
  }
  if (!mesh.empty())
    throw InputError(mesh.string() + ": a sector is given by its mesh or by --matrices, not by both");
  if (!options.calculix_folder.empty() || !options.modes_file.empty() || !options.fields_file.empty())
    throw InputError("--export-ccx, --modes and --fields need the sector's cells, which --matrices doesn't give");
  return read_matrix_sector(matrix_files(options), parameters.cyclic_tolerance);
}

Inputs read(const StageArguments& arguments, const ReduceOptions& options) {
  const CaseFile case_file(arguments.inputs[0], arguments.settings);
  CaseTable table = case_file.table("reduce");
  ReductionParameters parameters = read_reduction_parameters(table, options.input());
  if (options.threads > 0) parameters.threads = options.threads;
  parameters.scratch_folder = arguments.output.parent_path();
  if (arguments.verbosity == Verbosity::verbose) say(arguments, "[reduce]\n" + table.resolved());
  say_blas(arguments);
  SectorMesh mesh = read_sector(arguments, options, parameters);
  require_metres(mesh, parameters);
  const std::filesystem::path file = arguments.inputs.size() > 1 ? arguments.inputs[1] : "";
  const MadeOtherwise of_mesh = made_otherwise(file.filename().string(), appended_comments(file), case_file.source(),
                                               {"mesh."}, "the model is that of the mesh");
  std::string provenance = case_file.source();
  for (const auto& [key, value] : of_mesh.keys) provenance += "\n# --set " + key + " = " + value;
  return {std::move(parameters), std::move(mesh), std::move(provenance), of_mesh.lines};
}

/// The files that this run may write. They are tried before the work and locked until its end.
class Outputs {
 public:
  Outputs(const StageArguments& arguments, const ReduceOptions& options) {
    const bool reduces = options.calculix_folder.empty() && options.modes_file.empty();
    if (!options.calculix_folder.empty()) make_folder(options.calculix_folder);
    if (reduces && !options.matrix_market_folder.empty()) make_folder(options.matrix_market_folder);
    std::vector<std::filesystem::path> files;
    if (reduces) files = {arguments.output, options.fields_file};
    if (!reduces && options.calculix_folder.empty()) files = {options.modes_file};
    std::vector<std::filesystem::path> inputs = arguments.inputs;
    inputs.insert(inputs.end(), options.matrices.begin(), options.matrices.end());
    inputs.push_back(options.matrix_dofs);
    for (std::size_t k = 1; k < options.matrices_at.size(); k += 2) inputs.push_back(options.matrices_at[k]);
    refuse_overwriting(files, inputs);
    for (const std::filesystem::path& file : files)
      if (!file.empty()) locks_.emplace_back(file);
  }

 private:
  static void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error && access(folder.c_str(), W_OK | X_OK) != 0) error = {errno, std::generic_category()};
    if (error) throw RunError(folder.string() + ": can't be made a folder to write in: " + error.message());
  }

  std::list<OutputLock> locks_;
};

std::string to_digits(double value) {
  constexpr int digits = 4;
  return text_of(std::setprecision(digits), value);
}

std::string sectors_in_words(int count) {
  return count == 1 ? "one body without cuts" : std::to_string(count) + " sectors";
}

void check(const StageArguments& arguments, const Inputs& inputs) {
  const SectorMesh& mesh = inputs.mesh;
  const CheckedSector checked = check_sector(mesh, inputs.parameters);
  tell(arguments, "the case and the sector are sound: " + sectors_in_words(mesh.sector_count) + ", " +
                      std::to_string(mesh.file_node_count()) + " nodes, " + mesh.kinds_in_words() + ", " +
                      std::to_string(checked.dofs) + " dofs, " + to_digits(checked.mass) + " kg" +
                      inputs.differences);
}

void export_decks(const StageArguments& arguments, const Inputs& inputs, const std::string& folder) {
  write_calculix_decks(inputs.mesh, inputs.parameters, folder);
  tell(arguments,
       folder + ": CalculiX decks for " + std::to_string(inputs.parameters.verification_speeds.size()) + " speeds");
}

void find_modes(const StageArguments& arguments, const Inputs& inputs, const std::string& file) {
  OutputFile output(file);
  const LinearResults results = linear_results(inputs.mesh, inputs.parameters);
  write_linear_results(results, output.scratch(), program_version(program), inputs.provenance);
  output.commit();
  print(std::cout, results);
  if (!std::cout.flush()) throw RunError("stdout: can't be written to its end; is the disk full?");
  tell(arguments, file + ": " + results.doubts + std::to_string(inputs.parameters.verification_modes) + " modes of " +
                      std::to_string(results.nodal_diameters.size()) + " nodal diameters at " +
                      std::to_string(results.speed_count()) + " speeds, of " + std::to_string(results.sector_dofs) +
                      " dofs" + inputs.differences);
}

/// Reduces, and writes the full fields beside it if a file is wanted for them.
ReducedModel reduce_with_fields(const StageArguments& arguments, const Inputs& inputs,
                                const std::optional<OutputFile>& fields_file, ReductionReport& report,
                                ProcessGroup& group) {
  const auto shown =
      arguments.verbosity == Verbosity::quiet ? Progress::Shown::never : Progress::Shown::on_a_terminal;
  if (!fields_file) return reduce(inputs.mesh, inputs.parameters, shown, report, nullptr, group);
  FieldsWriter fields(fields_file->scratch(), program_version(program));
  ReducedModel model = reduce(inputs.mesh, inputs.parameters, shown, report, &fields, group);
  fields.close(digest(model));
  return model;
}

ReducedModel run(const StageArguments& arguments, const Inputs& inputs, const ReduceOptions& options,
                 ReductionReport& report, ProcessGroup& group) {
  OutputFile output(arguments.output);  // refuses before the work, not after it
  std::optional<OutputFile> fields;
  if (!options.fields_file.empty()) fields.emplace(options.fields_file);
  ReducedModel model = reduce_with_fields(arguments, inputs, fields, report, group);
  model.provenance = inputs.provenance;
  model.mesh_digest = digest(inputs.mesh);
  write_model(model, output.scratch(), program_version(program));
  if (!options.matrix_market_folder.empty()) write_matrix_market(model, options.matrix_market_folder);
  if (fields) fields->commit();  // all are whole: model and fields change together
  output.commit();
  return model;
}

/// The lowest frequency of the unreduced sector and its mass, in which a user recognises a wrong unit.
std::string units_in_words(const ReducedModel& model, const ReductionReport& report) {
  const std::vector<Eigen::MatrixXd>& frequencies = model.verification.unreduced;
  const auto lowest = std::ranges::min_element(frequencies, {}, [](const auto& table) { return table(0, 0); });
  const double speed = model.verification.speeds[0];
  return "; the lowest frequency is " + to_digits((*lowest)(0, 0)) + " Hz " +
         (speed > 0 ? "at " + to_digits(speed * rpm_per_rad_s) + " rpm" : "at rest") + " (nodal diameter " +
         std::to_string(lowest - frequencies.begin()) + "), and the mass of the sector is " +
         to_digits(report.sector_mass) + " kg";
}

std::string summary(const ReducedModel& model, const ReductionReport& report) {
  const int contact = model.contact_dofs();
  int dofs = 0, dofs_at_speed = 0;
  for (std::size_t n = 0; n < model.nodal_diameters.size(); ++n) {
    const int waves = wave_count(static_cast<int>(n), model.sector_count);
    const int generalized = static_cast<int>(model.nodal_diameters[n].M.rows()) - contact;
    dofs += waves * (contact + generalized);
    dofs_at_speed +=
        waves * (contact + (model.modes_at_speed > 0 ? std::min(model.modes_at_speed, generalized) : generalized));
  }
  const ModelError verified = model_error(model);
  std::ostringstream line;
  line << sectors_in_words(model.sector_count) << " of " << report.sector_dofs << " dofs -> " << dofs << " dofs, "
       << dofs_at_speed << " at any one speed (" << model.sector_count * contact << " of contact, "
       << (model.contact.kind == ContactKind::points ? "at points" : "by segments") << "); first "
       << verified.frequencies << " frequencies within " << 100 * verified.error << " % at "
       << model.verification.speeds.size() << " speeds";
  if (model.verification.shape_balance)
    line << ", eq. 7 of " << 2 * report.shape_terms + 1 << " terms alone within "
         << 100 * model.verification.polynomial_misfit.maxCoeff() << " %; shapes under spin in "
         << report.newton_steps << " Newton steps to " << report.newton_residual << ", between the "
         << report.shape_terms << " of eq. 7 within " << 100 * model.verification.shape_balance->imbalance
         << " % of the load";
  return line.str();
}

/// "1.2 %", of a share.
std::string percent(double share) {
  return text_of(std::setprecision(share < 0.1 ? 2 : 3), 100 * share, " %");
}

std::string mesh_error_in_words(const ReducedModel& model, const ReductionParameters& parameters,
                                const ReductionReport& report) {
  if (!parameters.mesh_error || model.prestress == Prestress::given) return "";  // matrices have no mesh
  if (report.mesh_error_unknown)
    return "; the error of the mesh is not estimated, because the mesh is too coarse: the integration of its cells "
           "makes it softer than cubic cells would be";
  if (!model.mesh_error) return "; the error of the mesh is not estimated for these cells";
  const Eigen::MatrixXd& frequency = model.mesh_error->frequency;
  return "; the mesh makes the first frequency of each nodal diameter up to " + percent(frequency.col(0).maxCoeff()) +
         ", the first " + std::to_string(frequency.cols()) + " up to " + percent(frequency.maxCoeff()) +
         " too high, and the compliance of the tip up to " + percent(model.mesh_error->compliance.maxCoeff()) +
         " too small (estimated, at rest)";
}

/// "; factors by MUMPS on disk, because ...", unless they are CHOLMOD's.
std::string factors_in_words(const ReductionParameters& parameters, const ReductionReport& report) {
  if (report.factor_method == FactorMethod::cholmod) return "";
  const bool on_disk = report.factor_method == FactorMethod::mumps_on_disk;
  std::ostringstream text;
  text << std::setprecision(3) << "; factors by MUMPS" << (on_disk ? " on disk" : "");
  if (parameters.factorization == Factorization::automatic)
    text << ", because CHOLMOD would need about " << report.memory_by_cholmod / bytes_per_gib << " GiB and "
         << report.memory_available / bytes_per_gib << " GiB are available";
  return text.str();
}

/// Tells what the reduction took: memory, times, and the shapes of each nodal diameter.
void tell_details(const StageArguments& arguments, const ReductionReport& report) {
  constexpr std::array names = {"CHOLMOD", "MUMPS", "MUMPS on disk"};
  say(arguments, "memory: " + std::to_string(report.memory_needed / bytes_per_gib) + " GiB expected, " +
                     std::to_string(report.memory_available / bytes_per_gib) + " GiB available: factors by " +
                     names.at(static_cast<std::size_t>(report.factor_method)));
  for (const PartOfWork& part : report.parts)
    say(arguments, part.what + ": " + std::to_string(part.wall) + " s, " + std::to_string(part.processor) +
                       " s of processor time");
  for (std::size_t n = 0; n < report.corrections.size(); ++n)
    say(arguments, "nodal diameter " + std::to_string(n) + ": " + std::to_string(report.generalized_dofs[n]) +
                       " generalized dofs, " + std::to_string(report.corrections[n]) +
                       " of them from modes between the speeds; " + std::to_string(report.dropped[n]) +
                       " shapes dropped");
}

void report(const StageArguments& arguments, const Inputs& inputs, const ReducedModel& model,
            const ReductionReport& report, const std::string& matrix_market_folder) {
  if (arguments.verbosity == Verbosity::verbose) tell_details(arguments, report);
  tell(arguments, arguments.output.string() + ": " + doubts(model) + summary(model, report) +
                      units_in_words(model, report) + mesh_error_in_words(model, inputs.parameters, report) +
                      factors_in_words(inputs.parameters, report) + inputs.differences);
  if (!matrix_market_folder.empty())
    tell(arguments, matrix_market_folder + ": K0 to K" + std::to_string(model.nodal_diameters.front().K.highest()) +
                        " and M of " + std::to_string(model.nodal_diameters.size()) +
                        " nodal diameters in Matrix Market");
}

/// Refuses outputs that the run would not write.
void require_one_purpose(const ReduceOptions& options) {
  if (options.calculix_folder.empty() && options.modes_file.empty()) return;
  if (!options.calculix_folder.empty() && !options.modes_file.empty())
    throw InputError("--export-ccx and --modes exclude each other; run tiprub-reduce once for each");
  if (!options.fields_file.empty() || !options.matrix_market_folder.empty())
    throw InputError(
        "--fields and --export-matrix-market belong to a reduction, which --export-ccx and --modes leave out; run "
        "tiprub-reduce once more for them");
}

/// What the leader of the processes does, or the only one.
void lead(const StageArguments& arguments, const ReduceOptions& options, ProcessGroup& group) {
  require_one_purpose(options);
  const Inputs inputs = read(arguments, options);
  if (arguments.action == Action::check) return check(arguments, inputs);
  const Outputs outputs(arguments, options);
  if (!options.calculix_folder.empty()) return export_decks(arguments, inputs, options.calculix_folder);
  if (!options.modes_file.empty()) return find_modes(arguments, inputs, options.modes_file);
  ReductionReport made;
  const ReducedModel model = run(arguments, inputs, options, made, group);
  report(arguments, inputs, model, made, options.matrix_market_folder);
}

/// What the others do: nothing but their part of a reduction.
void follow(StageArguments arguments, const ReduceOptions& options, ProcessGroup& group) {
  if (arguments.action == Action::check || !options.calculix_folder.empty() || !options.modes_file.empty()) return;
  arguments.verbosity = Verbosity::quiet;
  const Inputs inputs = read(arguments, options);
  ReductionReport made;
  reduce(inputs.mesh, inputs.parameters, Progress::Shown::never, made, nullptr, group);
}

}  // namespace

std::string reduce_tables(const CaseFile& file, SectorInput input) {
  return file.resolved("reduce", [&](CaseTable& table) { read_reduction_parameters(table, input); });
}

void run_reduce(const StageArguments& arguments, const ReduceOptions& options) {
  ProcessGroup group;
  group.together([&] { group.leads() ? lead(arguments, options, group) : follow(arguments, options, group); });
}

}  // namespace tiprub::reduce
