// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/response_groups.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "cases/program/errors.h"
#include "simulate/motion/column.h"
#include "simulate/response/named_axes.h"

namespace tiprub {

namespace {

const std::string frequency_group = "/frequencies";
const std::string node_distortion = "/casing/node_distortion", node_crest = "/casing/node_crest";
const std::string scanned_speeds = "/scanned_speed";
const std::string scanned_amplitudes = "/scanned_amplitude";
const std::string damping_of_modes = frequency_group + "/damping_ratio";
const std::string damping_group = "/damping", family_axis = damping_group + "/family",
                  ratio_by_family = damping_group + "/ratio_by_family",
                  damping_frequency = damping_group + "/frequency",
                  ratio_by_frequency = damping_group + "/ratio_by_frequency";
// Of single modes, along mode_axis.
const std::string mode_axis = damping_group + "/mode", diameter_of_mode = damping_group + "/nodal_diameter_of_mode",
                  family_of_mode = damping_group + "/family_of_mode",
                  ratio_of_mode = damping_group + "/ratio_of_mode";

/// Raises FileError with the violated condition.
void require(bool holds, const Hdf5File& file, const std::string& must) {
  if (!holds) throw FileError(file.path() + ": " + must);
}

template <class Values>
bool increases(const Values& values) {
  return std::ranges::adjacent_find(values, std::greater_equal<>()) == values.end();
}

/// Reads an optional attribute of the file.
void read_positive(const Hdf5File& file, const std::string& name, double& value) {
  if (file.has_attribute("/", name)) value = file.number_attribute("/", name);
  require(value > 0, file, "attribute " + name + " must be above 0");
}

void require_ratios(const Hdf5File& file, const std::string& name, const Eigen::MatrixXd& ratios) {
  require(ratios.minCoeff() >= 0 && ratios.maxCoeff() <= 1, file, name + " must be within 0 .. 1");
}

std::vector<ModeDamping> read_modes(const Hdf5File& file, NamedAxes& axes) {
  std::vector<ModeDamping> modes;
  if (!file.exists(ratio_of_mode)) return modes;
  const Eigen::VectorXd diameters = axes.read_vector(diameter_of_mode, "modes of the damping"),
                        families = axes.read_vector(family_of_mode, "modes of the damping"),
                        ratios = axes.read_vector(ratio_of_mode, "modes of the damping");
  constexpr double most = 1e6;
  for (const auto& [name, numbers] : {std::pair{diameter_of_mode, &diameters}, std::pair{family_of_mode, &families}})
    require(numbers->minCoeff() >= 0 && numbers->maxCoeff() <= most, file, name + " must be within 0 .. 1e6");
  require_ratios(file, ratio_of_mode, ratios);
  for (Eigen::Index i = 0; i < ratios.size(); ++i)
    modes.push_back({static_cast<int>(diameters[i]), static_cast<int>(families[i]), ratios[i]});
  return modes;
}

DampingRatios read_damping(const Hdf5File& file, NamedAxes& axes) {
  DampingRatios damping;
  if (!file.exists(damping_group)) return damping;
  damping.by_mode = read_modes(file, axes);
  damping.beyond = file.number_attribute(damping_group, "ratio_beyond");
  require(damping.beyond >= 0 && damping.beyond <= 1, file,
          damping_group + ": attribute ratio_beyond must be within 0 .. 1");
  if (!file.exists(ratio_by_frequency)) {
    const Eigen::VectorXd ratios = axes.read_vector(ratio_by_family, "families");
    require_ratios(file, ratio_by_family, ratios);
    damping.by_family.assign(ratios.begin(), ratios.end());
    return damping;
  }
  const Eigen::VectorXd frequencies = axes.read_vector(damping_frequency, "frequencies of the damping"),
                        ratios = axes.read_vector(ratio_by_frequency, "frequencies of the damping");
  require(increases(frequencies), file, damping_frequency + " must increase");
  require_ratios(file, ratio_by_frequency, ratios);
  for (Eigen::Index i = 0; i < ratios.size(); ++i) damping.by_frequency.push_back({frequencies[i], ratios[i]});
  return damping;
}

void read_casing(const Hdf5File& file, NamedAxes& axes, SimulatedScene& scene) {
  scene.casing_angle = axes.read_vector("/casing/angle", "angles");
  scene.casing_distortion = axes.read_vector("/casing/distortion", "angles");
  scene.clearance = axes.read_vector("/casing/clearance", nodes_axis);
  if (file.has_attribute("/casing", "crest")) scene.largest_distortion = file.number_attribute("/casing", "crest");
  if (file.exists(node_distortion)) {
    scene.node_distortion = axes.read_matrix(node_distortion, {"angles", nodes_axis});
    scene.node_crest = axes.read_vector(node_crest, nodes_axis);
  }
  scene.lobes = file.integer_attribute("/casing", "lobes");
  scene.clearance_state = file.named_attribute("/casing", "clearance_state", clearance_state_names);
  constexpr double turn = 2 * std::numbers::pi, rounding = 1e-9;
  const Eigen::VectorXd& angle = scene.casing_angle;
  require(angle.size() > 1 && increases(angle) && angle[0] >= -rounding && angle.tail<1>()[0] <= turn + rounding,
          file, "/casing/angle must increase within 0 .. 2 pi, 2 angles at least");
  require(scene.lobes >= 1, file, "/casing: attribute lobes must be at least 1");
}

std::string frequencies_at(std::size_t nodal_diameter) {
  return frequency_group + "/nodal_diameter/" + std::to_string(nodal_diameter);
}

/// The damping ratios of the modes of frequencies_at().
std::string damping_at(std::size_t nodal_diameter) {
  return damping_of_modes + "/" + std::to_string(nodal_diameter);
}

void write_modes(Hdf5File& file, const std::vector<ModeDamping>& modes) {
  if (modes.empty()) return;
  write_counting_axis(file, mode_axis, std::ssize(modes), "mode with damping of its own, from 0");
  const auto write = [&](const std::string& name, const auto& number, const char* long_name) {
    write_along(file, {mode_axis}, name, column(modes, number), "1", long_name);
  };
  write(diameter_of_mode, &ModeDamping::nodal_diameter, "nodal diameter of the mode");
  write(family_of_mode, &ModeDamping::family, "family of the mode, from 0");
  write(ratio_of_mode, &ModeDamping::ratio, "damping of critical, if the mode is below the resolved frequency");
}

void write_damping(Hdf5File& file, const DampingRatios& damping) {
  if (damping.by_family.empty() && damping.by_frequency.empty()) return;
  file.set_attribute(damping_group, "ratio_beyond", damping.beyond);
  write_modes(file, damping.by_mode);
  if (damping.by_frequency.empty()) {
    write_counting_axis(file, family_axis, std::ssize(damping.by_family),
                        "family of modes, from 0; the last one stands for all further");
    write_along(file, {family_axis}, ratio_by_family, column(damping.by_family, std::identity()), "1",
                "damping of critical, of modes up to the resolved frequency");
    return;
  }
  write_axis(file, damping_frequency, column(damping.by_frequency, [](const auto& point) { return point[0]; }), "Hz",
             "frequency of a mode");
  write_along(file, {damping_frequency}, ratio_by_frequency,
              column(damping.by_frequency, [](const auto& point) { return point[1]; }), "1",
              "damping of critical, linear between, of modes up to the resolved frequency");
}

void write_casing(Hdf5File& file, const SimulatedScene& scene) {
  const std::string angle = "/casing/angle", node = "/casing/contact_node";
  write_axis(file, angle, scene.casing_angle, "rad", "absolute angle");
  write_along(file, {angle}, "/casing/distortion", scene.casing_distortion, "m", "how far the casing stands inward");
  write_counting_axis(file, node, scene.clearance.size(), "contact node, from 0");
  write_along(file, {node}, "/casing/clearance", scene.clearance, "m",
              "clearance as the case gives it, of the tightest blade");
  if (scene.node_distortion.size() > 0) {
    write_along(file, {angle, node}, node_distortion, scene.node_distortion, "m",
                "how far the casing stands inward over each contact node");
    write_along(file, {node}, node_crest, scene.node_crest, "m", "the largest of it");
  }
  file.set_attribute("/casing", "lobes", scene.lobes);
  if (scene.largest_distortion) file.set_attribute("/casing", "crest", *scene.largest_distortion);
  file.set_attribute("/casing", "clearance_state", name_in(clearance_state_names, scene.clearance_state));
}

}  // namespace

void write_scene(Hdf5File& file, const SimulatedScene& scene) {
  file.set_attribute("/", "sector_count", scene.sector_count);
  file.set_attribute("/", "independent_sectors", scene.independent_sectors);
  file.set_attribute("/", "model_digest", scene.model_digest);
  file.write_text("/provenance", scene.provenance);
  file.write_text("/casing/table", scene.casing);
  file.set_attribute("/", "scope", scene.scope);
  if (scene.scheme) file.set_attribute("/", "scheme", name_in(scheme_names, *scene.scheme));
  if (scene.contact) file.set_attribute("/", "contact", name_in(contact_rule_names, *scene.contact));
  file.set_attribute("/", "accuracy", scene.asked.critical_speeds);
  file.set_attribute("/", "step_tolerance", scene.asked.step);
  file.set_attribute("/", "settle_tolerance", scene.asked.settling);
  const std::string moving = "/nodal_diameters";
  file.write(moving,
             Array<std::int32_t>{{scene.nodal_diameters.size()},
                                 {scene.nodal_diameters.begin(), scene.nodal_diameters.end()}},
             "1");
  file.make_axis(moving);
  file.describe(moving, "nodal diameters that move");
  write_casing(file, scene);
  if (std::isfinite(scene.resolved_frequency))
    file.set_attribute("/", "resolved_frequency", scene.resolved_frequency);
  write_damping(file, scene.damping);
  write_effects(file, scene.effects);
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
  scene.damping = read_damping(file, axes);
  scene.effects = read_effects(file);
  if (file.has_attribute("/", "scheme")) scene.scheme = file.named_attribute("/", "scheme", scheme_names);
  if (file.has_attribute("/", "contact")) scene.contact = file.named_attribute("/", "contact", contact_rule_names);
  read_positive(file, "accuracy", scene.asked.critical_speeds);
  read_positive(file, "step_tolerance", scene.asked.step);
  read_positive(file, "settle_tolerance", scene.asked.settling);
  read_positive(file, "resolved_frequency", scene.resolved_frequency);
  read_casing(file, axes, scene);
  return scene;
}

void write_frequencies(Hdf5File& file, const FrequencyTable& frequencies) {
  const std::string speed = frequency_group + "/speed";
  write_axis(file, speed, frequencies.speed, "rad/s", "speed of the rotor");
  for (std::size_t n = 0; n < frequencies.by_nodal_diameter.size(); ++n) {
    const std::string mode = frequency_group + "/mode_" + std::to_string(n);
    write_counting_axis(file, mode, frequencies.by_nodal_diameter[n].cols(), "mode, from 0");
    write_along(file, {speed, mode}, frequencies_at(n), frequencies.by_nodal_diameter[n], "Hz",
                "natural frequencies; negative: statically unstable");
    if (n >= frequencies.damping_ratio.size()) continue;
    write_along(file, {speed, mode}, damping_at(n), frequencies.damping_ratio[n], "1",
                "damping of critical that these modes are marched with");
  }
}

FrequencyTable read_frequencies(const Hdf5File& file, int sector_count, NamedAxes& axes) {
  FrequencyTable table;
  if (!file.exists(frequency_group)) return table;
  const std::string speeds = "speeds of the frequencies";
  table.speed = axes.read_vector(frequency_group + "/speed", speeds);
  require(increases(table.speed) && table.speed[0] >= 0, file,
          frequency_group + "/speed must increase from 0 or more");
  for (std::size_t n = 0; n <= static_cast<std::size_t>(sector_count / 2); ++n) {
    const std::string modes = "modes of nodal diameter " + std::to_string(n);
    table.by_nodal_diameter.push_back(axes.read_matrix(frequencies_at(n), {speeds, modes}));
    if (!file.exists(damping_of_modes)) continue;
    table.damping_ratio.push_back(axes.read_matrix(damping_at(n), {speeds, modes}));
    require_ratios(file, damping_at(n), table.damping_ratio.back());
  }
  return table;
}

void write_scan(Hdf5File& file, const Eigen::VectorXd& speeds, const Eigen::VectorXd& amplitudes) {
  if (speeds.size() == 0) return;
  write_axis(file, scanned_speeds, speeds, "rad/s", "speeds scanned with a coarse step");
  if (amplitudes.size() == 0) return;
  write_along(file, {scanned_speeds}, scanned_amplitudes, amplitudes, "m",
              "amplitude of the scan; negative where the march failed");
}

void read_scan(const Hdf5File& file, NamedAxes& axes, Eigen::VectorXd& speeds, Eigen::VectorXd& amplitudes) {
  if (!file.exists(scanned_speeds)) return;
  speeds = axes.read_vector(scanned_speeds, "scanned speeds");
  require(increases(speeds) && speeds[0] >= 0, file, scanned_speeds + " must increase from 0 or more");
  if (!file.exists(scanned_amplitudes)) return;
  amplitudes = axes.read_vector(scanned_amplitudes, "scanned speeds");
}

}  // namespace tiprub
