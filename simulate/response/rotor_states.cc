// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/response_groups.h"

#include <numbers>
#include <string>

namespace tiprub {

namespace {

constexpr const char* unit = "m";
constexpr const char* state_meaning = "wave of the model's dofs; m in contact dofs";

/// The axis of the model's dofs of a nodal diameter, which all states of all speeds share.
std::string dofs_axis(int nodal_diameter) {
  return "dofs of nodal diameter " + std::to_string(nodal_diameter);
}

std::string at(const std::string& states, int nodal_diameter) {
  return states + "/" + std::to_string(nodal_diameter);
}

/// The axes of states lie in the group of the speed, because the groups of states hold states only.
std::string dofs_of(const std::string& group, int nodal_diameter) {
  return group + "/dof_" + std::to_string(nodal_diameter);
}

void write_dofs(Hdf5File& file, const std::string& group, int nodal_diameter, Eigen::Index count) {
  if (const std::string dofs = dofs_of(group, nodal_diameter); !file.exists(dofs))
    write_counting_axis(file, dofs, count, "dof of the model, from 0");
}

}  // namespace

void write_snapshot(Hdf5File& file, const std::string& group, const RotorSnapshot& snapshot,
                    int samples_per_revolution, const SimulatedScene& scene) {
  const std::string place = group + "/snapshot", instant = group + "/snapshot_angle";
  const double angle = 2 * std::numbers::pi * snapshot.sample / samples_per_revolution;
  write_axis(file, instant, Eigen::VectorXd::Constant(1, angle), "rad", "angle of the rotor at the snapshot");
  for (std::size_t i = 0; i < snapshot.displacement.size(); ++i) {
    const int n = scene.nodal_diameters[i];
    write_dofs(file, group, n, snapshot.displacement[i].size());
    write_along(file, {dofs_of(group, n), instant}, at(place, n), Eigen::MatrixXcd(snapshot.displacement[i]), unit,
                state_meaning);
  }
  file.set_attribute(place, "sample", snapshot.sample);
  file.set_attribute(place, "angle", angle);
  file.set_attribute(place, "contact_force", snapshot.force);
}

RotorSnapshot read_snapshot(const Hdf5File& file, const std::string& place, const SimulatedScene& scene,
                            NamedAxes& axes, Eigen::Index samples) {
  RotorSnapshot snapshot;
  snapshot.sample = file.integer_attribute(place, "sample");
  snapshot.force = file.number_attribute(place, "contact_force");
  if (snapshot.sample < 0 || snapshot.sample >= samples)
    throw FileError(file.path() + ": " + place + ": sample " + std::to_string(snapshot.sample) +
                    " is not one of the " + std::to_string(samples) + " recorded ones");
  axes.set("instant", 1, "a snapshot is one");
  for (const int n : scene.nodal_diameters) {
    axes.require(at(place, n), {dofs_axis(n), "instant"});
    snapshot.displacement.emplace_back(file.read_complex_matrix(at(place, n)).col(0));
  }
  return snapshot;
}

void write_cycle(Hdf5File& file, const std::string& group, const RotorCycle& cycle, int samples_per_revolution,
                 const SimulatedScene& scene) {
  const std::string place = group + "/cycle", angles = group + "/cycle_angle";
  const double spacing = 2 * std::numbers::pi / samples_per_revolution;
  const Eigen::Index samples = cycle.displacement.front().cols();
  write_axis(file, angles,
             spacing * Eigen::VectorXd::LinSpaced(samples, cycle.first_sample,
                                                  static_cast<double>(cycle.first_sample + samples - 1)),
             "rad", "angle of the rotor at the samples of the cycle");
  for (std::size_t i = 0; i < cycle.displacement.size(); ++i) {
    const int n = scene.nodal_diameters[i];
    write_dofs(file, group, n, cycle.displacement[i].rows());
    write_along(file, {dofs_of(group, n), angles}, at(place, n), cycle.displacement[i], unit, state_meaning);
  }
  file.set_attribute(place, "first_sample", cycle.first_sample);
}

RotorCycle read_cycle(const Hdf5File& file, const std::string& place, const SimulatedScene& scene, NamedAxes& axes,
                      Eigen::Index samples) {
  RotorCycle cycle;
  cycle.first_sample = file.integer_attribute(place, "first_sample");
  if (cycle.first_sample < 0 || cycle.first_sample >= samples)
    throw FileError(file.path() + ": " + place + ": first_sample " + std::to_string(cycle.first_sample) +
                    " is not one of the " + std::to_string(samples) + " recorded ones");
  axes.set("samples of the cycle", static_cast<std::size_t>(samples - cycle.first_sample),
           "from first_sample to the last recorded one");
  for (const int n : scene.nodal_diameters) {
    axes.require(at(place, n), {dofs_axis(n), "samples of the cycle"});
    cycle.displacement.push_back(file.read_complex_matrix(at(place, n)));
  }
  return cycle;
}

}  // namespace tiprub
