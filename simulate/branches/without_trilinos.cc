// SPDX-License-Identifier: GPL-3.0-or-later
// In place of what Trilinos computes, in a build with TIPRUB_ORBITS=OFF: reading the case has refused whatever asks
// for it, and a call is a bug.
#include <stdexcept>

#include "simulate/branches/branch.h"
#include "simulate/periodic/multipliers.h"
#include "simulate/periodic/newton.h"

namespace tiprub::simulate {

namespace {

[[noreturn]] void refuse() {
  throw std::logic_error("periodic motions are sought in a build without them (TIPRUB_ORBITS=OFF)");
}

}  // namespace

NewtonResult find_fixed_point(PeriodicMap&, const Eigen::VectorXd&, const NewtonLimits&) {
  refuse();
}

Multiplier largest_multiplier(const LinearMap&, Eigen::Index, const MultiplierGoal&) {
  refuse();
}

OrbitBranch follow_branch(const Scene&, double, int, const Eigen::VectorXd&, const BranchLimits&) {
  refuse();
}

}  // namespace tiprub::simulate
