// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/response_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <complex>
#include <functional>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <utility>

#include "cases/program/machine.h"
#include "reduce/model/hdf5_file.h"
#include "simulate/response/branch_group.h"
#include "simulate/response/named_axes.h"
#include "simulate/response/sealed_file.h"
#include "simulate/response/speed_axis.h"
#include "simulate/response/speed_group.h"
#include "simulate/response/written_axes.h"

namespace tiprub {

namespace {

constexpr const char* schema = "tiprub-response";
constexpr int schema_version = 5;
constexpr int oldest_version = 4;  // that is read: without axes and what is along that of speed
const std::string frequency_group = "/frequencies";
const std::string end_group = "/end";
constexpr double bytes_per_gib = 1024.0 * 1024 * 1024;
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
  file.write_text("/casing/table", scene.casing);
  file.set_attribute("/", "scope", scene.scope);
  file.set_attribute("/", "scheme", std::string(name_in(scheme_names, scene.scheme)));
  file.set_attribute("/", "contact", std::string(name_in(contact_rule_names, scene.contact)));
  file.set_attribute("/", "accuracy", scene.asked.critical_speeds);
  file.set_attribute("/", "step_tolerance", scene.asked.step);
  file.set_attribute("/", "settle_tolerance", scene.asked.settling);
  const std::string moving = "/nodal_diameters", clearance = "/casing/clearance", distortion = "/casing/distortion";
  file.write(moving,
             Array<std::int32_t>{{scene.nodal_diameters.size()},
                                 {scene.nodal_diameters.begin(), scene.nodal_diameters.end()}},
             "1");
  file.make_axis(moving);
  file.describe(moving, "nodal diameters that move");
  write_axis(file, "/casing/angle", scene.casing_angle, "rad", "absolute angle");
  file.write(distortion, scene.casing_distortion, "m");
  file.describe(distortion, "how far the casing stands inward", {"/casing/angle"});
  write_counting_axis(file, "/casing/contact_node", scene.clearance.size(), "contact node, from 0");
  file.write(clearance, scene.clearance, "m");
  file.describe(clearance, "clearance as the case gives it, of the tightest blade", {"/casing/contact_node"});
  file.set_attribute("/casing", "lobes", scene.lobes);
  if (std::isfinite(scene.resolved_frequency))
    file.set_attribute("/", "resolved_frequency", scene.resolved_frequency);
  file.set_attribute("/casing", "clearance_state",
                     std::string(name_in(clearance_state_names, scene.clearance_state)));
}

/// Raises RunError with what the file must hold, unless it does.
void require(bool holds, const Hdf5File& file, const std::string& must) {
  if (!holds) throw RunError(file.path() + ": " + must);
}

template <class Values>
bool increases(const Values& values) {
  return std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end();
}

/// An attribute of the file, if it is there.
void read_positive(const Hdf5File& file, const std::string& name, double& value) {
  if (file.has_attribute("/", name)) value = file.number_attribute("/", name);
  require(value > 0, file, "attribute " + name + " must be above 0");
}

/// The value that an attribute names.
template <class Value, std::size_t count>
Value named(const NamedValues<Value, count>& names, const Hdf5File& file, const std::string& object,
            const std::string& attribute) {
  return value_named(names, file.text_attribute(object, attribute),
                     file.path() + ": " + object + ": attribute " + attribute);
}

void read_casing(const Hdf5File& file, NamedAxes& axes, SimulatedScene& scene) {
  axes.require("/casing/angle", {"angles"});
  axes.require("/casing/distortion", {"angles"});
  axes.require("/casing/clearance", {nodes_axis});
  scene.casing_angle = file.read_vector("/casing/angle");
  scene.casing_distortion = file.read_vector("/casing/distortion");
  scene.clearance = file.read_vector("/casing/clearance");
  scene.lobes = file.integer_attribute("/casing", "lobes");
  scene.clearance_state = named(clearance_state_names, file, "/casing", "clearance_state");
  constexpr double turn = 2 * std::numbers::pi, rounding = 1e-9;
  const Eigen::VectorXd& angle = scene.casing_angle;
  require(angle.size() > 1 && increases(angle) && angle[0] >= -rounding && angle.tail<1>()[0] <= turn + rounding,
          file, "/casing/angle must increase within 0 .. 2 pi, 2 angles at least");
  require(scene.lobes >= 1, file, "/casing: attribute lobes must be at least 1");
}

SimulatedScene read_scene(const Hdf5File& file, NamedAxes& axes) {
  SimulatedScene scene;
  scene.sector_count = file.integer_attribute("/", "sector_count");
  scene.independent_sectors = file.integer_attribute("/", "independent_sectors");
  scene.model_digest = file.text_attribute("/", "model_digest");
  scene.provenance = file.read_text("/provenance");
  scene.casing = file.read_text("/casing/table");
  scene.scope = file.text_attribute("/", "scope");
  require(scene.independent_sectors >= 1 && scene.sector_count >= 1 &&
              scene.sector_count % scene.independent_sectors == 0,
          file, "independent_sectors must divide sector_count, both at least 1");
  axes.set(sectors_axis, static_cast<std::size_t>(scene.independent_sectors), "independent_sectors");
  axes.set(components_axis, 3, "r, theta, z");
  axes.require("/nodal_diameters", {"nodal diameters"});
  const Array<std::int32_t> moving = file.read_integers("/nodal_diameters");
  scene.nodal_diameters.assign(moving.values.begin(), moving.values.end());
  require(increases(scene.nodal_diameters) && scene.nodal_diameters.front() >= 0 &&
              scene.nodal_diameters.back() <= scene.sector_count / 2,
          file, "/nodal_diameters must increase within 0 .. sector_count/2");
  if (file.has_attribute("/", "scheme")) {  // older files don't tell
    scene.scheme = named(scheme_names, file, "/", "scheme");
    scene.contact = named(contact_rule_names, file, "/", "contact");
  }
  read_positive(file, "accuracy", scene.asked.critical_speeds);
  read_positive(file, "step_tolerance", scene.asked.step);
  read_positive(file, "settle_tolerance", scene.asked.settling);
  read_positive(file, "resolved_frequency", scene.resolved_frequency);
  read_casing(file, axes, scene);
  return scene;
}

std::string frequencies_at(std::size_t nodal_diameter) {
  return frequency_group + "/nodal_diameter/" + std::to_string(nodal_diameter);
}

FrequencyTable read_frequencies(const Hdf5File& file, int sector_count, NamedAxes& axes) {
  FrequencyTable table;
  if (!file.exists(frequency_group)) return table;
  const std::string speeds = "speeds of the frequencies";
  axes.require(frequency_group + "/speed", {speeds});
  table.speed = file.read_vector(frequency_group + "/speed");
  require(increases(table.speed) && table.speed[0] >= 0, file,
          frequency_group + "/speed must increase from 0 or more");
  for (std::size_t n = 0; n <= static_cast<std::size_t>(sector_count / 2); ++n) {
    axes.require(frequencies_at(n), {speeds, "modes of nodal diameter " + std::to_string(n)});
    table.by_nodal_diameter.push_back(file.read_matrix(frequencies_at(n)));
  }
  return table;
}

/// [bytes] of a group's arrays as they are read; complex states count twice.
double size_of_speed(const Hdf5File& file, const std::string& group) {
  double size = 0;
  const auto add = [&](const std::string& name, double bytes_each) {
    for (const std::size_t extent : file.shape_of(name)) bytes_each *= static_cast<double>(extent);
    size += bytes_each;
  };
  for (const char* name : {"/displacement", "/contact_force", "/contact_count"})
    if (file.exists(group + name)) add(group + name, sizeof(double));
  if (file.exists(group + "/cycle"))
    for (const std::string& n : file.members(group + "/cycle"))
      add(group + "/cycle/" + n, sizeof(std::complex<double>));
  return size;
}

void require_memory(const Hdf5File& file, const std::vector<std::string>& speeds) {
  double needed = 0;
  for (const std::string& name : speeds) needed += size_of_speed(file, "/speed/" + name);
  const double available = available_memory();
  if (needed <= available) return;
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << file.path() << ": its " << speeds.size() << " speeds take "
       << needed / bytes_per_gib << " GiB, " << available / bytes_per_gib
       << " GiB are available; take a larger machine, or simulate fewer speeds, samples or recorded revolutions";
  throw RunError(text.str());
}

Hdf5File open_response(const std::filesystem::path& path) {
  Hdf5File file = Hdf5File::open(path);
  if (file.has_attribute("/", "schema") && file.text_attribute("/", "schema") == schema &&
      file.has_attribute("/", "schema_version") && file.integer_attribute("/", "schema_version") < oldest_version)
    throw RunError(file.path() + ": is " + schema + " version " +
                   std::to_string(file.integer_attribute("/", "schema_version")) +
                   ", made by an older tiprub-simulate; run it again");
  const bool former =
      file.has_attribute("/", "schema_version") && file.integer_attribute("/", "schema_version") == oldest_version;
  file.require_schema(schema, former ? oldest_version : schema_version);
  return file;
}

}  // namespace

struct ResponseWriter::State {
  Hdf5File file;
  SimulatedScene scene;
  ResponseUse use;
  SpeedAxis axis = {};
  std::size_t count = 0, branches = 0;
};

ResponseWriter::ResponseWriter(const std::filesystem::path& path, const SimulatedScene& scene, const std::string& key,
                               const std::string& generator, ResponseUse use)
    : state_(std::make_unique<State>(
          State{Hdf5File::create(
                    path, use == ResponseUse::kept ? Hdf5File::Storage::netcdf : Hdf5File::Storage::netcdf_unpacked),
                scene, use})) {
  state_->file.set_schema(schema, schema_version, generator);
  state_->file.set_attribute("/", "key", key);
  write_scene(state_->file, scene);
}

ResponseWriter::~ResponseWriter() = default;

void ResponseWriter::add(const SpeedResponse& speed) {
  write_speed_group(state_->file, group_of(state_->count++), speed, state_->scene);
  state_->axis.add(speed);
}

void ResponseWriter::add(const FrequencyTable& frequencies) {
  Hdf5File& file = state_->file;
  const std::string speed = frequency_group + "/speed";
  write_axis(file, speed, frequencies.speed, "rad/s", "speed of the rotor");
  for (std::size_t n = 0; n < frequencies.by_nodal_diameter.size(); ++n) {
    const std::string mode = frequency_group + "/mode_" + std::to_string(n);
    write_counting_axis(file, mode, frequencies.by_nodal_diameter[n].cols(), "mode, from 0");
    file.write(frequencies_at(n), frequencies.by_nodal_diameter[n], "Hz");
    file.describe(frequencies_at(n), "natural frequencies; negative: statically unstable", {speed, mode});
  }
}

void ResponseWriter::add(const OrbitBranch& branch) {
  write_branch(state_->file, state_->branches++, branch);
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
  if (state_->use == ResponseUse::kept) state_->axis.write(state_->file);
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
  for (const OrbitBranch& branch : response.branches) writer.add(branch);
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
  NamedAxes axes(file);
  Response response;
  response.key = file.text_attribute("/", "key");
  response.scene = read_scene(file, axes);
  response.frequencies = read_frequencies(file, response.scene.sector_count, axes);
  response.branches = read_branches(file, axes);
  if (!file.exists("/speed")) return response;
  const std::vector<std::string> speeds = file.members("/speed");
  require_memory(file, speeds);
  for (const std::string& name : speeds) {
    const std::string group = "/speed/" + name;
    SpeedResponse speed = read_speed_group(file, group, response.scene, axes);
    require(response.speeds.empty() || speed.speed > response.speeds.back().speed, file,
            group + ": attribute speed must be above that of the group before it");
    response.speeds.push_back(std::move(speed));
  }
  return response;
}

}  // namespace tiprub
