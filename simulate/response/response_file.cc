// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/response_file.h"

#include <charconv>
#include <complex>
#include <iomanip>
#include <sstream>
#include <utility>

#include "cases/program/machine.h"
#include "reduce/model/hdf5_file.h"
#include "simulate/response/branch_group.h"
#include "simulate/response/named_axes.h"
#include "simulate/response/scene_group.h"
#include "simulate/response/sealed_file.h"
#include "simulate/response/speed_axis.h"
#include "simulate/response/speed_group.h"

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
    throw FileError(file.path() + ": is " + schema + " version " +
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
  write_frequencies(state_->file, frequencies);
}

void ResponseWriter::add(const OrbitBranch& branch) {
  write_branch(state_->file, state_->branches++, branch);
}

void ResponseWriter::add_scanned(const Eigen::VectorXd& speeds) {
  write_scanned_speeds(state_->file, speeds);
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

void write_response(const Response& response, const std::filesystem::path& path, const std::string& generator) {
  ResponseWriter writer(path, response.scene, response.key, generator);
  if (response.frequencies.speed.size() > 0) writer.add(response.frequencies);
  for (const SpeedResponse& speed : response.speeds) writer.add(speed);
  for (const OrbitBranch& branch : response.branches) writer.add(branch);
  writer.add_scanned(response.scanned_speeds);
  writer.close();
}

std::string read_response_key(const std::filesystem::path& path) {
  const Hdf5File file = open_response(path);
  return file.text_attribute("/", "key");
}

Response read_response(const std::filesystem::path& path) {
  if (seal_of(path) == Seal::broken)
    throw FileError(path.string() +
                    ": was damaged after it was written (its seal is broken); run tiprub-simulate again");
  const Hdf5File file = open_response(path);
  NamedAxes axes(file);
  Response response;
  response.key = file.text_attribute("/", "key");
  response.scene = read_scene(file, axes);
  response.frequencies = read_frequencies(file, response.scene.sector_count, axes);
  response.branches = read_branches(file, axes);
  response.scanned_speeds = read_scanned_speeds(file, axes);
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
