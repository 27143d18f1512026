// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/response_file.h"

#include <charconv>
#include <complex>
#include <iomanip>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cases/program/errors.h"
#include "cases/program/machine.h"
#include "cases/program/text.h"
#include "reduce/model/hdf5_file.h"
#include "simulate/motion/column.h"
#include "simulate/response/named_axes.h"
#include "simulate/response/response_groups.h"
#include "simulate/response/speed_numbers.h"

namespace tiprub {

namespace {

constexpr const char* schema = "tiprub-response";
constexpr int schema_version = 5;
constexpr int oldest_version = 4;  // that can still be read; it has no axes
const std::string end_group = "/end";
constexpr double bytes_per_gib = 1024.0 * 1024 * 1024;
constexpr std::size_t nodal_diameter_max = 10000;  // of any wheel

std::string group_of(std::size_t index) {
  const std::string digits = std::to_string(index);
  return "/speed/" + std::string(digits.size() < 5 ? 5 - digits.size() : 0, '0') + digits;
}

/// [bytes] that the arrays of a group take in memory.
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
  throw RunError(text_of(
      std::fixed, std::setprecision(2), file.path(), ": its ", speeds.size(), " speeds take ", needed / bytes_per_gib,
      " GiB, ", available / bytes_per_gib,
      " GiB are available; take a larger machine, or simulate fewer speeds, samples or recorded revolutions"));
}

Hdf5File open_response(const std::filesystem::path& path) {
  const Seal seal = seal_of(path);
  if (seal == Seal::broken)
    throw FileError(path.string() +
                    ": was damaged after it was written (its seal is broken); run tiprub-simulate again");
  Hdf5File file = Hdf5File::open(path, seal == Seal::whole ? Hdf5File::Bytes::as_written : Hdf5File::Bytes::unknown);
  const int version =
      file.has_attribute("/", "schema_version") ? file.integer_attribute("/", "schema_version") : schema_version;
  if (version < oldest_version && file.has_attribute("/", "schema") && file.text_attribute("/", "schema") == schema)
    throw FileError(file.path() + ": is " + schema + " version " + std::to_string(version) +
                    ", made by an older tiprub-simulate; run it again");
  file.require_schema(schema, version == oldest_version ? oldest_version : schema_version);
  return file;
}

std::string branch_group(std::size_t place) {
  return "/branch/" + std::to_string(place);
}

/// Name, unit, meaning and member of each array over the orbits.
struct BranchArray {
  const char* name;
  const char* unit;
  const char* long_name;
  Eigen::VectorXd OrbitBranch::*values;
};
constexpr BranchArray arrays[] = {
    {"speed", "rad/s", "speed of the rotor", &OrbitBranch::speed},
    {"amplitude", "m", "half of the peak-to-peak normal displacement, the largest", &OrbitBranch::amplitude},
    {"multiplier", "1", "magnitude in a revolution of the largest Floquet multiplier", &OrbitBranch::multiplier},
    {"multiplier_uncertainty", "1", "uncertainty of that magnitude", &OrbitBranch::multiplier_uncertainty},
    {"multiplier_angle", "rad", "angle of that multiplier, a map", &OrbitBranch::multiplier_angle}};

void require_sound(const Hdf5File& file, const std::string& dataset, const Eigen::VectorXd& values) {
  if (values.allFinite() && values.minCoeff() >= 0) return;
  throw FileError(file.path() + ": " + dataset + " must be finite and not below 0");
}

OrbitBranch read_branch(const Hdf5File& file, std::size_t place, NamedAxes& axes) {
  const std::string group = branch_group(place), orbits = "orbits of branch " + std::to_string(place);
  OrbitBranch branch;
  for (const BranchArray& array : arrays) {
    const std::string dataset = group + "/" + array.name;
    branch.*array.values = axes.read_vector(dataset, orbits);
    require_sound(file, dataset, branch.*array.values);
  }
  if (file.exists(group + "/fold")) {
    branch.folds = axes.read_vector(group + "/fold", "folds of branch " + std::to_string(place));
    require_sound(file, group + "/fold", branch.folds);
  }
  if (!(branch.speed.minCoeff() > 0)) throw FileError(file.path() + ": " + group + "/speed must be above 0");
  branch.start = file.number_attribute(group, "start");
  branch.steps_per_revolution = file.integer_attribute(group, "steps_per_revolution");
  branch.ends[0] = file.text_attribute(group, "first_end");
  branch.ends[1] = file.text_attribute(group, "last_end");
  return branch;
}

void write_branch(Hdf5File& file, std::size_t place, const OrbitBranch& branch) {
  const std::string group = branch_group(place);
  write_counting_axis(file, group + "/orbit", branch.speed.size(), "orbit in the order of arc length, from 0");
  for (const BranchArray& array : arrays) {
    write_along(file, {group + "/orbit"}, group + "/" + array.name, branch.*array.values, array.unit,
                array.long_name);
  }
  if (branch.folds.size() > 0) write_axis(file, group + "/fold", branch.folds, "rad/s", "speed of a fold");
  file.set_attribute(group, "start", branch.start);
  file.set_attribute(group, "steps_per_revolution", branch.steps_per_revolution);
  file.set_attribute(group, "first_end", branch.ends[0]);
  file.set_attribute(group, "last_end", branch.ends[1]);
}

std::vector<OrbitBranch> read_branches(const Hdf5File& file, NamedAxes& axes) {
  std::vector<OrbitBranch> branches;
  while (file.exists(branch_group(branches.size()))) branches.push_back(read_branch(file, branches.size(), axes));
  return branches;
}

/// Says beside multipliers what they lack, if anything.
void comment_multipliers(Hdf5File& file, const std::string& group, const SimulatedScene& scene) {
  const ModelledEffect* const impacts = find(scene.effects, Effect::impact_instants);
  if (impacts != nullptr && impacts->treatment == Treatment::simplified)
    file.set_attribute(group + "/multiplier", "comment", impacts->reason);
}

SpeedRow row_of(const SpeedResponse& speed) {
  SpeedRow row{speed.speed, {}, texts_of(speed)};
  const auto note = [&](bool held, const NumberMeaning& meaning, const std::optional<double>& value) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    row.numbers.push_back({meaning, held ? value.value_or(none) : none});
  };
  visit_numbers(
      speed, [&](const NumberMeaning& meaning, const auto& value) { note(speed.failure.empty(), meaning, value); });
  const OrbitReport& orbit = speed.audit.orbit;
  visit_orbit_numbers(orbit, [&](const NumberMeaning& meaning, const auto& value) {
    note(orbit.outcome != OrbitReport::Outcome::none, meaning, value);
  });
  return row;
}

/// Writes the numbers of all speeds once more, along one axis of speed in the root of response.h5, for netCDF tools.
/// Our reader uses the groups of the speeds. Raises RunError.
void write_speed_axis(Hdf5File& file, const std::vector<SpeedRow>& rows) {
  const std::string axis = "/rotor_speed";
  write_axis(file, axis, column(rows, &SpeedRow::speed), "rad/s", "speed of the rotor");
  if (rows.empty()) return;
  for (std::size_t i = 0; i < rows.front().numbers.size(); ++i) {
    const NumberMeaning& meaning = rows.front().numbers[i].meaning;
    write_along(file, {axis}, std::string("/") + meaning.name,
                column(rows, [&](const SpeedRow& row) { return row.numbers[i].value; }), meaning.units,
                meaning.long_name);
  }
  for (std::size_t i = 0; i < rows.front().texts.size(); ++i) {
    const std::string name = std::string("/") + rows.front().texts[i].name;
    std::vector<std::string> texts;
    for (const SpeedRow& row : rows) texts.push_back(row.texts[i].value);
    file.write(name, texts);
    file.describe(name, rows.front().texts[i].long_name, {axis});
  }
}

}  // namespace

struct ResponseWriter::State {
  Hdf5File file;
  SimulatedScene scene;
  ResponseUse use;
  std::vector<SpeedRow> rows = {};
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
  state_->rows.push_back(row_of(speed));
}

void ResponseWriter::add(const FrequencyTable& frequencies) {
  write_frequencies(state_->file, frequencies);
}

void ResponseWriter::add(const OrbitBranch& branch) {
  const std::size_t place = state_->branches++;
  write_branch(state_->file, place, branch);
  comment_multipliers(state_->file, branch_group(place), state_->scene);
}

void ResponseWriter::add_scanned(const Eigen::VectorXd& speeds, const Eigen::VectorXd& amplitudes) {
  write_scan(state_->file, speeds, amplitudes);
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
  if (state_->use == ResponseUse::kept) {
    write_speed_axis(state_->file, state_->rows);
    comment_multipliers(state_->file, "", state_->scene);
  }
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
      throw FileError(file.path() + ": " + end_group + "/" + name + " is no nodal diameter");
    if (state.displacement.size() <= n) {
      state.displacement.resize(n + 1);
      state.velocity.resize(n + 1);
    }
    state.displacement[n] = file.read_complex_matrix(end_group + "/" + name + "/displacement");
    state.velocity[n] = file.read_complex_matrix(end_group + "/" + name + "/velocity");
  }
  return state;
}

std::string read_response_key(const std::filesystem::path& path) {
  const Hdf5File file = open_response(path);
  return file.text_attribute("/", "key");
}

Response read_response(const std::filesystem::path& path) {
  const Hdf5File file = open_response(path);
  NamedAxes axes(file);
  Response response;
  response.key = file.text_attribute("/", "key");
  response.scene = read_scene(file, axes);
  response.frequencies = read_frequencies(file, response.scene.sector_count, axes);
  response.branches = read_branches(file, axes);
  read_scan(file, axes, response.scanned_speeds, response.scanned_amplitudes);
  if (!file.exists("/speed")) return response;
  const std::vector<std::string> speeds = file.members("/speed");
  require_memory(file, speeds);
  for (const std::string& name : speeds) {
    const std::string group = "/speed/" + name;
    SpeedResponse speed = read_speed_group(file, group, response.scene, axes);
    if (!response.speeds.empty() && speed.speed <= response.speeds.back().speed)
      throw FileError(file.path() + ": " + group + ": attribute speed must be above that of the group before it");
    response.speeds.push_back(std::move(speed));
  }
  return response;
}

}  // namespace tiprub
