// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/speed_group.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <type_traits>
#include <utility>

#include "simulate/response/kept_states.h"

namespace tiprub {

namespace {

constexpr std::array<std::pair<MotionClass, const char*>, 5> motion_names = {{
    {MotionClass::periodic, "periodic"},
    {MotionClass::subharmonic, "subharmonic"},
    {MotionClass::modulated, "modulated"},
    {MotionClass::broadband, "broadband"},
    {MotionClass::not_settled, "not settled"},
}};

/// The columns of a matrix seen as further axes of an array; rows first.
Array<double> unfold(const Eigen::MatrixXd& matrix, const std::vector<std::size_t>& column_axes) {
  Array<double> array;
  array.shape = {static_cast<std::size_t>(matrix.rows())};
  array.shape.insert(array.shape.end(), column_axes.begin(), column_axes.end());
  array.values.resize(matrix.size());
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::Map<RowMajor>(array.values.data(), matrix.rows(), matrix.cols()) = matrix;
  return array;
}

Eigen::MatrixXd fold(const Array<double>& array) {
  const Eigen::Index rows = array.shape.empty() ? 0 : static_cast<Eigen::Index>(array.shape.front());
  const Eigen::Index columns = rows == 0 ? 0 : static_cast<Eigen::Index>(array.values.size()) / rows;
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(array.values.data(), rows, columns);
}

constexpr std::array<std::pair<SymmetryVerdict, const char*>, 5> symmetry_names = {{
    {SymmetryVerdict::all_held, "all held"},
    {SymmetryVerdict::unchecked, "unchecked"},
    {SymmetryVerdict::holds, "holds"},
    {SymmetryVerdict::breaking, "breaking"},
    {SymmetryVerdict::undecided, "undecided"},
}};

constexpr std::array<std::pair<OrbitReport::Outcome, const char*>, 3> outcome_names = {{
    {OrbitReport::Outcome::none, "none"},
    {OrbitReport::Outcome::found, "found"},
    {OrbitReport::Outcome::marched, "marched"},
}};

constexpr std::array<std::pair<Depth, const char*>, 3> depth_names = {{
    {Depth::scanned, "scanned"},
    {Depth::full, "full"},
    {Depth::examined, "examined"},
}};

template <class Names, class Value>
const char* name_of(const Names& names, Value value) {
  for (const auto& [known, name] : names)
    if (known == value) return name;
  return "";
}

template <class Names>
auto value_named(const Names& names, const std::string& name, const std::string& where) {
  for (const auto& [value, known] : names)
    if (name == known) return value;
  throw RunError(where + " \"" + name + "\" is not known");
}

/// What a number of a speed that did not fail may be; ends included.
struct Bounds {
  double low, high;
};
constexpr double beyond_counting = 9007199254740992.0;  // 2^53: up to there a double tells whole numbers apart
constexpr Bounds any = {-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
constexpr Bounds not_negative = {0, any.high}, not_positive = {any.low, 0}, share = {0, 1};
constexpr Bounds whole = {0, beyond_counting}, at_least_one = {1, beyond_counting},
                 at_least_two = {2, beyond_counting};

/// Every number of a speed with its name in the file and its bounds: one list for the writer and the reader.
template <class Speed, class Visit>
void visit_numbers(Speed& speed, Visit visit) {
  visit("steps_per_revolution", speed.steps_per_revolution, at_least_one);
  visit("samples_per_revolution", speed.samples_per_revolution, at_least_two);
  visit("recorded_revolutions", speed.recorded_revolutions, at_least_one);
  visit("revolutions", speed.revolutions, whole);
  visit("amplitude", speed.amplitude, not_negative);
  visit("period_revolutions", speed.period_revolutions, whole);
  visit("period_beats", speed.period_beats, whole);
  visit("off_beat_energy", speed.off_beat_energy, any);
  visit("chatter", speed.chatter, any);
  visit("chatter_node", speed.chatter_node, whole);
  visit("change", speed.change, not_negative);
  visit("change_rate", speed.change_rate, any);
  visit("contact_work", speed.energy.contact_work, any);
  visit("dissipated", speed.energy.dissipated, any);
  visit("energy_change", speed.energy.energy_change, any);
  visit("energy_closing_error", speed.energy.closing_error, any);
  visit("step_ratio", speed.step_ratio, not_negative);
  visit("largest_penetration", speed.largest_penetration, not_negative);
  visit("smallest_multiplier", speed.smallest_multiplier, not_positive);
  visit("contact_steps", speed.contact_steps, whole);
  visit("tension_steps", speed.tension_steps, whole);
  visit("solver_fallbacks", speed.solver_fallbacks, whole);
  visit("halving_difference", speed.audit.halving_difference, not_negative);
  visit("excluded_growth", speed.audit.excluded_growth, not_negative);
  visit("excluded_growth_uncertainty", speed.audit.excluded_growth_uncertainty, not_negative);
  visit("rest_difference", speed.audit.rest_difference, not_negative);
  visit("left_out_energy", speed.audit.left_out_energy, any);
  visit("compliance_condition", speed.audit.compliance_condition, not_negative);
  visit("leftover_steps", speed.audit.leftover_steps, whole);
  visit("tension_share", speed.audit.tension_share, share);
}

void write_numbers(Hdf5File& file, const std::string& group, const SpeedResponse& speed) {
  visit_numbers(speed, [&](const char* name, const auto& value, Bounds) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, std::optional<double>>) {
      if (value) file.set_attribute(group, name, *value);  // absent where it wasn't looked at
    } else if constexpr (std::is_same_v<Value, std::int64_t>) {
      file.set_attribute(group, name, static_cast<double>(value));
    } else {
      file.set_attribute(group, name, value);
    }
  });
}

/// Raises RunError unless the attribute is within its bounds.
double bounded(const Hdf5File& file, const std::string& group, const char* name, Bounds bounds) {
  const double value = file.number_attribute(group, name);
  if (value >= bounds.low && value <= bounds.high) return value;
  std::ostringstream must;
  must << (value < bounds.low ? "at least " : "at most ") << (value < bounds.low ? bounds.low : bounds.high);
  std::ostringstream is;
  is << value;
  throw RunError(file.path() + ": " + group + ": attribute " + name + " is " + is.str() + ", must be " + must.str());
}

void read_numbers(const Hdf5File& file, const std::string& group, SpeedResponse& speed) {
  visit_numbers(speed, [&](const char* name, auto& value, Bounds bounds) {
    using Value = std::decay_t<decltype(value)>;
    if (!speed.failure.empty()) bounds = any;
    if constexpr (std::is_same_v<Value, std::optional<double>>) {
      if (file.has_attribute(group, name)) value = bounded(file, group, name, bounds);
    } else if constexpr (std::is_same_v<Value, int>) {
      bounded(file, group, name, bounds);
      value = file.integer_attribute(group, name);
    } else {
      value = static_cast<Value>(bounded(file, group, name, bounds));
    }
  });
}

/// Only where it was asked for; older files have none.
void write_orbit(Hdf5File& file, const std::string& group, const OrbitReport& orbit) {
  if (orbit.outcome == OrbitReport::Outcome::none) return;
  file.set_attribute(group, "orbit", std::string(name_of(outcome_names, orbit.outcome)));
  file.set_attribute(group, "orbit_revolutions", orbit.revolutions);
  file.set_attribute(group, "orbit_residual", orbit.residual);
  file.set_attribute(group, "multiplier", orbit.multiplier);
  file.set_attribute(group, "multiplier_uncertainty", orbit.multiplier_uncertainty);
  file.set_attribute(group, "multiplier_angle", orbit.multiplier_angle);
}

OrbitReport read_orbit(const Hdf5File& file, const std::string& group) {
  if (!file.has_attribute(group, "orbit")) return {};
  return {value_named(outcome_names, file.text_attribute(group, "orbit"), file.path() + ": " + group + ": orbit"),
          bounded(file, group, "orbit_revolutions", not_negative),
          bounded(file, group, "orbit_residual", not_negative),
          bounded(file, group, "multiplier", not_negative),
          bounded(file, group, "multiplier_uncertainty", not_negative),
          bounded(file, group, "multiplier_angle", not_negative)};
}

std::string start_at(const std::string& group, std::size_t place) {
  return group + "/starts/" + std::to_string(place);
}

void write_other_start(Hdf5File& file, const std::string& group, const OtherStart& start) {
  file.set_attribute(group, "start", start.start);
  file.set_attribute(group, "failure", start.failure);
  file.set_attribute(group, "motion", std::string(name_of(start.motion)));
  file.set_attribute(group, "amplitude", start.amplitude);
  file.set_attribute(group, "period_beats", start.period_beats);
  file.set_attribute(group, "difference", start.difference);
}

OtherStart read_other_start(const Hdf5File& file, const std::string& group) {
  OtherStart start;
  start.start = file.text_attribute(group, "start");
  start.failure = file.text_attribute(group, "failure");
  start.motion =
      value_named(motion_names, file.text_attribute(group, "motion"), file.path() + ": " + group + ": motion");
  start.amplitude = file.number_attribute(group, "amplitude");
  start.period_beats = file.integer_attribute(group, "period_beats");
  start.difference = file.number_attribute(group, "difference");
  return start;
}

/// The arrays of a speed, of the shapes that the scene and the speed's own numbers ask for.
void read_arrays(const Hdf5File& file, const std::string& group, NamedAxes& axes, SpeedResponse& speed) {
  const std::string clearance = group + "/clearance", displacement = group + "/displacement",
                    force = group + "/contact_force", count = group + "/contact_count";
  axes.require(clearance, {nodes_axis});
  axes.require(displacement, {samples_axis, sectors_axis, nodes_axis, components_axis});
  axes.require(force, {samples_axis, sectors_axis, nodes_axis});
  axes.require(count, {sectors_axis, nodes_axis, "casing areas"});
  speed.clearance = file.read_vector(clearance);
  speed.displacement = fold(file.read_array(displacement));
  speed.contact_force = fold(file.read_array(force));
  const Array<std::int32_t> counts = file.read_integers(count);
  using RowMajor = Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  speed.contact_count =
      Eigen::Map<const RowMajor>(counts.values.data(), static_cast<Eigen::Index>(counts.shape[0] * counts.shape[1]),
                                 static_cast<Eigen::Index>(counts.shape[2]));
  const double recorded = static_cast<double>(speed.steps_per_revolution) * speed.recorded_revolutions;
  if (speed.contact_count.minCoeff() < 0 || speed.contact_count.maxCoeff() > recorded)
    throw RunError(file.path() + ": " + count + ": must be within 0 .. the recorded steps");
}

}  // namespace

const char* name_of(MotionClass motion) {
  return name_of(motion_names, motion);
}

bool is_finite(const SpeedResponse& speed) {
  bool finite = speed.displacement.allFinite() && speed.contact_force.allFinite() && speed.clearance.allFinite() &&
                std::isfinite(speed.audit.orbit.residual) && std::isfinite(speed.audit.orbit.multiplier);
  visit_numbers(speed, [&](const char*, const auto& value, Bounds) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::optional<double>>)
      finite = finite && std::isfinite(value.value_or(0));
    else
      finite = finite && std::isfinite(static_cast<double>(value));
  });
  for (const OtherStart& start : speed.other_starts)
    finite = finite && std::isfinite(start.amplitude) && std::isfinite(start.difference);
  if (speed.snapshot)
    for (const Eigen::VectorXcd& state : speed.snapshot->displacement) finite = finite && state.allFinite();
  if (speed.cycle)
    for (const Eigen::MatrixXcd& states : speed.cycle->displacement) finite = finite && states.allFinite();
  return finite;
}

void write_speed_group(Hdf5File& file, const std::string& group, const SpeedResponse& speed,
                       const SimulatedScene& scene) {
  file.set_attribute(group, "speed", speed.speed);
  file.set_attribute(group, "failure", speed.failure);
  file.set_attribute(group, "motion", std::string(name_of(speed.motion)));
  file.set_attribute(group, "symmetry", std::string(name_of(symmetry_names, speed.audit.symmetry)));
  file.set_attribute(group, "halving_measure", speed.audit.halving_measure);
  file.set_attribute(group, "depth", std::string(name_of(depth_names, speed.depth)));
  write_numbers(file, group, speed);
  for (std::size_t i = 0; i < speed.other_starts.size(); ++i)
    write_other_start(file, start_at(group, i), speed.other_starts[i]);
  write_orbit(file, group, speed.audit.orbit);
  if (!speed.failure.empty()) return;
  const auto sectors = static_cast<std::size_t>(scene.independent_sectors);
  const auto nodes = static_cast<std::size_t>(scene.clearance.size());
  file.write(group + "/clearance", speed.clearance, "m");
  file.write(group + "/displacement", unfold(speed.displacement, {sectors, nodes, 3}), "m");
  file.write(group + "/contact_force", unfold(speed.contact_force, {sectors, nodes}), "N");
  const Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> counts = speed.contact_count;
  file.write(group + "/contact_count",
             Array<std::int32_t>{{sectors, nodes, static_cast<std::size_t>(counts.cols())},
                                 {counts.data(), counts.data() + counts.size()}},
             "steps");
  write_kept_states(file, group, speed, scene);
}

SpeedResponse read_speed_group(const Hdf5File& file, const std::string& group, const SimulatedScene& scene,
                               NamedAxes& axes) {
  SpeedResponse speed;
  speed.speed = bounded(file, group, "speed", {std::numeric_limits<double>::min(), any.high});
  speed.failure = file.text_attribute(group, "failure");
  const std::string where = file.path() + ": " + group;
  speed.motion = value_named(motion_names, file.text_attribute(group, "motion"), where + ": motion");
  speed.audit.symmetry = value_named(symmetry_names, file.text_attribute(group, "symmetry"), where + ": symmetry");
  speed.audit.halving_measure = file.text_attribute(group, "halving_measure");
  speed.depth = value_named(depth_names, file.text_attribute(group, "depth"), where + ": depth");
  read_numbers(file, group, speed);
  while (file.exists(start_at(group, speed.other_starts.size())))
    speed.other_starts.push_back(read_other_start(file, start_at(group, speed.other_starts.size())));
  speed.audit.orbit = read_orbit(file, group);
  if (!speed.failure.empty()) return speed;
  const Eigen::Index samples = static_cast<Eigen::Index>(speed.samples_per_revolution) * speed.recorded_revolutions;
  axes.set(samples_axis, static_cast<std::size_t>(samples), "samples_per_revolution x recorded_revolutions");
  read_arrays(file, group, axes, speed);
  if (speed.chatter_node >= speed.clearance.size())
    throw RunError(where + ": attribute chatter_node is " + std::to_string(speed.chatter_node) +
                   ", must be one of the " + std::to_string(speed.clearance.size()) + " contact nodes, from 0");
  read_kept_states(file, group, scene, axes, samples, speed);
  return speed;
}

}  // namespace tiprub
