// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/response_groups.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <type_traits>

#include "cases/program/text.h"
#include "simulate/response/named_axes.h"
#include "simulate/response/speed_numbers.h"

namespace tiprub {

namespace {

/// A matrix as an array whose first axis is the rows, and whose further axes are the columns.
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

/// Writes an attribute of any kind.
template <class Value>
void write_attribute(Hdf5File& file, const std::string& group, const char* name, const Value& value) {
  if constexpr (std::is_same_v<Value, std::optional<double>>) {
    if (value) file.set_attribute(group, name, *value);  // absent where it was not computed
  } else if constexpr (std::is_same_v<Value, std::int64_t>) {
    file.set_attribute(group, name, static_cast<double>(value));
  } else if constexpr (std::is_enum_v<Value>) {
    file.set_attribute(group, name, name_of(value));
  } else {
    file.set_attribute(group, name, value);
  }
}

/// Reads a number. Raises RunError unless it is within its bounds.
double bounded(const Hdf5File& file, const std::string& group, const std::string& name, Bounds bounds) {
  const double value = file.number_attribute(group, name);
  if (value >= bounds.low && value <= bounds.high) return value;
  throw FileError(file.path() + ": " + group + ": attribute " + name + " is " +
                  (value < bounds.low ? text_of(value, ", must be at least ", bounds.low)
                                      : text_of(value, ", must be at most ", bounds.high)));
}

/// Reads an attribute of any kind.
template <class Value>
void read_attribute(const Hdf5File& file, const std::string& group, const char* name, Value& value,
                    Bounds bounds = any) {
  if constexpr (std::is_same_v<Value, std::string>) {
    value = file.text_attribute(group, name);
  } else if constexpr (std::is_enum_v<Value>) {
    value = file.named_attribute(group, name, names_of<Value>);
  } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
    if (file.has_attribute(group, name)) value = bounded(file, group, name, bounds);
  } else if constexpr (std::is_same_v<Value, int>) {
    bounded(file, group, name, bounds);
    value = file.integer_attribute(group, name);
  } else {
    value = static_cast<Value>(bounded(file, group, name, bounds));
  }
}

/// Written only where a search was asked for; older files have none.
void write_orbit(Hdf5File& file, const std::string& group, const OrbitReport& orbit) {
  if (orbit.outcome == OrbitReport::Outcome::none) return;
  write_attribute(file, group, "orbit", orbit.outcome);
  visit_orbit_numbers(orbit, [&](const NumberMeaning& meaning, const auto& value) {
    write_attribute(file, group, meaning.name, value);
  });
}

OrbitReport read_orbit(const Hdf5File& file, const std::string& group) {
  OrbitReport orbit;
  if (!file.has_attribute(group, "orbit")) return orbit;
  read_attribute(file, group, "orbit", orbit.outcome);
  visit_orbit_numbers(orbit, [&](const NumberMeaning& meaning, auto& value) {
    const bool is_newer = std::is_same_v<decltype(value), int&>;  // orbit_maps
    if (!is_newer || file.has_attribute(group, meaning.name))
      read_attribute(file, group, meaning.name, value, is_newer ? any : meaning.bounds);
  });
  return orbit;
}

std::string start_at(const std::string& group, std::size_t place) {
  return group + "/starts/" + std::to_string(place);
}

/// Calls `visit(name, value)` with all that is known of another start, in the order of the file.
template <class OtherStart, class Visit>
void visit_start(OtherStart& start, const Visit& visit) {
  visit("start", start.start);
  visit("failure", start.failure);
  visit("motion", start.motion);
  visit("amplitude", start.amplitude);
  visit("period_beats", start.period_beats);
  visit("difference", start.difference);
  if (!start.blades) return;
  visit("excursion_least", start.blades->least);
  visit("excursion_median", start.blades->median);
  visit("excursion_largest", start.blades->largest);
}

void write_other_start(Hdf5File& file, const std::string& group, const OtherStart& start) {
  visit_start(start, [&](const char* name, const auto& value) { write_attribute(file, group, name, value); });
}

OtherStart read_other_start(const Hdf5File& file, const std::string& group) {
  OtherStart start;
  if (file.has_attribute(group, "excursion_median")) start.blades.emplace();
  visit_start(start, [&](const char* name, auto& value) { read_attribute(file, group, name, value); });
  return start;
}

std::string variation_at(const std::string& group, std::size_t place) {
  return group + "/budget/" + std::to_string(place);
}

/// The same with all that is known of a varied peak but its states.
template <class PeakVariation, class Visit>
void visit_variation(PeakVariation& variation, const Visit& visit) {
  visit("variation", variation.what, any);
  visit("setting", variation.setting, any);
  visit("failure", variation.failure, any);
  visit("speed", variation.speed, not_negative);
  visit("amplitude", variation.amplitude, not_negative);
  visit("excursion", variation.excursion, not_negative);
  visit("motion", variation.motion, any);
  visit("period_beats", variation.period_beats, any);
}

void write_variation(Hdf5File& file, const std::string& group, const PeakVariation& variation,
                     const SimulatedScene& scene) {
  visit_variation(variation, [&](const char* name, const auto& value, const Bounds& /*bounds*/) {
    write_attribute(file, group, name, value);
  });
  if (!variation.model_digest.empty()) file.set_attribute(group, "model_digest", variation.model_digest);
  if (!variation.cycle) return;
  file.set_attribute(group, "samples_per_revolution", variation.samples_per_revolution);
  file.set_attribute(group, "cycle_samples", static_cast<int>(variation.cycle->displacement.front().cols()));
  write_cycle(file, group, *variation.cycle, variation.samples_per_revolution, scene);
}

PeakVariation read_variation(const Hdf5File& file, const std::string& group, const SimulatedScene& scene,
                             NamedAxes& axes) {
  PeakVariation variation;
  visit_variation(variation, [&](const char* name, auto& value, const Bounds& bounds) {
    read_attribute(file, group, name, value, bounds);
  });
  NamedAxes of_other_model(file);  // it has other dofs
  if (file.has_attribute(group, "model_digest")) variation.model_digest = file.text_attribute(group, "model_digest");
  if (!file.exists(group + "/cycle")) return variation;
  int samples = 0;
  read_attribute(file, group, "samples_per_revolution", variation.samples_per_revolution, at_least_one);
  read_attribute(file, group, "cycle_samples", samples, at_least_one);
  variation.cycle =
      read_cycle(file, group + "/cycle", scene, variation.model_digest.empty() ? axes : of_other_model, samples);
  return variation;
}

/// Each speed has axes of its own, so that its netCDF group can be opened by itself.
void write_axes(Hdf5File& file, const std::string& group, const SpeedResponse& speed, const SimulatedScene& scene) {
  const double turn = 2 * std::numbers::pi;
  const Eigen::Index samples = speed.displacement.rows(), areas = speed.contact_count.cols();
  const Eigen::VectorXd angle = Eigen::VectorXd::LinSpaced(samples, 0, static_cast<double>(samples - 1));
  const Eigen::VectorXd middle = Eigen::VectorXd::LinSpaced(areas, 0.5, static_cast<double>(areas) - 0.5);
  write_axis(file, group + "/angle", Eigen::VectorXd(turn / speed.samples_per_revolution * angle), "rad",
             "angle of the rotor since the start of the recording");
  write_counting_axis(file, group + "/sector", scene.independent_sectors, "sector, from 0");
  write_counting_axis(file, group + "/contact_node", scene.clearance.size(), "contact node, from 0");
  file.write(group + "/component", {"r", "theta", "z"});
  file.make_axis(group + "/component");
  file.describe(group + "/component", "direction in the rotor frame");
  write_axis(file, group + "/casing_angle", Eigen::VectorXd(turn / static_cast<double>(areas) * middle), "rad",
             "absolute angle of the middle of the casing's area");
}

void write_arrays(Hdf5File& file, const std::string& group, const SpeedResponse& speed, const SimulatedScene& scene) {
  const auto sectors = static_cast<std::size_t>(scene.independent_sectors);
  const auto nodes = static_cast<std::size_t>(scene.clearance.size());
  const std::string angle = group + "/angle", sector = group + "/sector", node = group + "/contact_node";
  write_along(file, {node}, group + "/clearance", speed.clearance, "m",
              "clearance at this speed, of the tightest blade");
  write_along(file, {angle, sector, node, group + "/component"}, group + "/displacement",
              unfold(speed.displacement, {sectors, nodes, 3}), "m", "displacement without the static shift");
  write_along(file, {angle, sector, node}, group + "/contact_force", unfold(speed.contact_force, {sectors, nodes}),
              "N", "contact force against the normal, mean to the next sample");
  const Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> counts = speed.contact_count;
  write_along(file, {sector, node, group + "/casing_angle"}, group + "/contact_count",
              Array<std::int32_t>{{sectors, nodes, static_cast<std::size_t>(counts.cols())},
                                  {counts.data(), counts.data() + counts.size()}},
              "1", "recorded steps in contact");
}

/// Reads the arrays of a speed, whose shapes the scene and the numbers of the speed determine.
void read_arrays(const Hdf5File& file, const std::string& group, NamedAxes& axes, SpeedResponse& speed) {
  const std::string displacement = group + "/displacement", force = group + "/contact_force",
                    count = group + "/contact_count";
  speed.clearance = axes.read_vector(group + "/clearance", nodes_axis);
  axes.require(displacement, {samples_axis, sectors_axis, nodes_axis, components_axis});
  axes.require(force, {samples_axis, sectors_axis, nodes_axis});
  axes.require(count, {sectors_axis, nodes_axis, "casing areas"});
  speed.displacement = fold(file.read_array(displacement));
  speed.contact_force = fold(file.read_array(force));
  const Array<std::int32_t> counts = file.read_integers(count);
  using RowMajor = Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  speed.contact_count =
      Eigen::Map<const RowMajor>(counts.values.data(), static_cast<Eigen::Index>(counts.shape[0] * counts.shape[1]),
                                 static_cast<Eigen::Index>(counts.shape[2]));
  const double recorded = static_cast<double>(speed.steps_per_revolution) * speed.recorded_revolutions;
  if (speed.contact_count.minCoeff() < 0 || speed.contact_count.maxCoeff() > recorded)
    throw FileError(file.path() + ": " + count + ": must be within 0 .. the recorded steps");
}

void write_kept_states(Hdf5File& file, const std::string& group, const SpeedResponse& speed,
                       const SimulatedScene& scene) {
  if (speed.snapshot) write_snapshot(file, group, *speed.snapshot, speed.samples_per_revolution, scene);
  if (speed.cycle) write_cycle(file, group, *speed.cycle, speed.samples_per_revolution, scene);
}

void read_kept_states(const Hdf5File& file, const std::string& group, const SimulatedScene& scene, NamedAxes& axes,
                      Eigen::Index samples, SpeedResponse& speed) {
  if (file.exists(group + "/snapshot"))
    speed.snapshot = read_snapshot(file, group + "/snapshot", scene, axes, samples);
  if (file.exists(group + "/cycle")) speed.cycle = read_cycle(file, group + "/cycle", scene, axes, samples);
}

}  // namespace

std::string motion_text(MotionClass motion, int period_beats) {
  return name_of(motion) + (motion == MotionClass::subharmonic ? " 1/" + std::to_string(period_beats) : "");
}

bool is_finite(const SpeedResponse& speed) {
  bool finite = speed.displacement.allFinite() && speed.contact_force.allFinite() && speed.clearance.allFinite() &&
                std::isfinite(speed.audit.orbit.residual) && std::isfinite(speed.audit.orbit.multiplier);
  const auto require = [&](const auto& states_by_diameter) {
    for (const auto& states : states_by_diameter) finite = finite && states.allFinite();
  };
  visit_numbers(speed, [&](const NumberMeaning&, const std::optional<double>& value) {
    finite = finite && std::isfinite(value.value_or(0));
  });
  for (const OtherStart& start : speed.other_starts)
    finite = finite && std::isfinite(start.amplitude) && std::isfinite(start.difference);
  for (const PeakVariation& variation : speed.budget) {
    finite = finite && std::isfinite(variation.amplitude) && std::isfinite(variation.excursion);
    if (variation.cycle) require(variation.cycle->displacement);
  }
  if (speed.snapshot) require(speed.snapshot->displacement);
  if (speed.cycle) require(speed.cycle->displacement);
  return finite;
}

void write_speed_group(Hdf5File& file, const std::string& group, const SpeedResponse& speed,
                       const SimulatedScene& scene) {
  file.set_attribute(group, "speed", speed.speed);
  for (const SpeedText& text : texts_of(speed)) file.set_attribute(group, text.name, text.value);
  visit_numbers(speed, [&](const NumberMeaning& meaning, const auto& value) {
    write_attribute(file, group, meaning.name, value);
  });
  for (std::size_t i = 0; i < speed.other_starts.size(); ++i)
    write_other_start(file, start_at(group, i), speed.other_starts[i]);
  write_orbit(file, group, speed.audit.orbit);
  if (!speed.failure.empty()) return;
  write_axes(file, group, speed, scene);
  write_arrays(file, group, speed, scene);
  write_kept_states(file, group, speed, scene);
  for (std::size_t i = 0; i < speed.budget.size(); ++i)
    write_variation(file, variation_at(group, i), speed.budget[i], scene);
}

SpeedResponse read_speed_group(const Hdf5File& file, const std::string& group, const SimulatedScene& scene,
                               NamedAxes& axes) {
  SpeedResponse speed;
  speed.speed = bounded(file, group, "speed", {std::numeric_limits<double>::min(), any.high});
  speed.failure = file.text_attribute(group, "failure");
  read_attribute(file, group, "motion", speed.motion);
  read_attribute(file, group, "symmetry", speed.audit.symmetry);
  read_attribute(file, group, "depth", speed.depth);
  visit_numbers(speed, [&](const NumberMeaning& meaning, auto& value) {
    read_attribute(file, group, meaning.name, value, speed.failure.empty() ? meaning.bounds : any);
  });
  const std::string measure = file.text_attribute(group, "halving_measure");
  if (speed.audit.halving_difference && !measure.empty())
    read_attribute(file, group, "halving_measure", speed.audit.halving_measure.emplace());
  if (file.has_attribute(group, "halving_failure"))  // older files have it in the measure's place
    speed.audit.halving_failure = file.text_attribute(group, "halving_failure");
  while (file.exists(start_at(group, speed.other_starts.size())))
    speed.other_starts.push_back(read_other_start(file, start_at(group, speed.other_starts.size())));
  speed.audit.orbit = read_orbit(file, group);
  if (!speed.failure.empty()) return speed;
  const Eigen::Index samples = static_cast<Eigen::Index>(speed.samples_per_revolution) * speed.recorded_revolutions;
  axes.set(samples_axis, static_cast<std::size_t>(samples), "samples_per_revolution x recorded_revolutions");
  read_arrays(file, group, axes, speed);
  if (speed.chatter_node >= speed.clearance.size())
    throw FileError(file.path() + ": " + group + ": attribute chatter_node is " + std::to_string(speed.chatter_node) +
                    ", must be one of the " + std::to_string(speed.clearance.size()) + " contact nodes, from 0");
  read_kept_states(file, group, scene, axes, samples, speed);
  while (file.exists(variation_at(group, speed.budget.size())))
    speed.budget.push_back(read_variation(file, variation_at(group, speed.budget.size()), scene, axes));
  return speed;
}

std::vector<SpeedText> texts_of(const SpeedResponse& speed) {
  return {{"failure", "why there is no response; empty: there is one", speed.failure},
          {"motion", "class of the motion", name_of(speed.motion)},
          {"symmetry", "whether nodal diameters left out stay small", name_of(speed.audit.symmetry)},
          {"halving_measure", "what the last halving of the step was measured by",
           speed.audit.halving_measure ? name_of(*speed.audit.halving_measure) : ""},
          {"halving_failure", "why half the step gave no motion; empty: it did, or was not taken",
           speed.audit.halving_failure},
          {"depth", "how closely the speed was looked at", name_of(speed.depth)}};
}

}  // namespace tiprub
