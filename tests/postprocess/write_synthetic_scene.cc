// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the made scene into a folder: input to try the program on by hand. Beside it, files with one thing wrong.
#include <cmath>

#include "reduce/model/fields_file.h"
#include "reduce/model/reduced_model_file.h"
#include "simulate/response/response_file.h"
#include "synthetic_fields.h"
#include "synthetic_scene.h"
#include "tests/simulate/written_response.h"

namespace tiprub::postprocess::synthetic {
namespace {

void write_fields_of_one_sector(const std::filesystem::path& path) {
  SectorFields sector;
  sector.sector_count = 1;
  sector.young = sector.density = 1;
  sector.nodes = Eigen::Matrix3Xd::Random(3, 20);
  sector.cells = Eigen::VectorXi::LinSpaced(20, 0, 19);
  sector.node_sets = {{"clamped", {}}, {"contact", {0}}, {"cyclic_low", {}}, {"cyclic_high", {}}};
  sector.static_displacement.terms = {Eigen::Matrix3Xd::Zero(3, 20)};
  FieldsWriter writer(path, "test");
  writer.write_sector(sector);
  writer.write_basis(0, 1, true, [](Eigen::Index) { return Eigen::VectorXcd(Eigen::VectorXcd::Ones(60)); });
  writer.close("of no model");
}

void write_response_with_a_nan(const std::filesystem::path& path) {
  Response response{two_lobes(), "made", {}};
  response.speeds.push_back(speed(response.scene, model().contact, 1500, {}, 1));
  response.speeds[0].displacement(3, 2) = std::nan("");
  write_response(response, path, "test");
}

void write_response_of_failures(const std::filesystem::path& path) {
  Response response{two_lobes(), "made", {}};
  response.speeds.resize(1);
  response.speeds[0].speed = 1500;
  response.speeds[0].failure = "it blew up";
  write_response(response, path, "test");
}

void write_response_without_frequencies(const std::filesystem::path& path) {
  Response response{two_lobes(), "made", {}};
  response.speeds.push_back(speed(response.scene, model().contact, 1500, {}, 1));
  write_response(response, path, "test");
}

/// Fields that no stress can be told from.
void write_fields_without_stress(const std::filesystem::path& folder) {
  const ReducedModel rotor = model();
  const SectorFields sound = sector_fields(rotor);
  SectorFields sector = sound;
  sector.poisson = 0.5;
  write_fields(rotor, sector, folder / "incompressible_fields.h5");
  sector = sound;
  sector.cells.col(1).setConstant(sector.cells(0, 1));
  write_fields(rotor, sector, folder / "flat_fields.h5");
  sector = sound;
  sector.static_displacement[1] *= 1e250;
  write_fields(rotor, sector, folder / "huge_fields.h5");
}

/// Responses that are sound as files, and not to be worked with.
void write_odd_responses(const std::filesystem::path& folder) {
  const ReducedModel rotor = model();
  Response sound{two_lobes(), "made", {}, frequencies(rotor)};
  sound.speeds.push_back(speed(sound.scene, rotor.contact, 1500, {}, 1));
  add_snapshots(rotor, sound);
  Response response = sound;
  response.speeds[0].displacement(3, 2) = 1e300;
  write_response(response, folder / "huge_response.h5", "test");
  response = sound;
  response.speeds[0].snapshot->displacement[1].conservativeResize(5);
  write_response(response, folder / "other_dofs_response.h5", "test");
}

void write_wrong_files(const std::filesystem::path& folder) {
  write_model(model(9), folder / "nine_sectors_model.h5", "test");
  write_fields_of_one_sector(folder / "one_sector_fields.h5");
  write_response_with_a_nan(folder / "nan_response.h5");
  write_response_without_frequencies(folder / "bare_response.h5");
  write_response_of_failures(folder / "failed_response.h5");
  write_fields_without_stress(folder);
  write_odd_responses(folder);
}

/// The scene's response with the rotor's state over a cycle at every speed.
void write_response_with_cycles(const std::filesystem::path& path) {
  const ReducedModel rotor = model();
  Response response = resonant_sweep(rotor);
  add_snapshots(rotor, response);
  add_cycles(rotor, response);
  write_response(response, path, "test");
}

}  // namespace
}  // namespace tiprub::postprocess::synthetic

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : "synthetic";
  tiprub::postprocess::synthetic::write_scene(folder);
  tiprub::postprocess::synthetic::write_response_with_cycles(folder / "cycles_response.h5");
  tiprub::postprocess::synthetic::write_wrong_files(folder);
}
