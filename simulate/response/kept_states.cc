// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/kept_states.h"

#include <numbers>

namespace tiprub {

namespace {

constexpr const char* unit = "m in contact dofs";

/// The model's dofs of a nodal diameter: as many in each state of each speed.
std::string dofs_axis(int nodal_diameter) {
  return "dofs of nodal diameter " + std::to_string(nodal_diameter);
}

std::string at(const std::string& states, int nodal_diameter) {
  return states + "/" + std::to_string(nodal_diameter);
}

void write_snapshot(Hdf5File& file, const std::string& place, const RotorSnapshot& snapshot,
                    const SpeedResponse& speed, const SimulatedScene& scene) {
  for (std::size_t i = 0; i < snapshot.displacement.size(); ++i)
    file.write(at(place, scene.nodal_diameters[i]), Eigen::MatrixXcd(snapshot.displacement[i]), unit);
  file.set_attribute(place, "sample", snapshot.sample);
  file.set_attribute(place, "angle", 2 * std::numbers::pi * snapshot.sample / speed.samples_per_revolution);
  file.set_attribute(place, "contact_force", snapshot.force);
}

RotorSnapshot read_snapshot(const Hdf5File& file, const std::string& place, const SimulatedScene& scene,
                            NamedAxes& axes, Eigen::Index samples) {
  RotorSnapshot snapshot;
  snapshot.sample = file.integer_attribute(place, "sample");
  snapshot.force = file.number_attribute(place, "contact_force");
  if (snapshot.sample < 0 || snapshot.sample >= samples)
    throw RunError(file.path() + ": " + place + ": sample " + std::to_string(snapshot.sample) +
                   " is not one of the " + std::to_string(samples) + " recorded ones");
  axes.set("instant", 1, "a snapshot is one");
  for (const int n : scene.nodal_diameters) {
    axes.require(at(place, n), {dofs_axis(n), "instant"});
    snapshot.displacement.emplace_back(file.read_complex_matrix(at(place, n)).col(0));
  }
  return snapshot;
}

void write_cycle(Hdf5File& file, const std::string& place, const RotorCycle& cycle, const SimulatedScene& scene) {
  for (std::size_t i = 0; i < cycle.displacement.size(); ++i)
    file.write(at(place, scene.nodal_diameters[i]), cycle.displacement[i], unit);
  file.set_attribute(place, "first_sample", cycle.first_sample);
}

RotorCycle read_cycle(const Hdf5File& file, const std::string& place, const SimulatedScene& scene, NamedAxes& axes,
                      Eigen::Index samples) {
  RotorCycle cycle;
  cycle.first_sample = file.integer_attribute(place, "first_sample");
  if (cycle.first_sample < 0 || cycle.first_sample >= samples)
    throw RunError(file.path() + ": " + place + ": first_sample " + std::to_string(cycle.first_sample) +
                   " is not one of the " + std::to_string(samples) + " recorded ones");
  axes.set("samples of the cycle", static_cast<std::size_t>(samples - cycle.first_sample),
           "from first_sample to the last recorded one");
  for (const int n : scene.nodal_diameters) {
    axes.require(at(place, n), {dofs_axis(n), "samples of the cycle"});
    cycle.displacement.push_back(file.read_complex_matrix(at(place, n)));
  }
  return cycle;
}

}  // namespace

void write_kept_states(Hdf5File& file, const std::string& group, const SpeedResponse& speed,
                       const SimulatedScene& scene) {
  if (speed.snapshot) write_snapshot(file, group + "/snapshot", *speed.snapshot, speed, scene);
  if (speed.cycle) write_cycle(file, group + "/cycle", *speed.cycle, scene);
}

void read_kept_states(const Hdf5File& file, const std::string& group, const SimulatedScene& scene, NamedAxes& axes,
                      Eigen::Index samples, SpeedResponse& speed) {
  if (file.exists(group + "/snapshot"))
    speed.snapshot = read_snapshot(file, group + "/snapshot", scene, axes, samples);
  if (file.exists(group + "/cycle")) speed.cycle = read_cycle(file, group + "/cycle", scene, axes, samples);
}

}  // namespace tiprub
