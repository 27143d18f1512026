// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/response_file.h"

#include <charconv>
#include <cmath>
#include <utility>

#include "reduce/model/hdf5_file.h"
#include "simulate/response/sealed_file.h"
#include "simulate/response/speed_group.h"

namespace tiprub {

namespace {

constexpr const char* schema = "tiprub-response";
constexpr int schema_version = 4;
const std::string frequency_group = "/frequencies";
const std::string end_group = "/end";
constexpr std::size_t nodal_diameter_max = 10000;  // of any wheel

std::string group_of(std::size_t index) {
  const std::string digits = std::to_string(index);
  return "/speed/" + std::string(digits.size() < 5 ? 5 - digits.size() : 0, '0') + digits;
}

void write_scene(Hdf5File& file, const SimulatedScene& scene) {
  file.set_attribute("/", "sector_count", scene.sector_count);
  file.set_attribute("/", "independent_sectors", scene.independent_sectors);
  file.set_attribute("/", "model_digest", scene.model_digest);
  file.write_text("/provenance", scene.provenance);
  file.set_attribute("/", "scope", scene.scope);
  file.write("/nodal_diameters",
             Array<std::int32_t>{{scene.nodal_diameters.size()},
                                 {scene.nodal_diameters.begin(), scene.nodal_diameters.end()}},
             "1");
  file.write("/casing/angle", scene.casing_angle, "rad");
  file.write("/casing/distortion", scene.casing_distortion, "m");
  file.write("/casing/clearance", scene.clearance, "m");
  file.set_attribute("/casing", "lobes", scene.lobes);
  if (std::isfinite(scene.resolved_frequency))
    file.set_attribute("/", "resolved_frequency", scene.resolved_frequency);
  file.set_attribute("/casing", "clearance_state", scene.clearance_state);
}

SimulatedScene read_scene(const Hdf5File& file) {
  SimulatedScene scene;
  scene.sector_count = file.integer_attribute("/", "sector_count");
  scene.independent_sectors = file.integer_attribute("/", "independent_sectors");
  scene.model_digest = file.text_attribute("/", "model_digest");
  scene.provenance = file.read_text("/provenance");
  scene.scope = file.text_attribute("/", "scope");
  const Array<std::int32_t> moving = file.read_integers("/nodal_diameters");
  scene.nodal_diameters.assign(moving.values.begin(), moving.values.end());
  scene.casing_angle = file.read_vector("/casing/angle");
  scene.casing_distortion = file.read_vector("/casing/distortion");
  scene.clearance = file.read_vector("/casing/clearance");
  scene.lobes = file.integer_attribute("/casing", "lobes");
  if (file.has_attribute("/", "resolved_frequency"))
    scene.resolved_frequency = file.number_attribute("/", "resolved_frequency");
  scene.clearance_state = file.text_attribute("/casing", "clearance_state");
  if (scene.independent_sectors < 1 || scene.sector_count % scene.independent_sectors != 0)
    throw RunError(file.path() + ": independent_sectors must divide sector_count");
  return scene;
}

std::string frequencies_at(std::size_t nodal_diameter) {
  return frequency_group + "/nodal_diameter/" + std::to_string(nodal_diameter);
}

FrequencyTable read_frequencies(const Hdf5File& file) {
  FrequencyTable table;
  if (!file.exists(frequency_group)) return table;
  table.speed = file.read_vector(frequency_group + "/speed");
  for (std::size_t n = 0; file.exists(frequencies_at(n)); ++n) {
    table.by_nodal_diameter.push_back(file.read_matrix(frequencies_at(n)));
    if (table.by_nodal_diameter.back().rows() != table.speed.size())
      throw RunError(file.path() + ": " + frequencies_at(n) + " must have a row for each of the " +
                     std::to_string(table.speed.size()) + " speeds");
  }
  return table;
}

Hdf5File open_response(const std::filesystem::path& path) {
  Hdf5File file = Hdf5File::open(path);
  if (file.has_attribute("/", "schema") && file.text_attribute("/", "schema") == schema &&
      file.has_attribute("/", "schema_version") && file.integer_attribute("/", "schema_version") < schema_version)
    throw RunError(file.path() + ": is " + schema + " version " +
                   std::to_string(file.integer_attribute("/", "schema_version")) +
                   ", made by an older tiprub-simulate; run it again");
  file.require_schema(schema, schema_version);
  return file;
}

}  // namespace

struct ResponseWriter::State {
  Hdf5File file;
  SimulatedScene scene;
  std::size_t count = 0;
};

ResponseWriter::ResponseWriter(const std::filesystem::path& path, const SimulatedScene& scene, const std::string& key,
                               const std::string& generator)
    : state_(std::make_unique<State>(State{Hdf5File::create(path), scene})) {
  state_->file.set_schema(schema, schema_version, generator);
  state_->file.set_attribute("/", "key", key);
  write_scene(state_->file, scene);
}

ResponseWriter::~ResponseWriter() = default;

void ResponseWriter::add(const SpeedResponse& speed) {
  write_speed_group(state_->file, group_of(state_->count++), speed, state_->scene);
}

void ResponseWriter::add(const FrequencyTable& frequencies) {
  state_->file.write(frequency_group + "/speed", frequencies.speed, "rad/s");
  for (std::size_t n = 0; n < frequencies.by_nodal_diameter.size(); ++n)
    state_->file.write(frequencies_at(n), frequencies.by_nodal_diameter[n], "Hz");
}

void ResponseWriter::add_end(const RotorState& state) {
  for (std::size_t n = 0; n < state.displacement.size(); ++n) {
    if (state.displacement[n].size() == 0) continue;
    const std::string group = end_group + "/" + std::to_string(n);
    state_->file.write(group + "/displacement", Eigen::MatrixXcd(state.displacement[n]), "m");
    state_->file.write(group + "/velocity", Eigen::MatrixXcd(state.velocity[n]), "m/rad");
  }
}

void ResponseWriter::close() {
  state_->file.close();
  seal(state_->file.path());
}

RotorState read_end_state(const std::filesystem::path& path) {
  const Hdf5File file = Hdf5File::open(path);
  RotorState state;
  if (!file.exists(end_group)) return state;
  for (const std::string& name : file.members(end_group)) {
    std::size_t n = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), n);
    if (error != std::errc() || end != name.data() + name.size() || n > nodal_diameter_max)
      throw RunError(file.path() + ": " + end_group + "/" + name + " is no nodal diameter");
    if (state.displacement.size() <= n) {
      state.displacement.resize(n + 1);
      state.velocity.resize(n + 1);
    }
    state.displacement[n] = file.read_complex_matrix(end_group + "/" + name + "/displacement");
    state.velocity[n] = file.read_complex_matrix(end_group + "/" + name + "/velocity");
  }
  return state;
}

void write_response(const Response& response, const std::filesystem::path& path, const std::string& generator) {
  ResponseWriter writer(path, response.scene, response.key, generator);
  if (response.frequencies.speed.size() > 0) writer.add(response.frequencies);
  for (const SpeedResponse& speed : response.speeds) writer.add(speed);
  writer.close();
}

std::string read_response_key(const std::filesystem::path& path) {
  const Hdf5File file = open_response(path);
  return file.text_attribute("/", "key");
}

Response read_response(const std::filesystem::path& path) {
  if (seal_of(path) == Seal::broken)
    throw RunError(path.string() +
                   ": was damaged after it was written (its seal is broken); run tiprub-simulate again");
  const Hdf5File file = open_response(path);
  Response response;
  response.key = file.text_attribute("/", "key");
  response.scene = read_scene(file);
  response.frequencies = read_frequencies(file);
  if (!file.exists("/speed")) return response;
  for (const std::string& name : file.members("/speed"))
    response.speeds.push_back(read_speed_group(file, "/speed/" + name, response.scene));
  return response;
}

}  // namespace tiprub
