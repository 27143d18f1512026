// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/branch_group.h"

#include <string>
#include <utility>

#include "cases/program/errors.h"
#include "simulate/response/written_axes.h"

namespace tiprub {

namespace {

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
    axes.require(dataset, {orbits});
    branch.*array.values = file.read_vector(dataset);
    require_sound(file, dataset, branch.*array.values);
  }
  if (file.exists(group + "/fold")) {
    axes.require(group + "/fold", {"folds of branch " + std::to_string(place)});
    branch.folds = file.read_vector(group + "/fold");
    require_sound(file, group + "/fold", branch.folds);
  }
  if (!(branch.speed.minCoeff() > 0)) throw FileError(file.path() + ": " + group + "/speed must be above 0");
  branch.start = file.number_attribute(group, "start");
  branch.steps_per_revolution = file.integer_attribute(group, "steps_per_revolution");
  branch.ends[0] = file.text_attribute(group, "first_end");
  branch.ends[1] = file.text_attribute(group, "last_end");
  return branch;
}

}  // namespace

void write_branch(Hdf5File& file, std::size_t place, const OrbitBranch& branch) {
  const std::string group = branch_group(place);
  write_counting_axis(file, group + "/orbit", branch.speed.size(), "orbit in the order of arc length, from 0");
  for (const BranchArray& array : arrays) {
    const std::string dataset = group + "/" + array.name;
    file.write(dataset, branch.*array.values, array.unit);
    file.describe(dataset, array.long_name, {group + "/orbit"});
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

}  // namespace tiprub
