// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/branch_runs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <set>

#include "simulate/branches/branch.h"
#include "simulate/motion/attempt.h"
#include "simulate/periodic/marched_map.h"
#include "simulate/periodic/newton.h"
#include "simulate/periodic/orbit_search.h"
#include "simulate/sweep/adaptive_speeds.h"

namespace tiprub::simulate {

namespace {

constexpr int first_try = 12, last_try = 96;  // revolutions after the casing has grown; doubled each time
constexpr double newton_step = 1e-4;          // of the state: bound of the last step, for a start that LOCA refines
constexpr double first_step = 1e-3;           // of a speed
constexpr double same_amplitude = 0.03;       // relative difference of an orbit and a motion that counts as none

/// An orbit, attracting or repelling, near the path of a march from rest.
std::optional<Eigen::VectorXd> orbit_near(const Scene& scene, const SharedRotor& rotor, int steps) {
  TimeMarch march(marched_scene(scene, rotor, steps));
  for (int revolutions = first_try; revolutions <= last_try; revolutions *= 2) {
    const std::int64_t until = (scene.casing.grown_after() + revolutions) * steps;
    while (march.step_count() < until) march.step();
    const MarchState before(march);
    MarchedMap map(march);
    const NewtonResult orbit = find_fixed_point(map, map.symmetric().state(), {newton_step});
    if (orbit.found) return orbit.state;
    before.restore(march);
  }
  return std::nullopt;
}

/// Whether a branch has an orbit of this amplitude [m] at this speed [rad/s].
bool passes(const OrbitBranch& branch, double speed, double amplitude) {
  for (Eigen::Index i = 1; i < branch.speed.size(); ++i) {
    const double along = (speed - branch.speed[i - 1]) / (branch.speed[i] - branch.speed[i - 1]);
    if (!(along >= 0 && along <= 1)) continue;
    const double here = branch.amplitude[i - 1] + along * (branch.amplitude[i] - branch.amplitude[i - 1]);
    if (std::abs(here - amplitude) <= same_amplitude * amplitude) return true;
  }
  return false;
}

std::optional<OrbitBranch> branch_from(const Scene& scene, double speed) {
  const SimulateParameters& parameters = scene.parameters;
  const BranchLimits limits{speed * (1 - parameters.branch_range),
                            std::min(speed * (1 + parameters.branch_range), scene.model.speed_max), first_step,
                            parameters.branch_steps};
  const auto followed = attempt([&]() -> std::optional<OrbitBranch> {
    const SharedRotor rotor = rotor_of(scene, speed);
    const int steps = steps_per_revolution(scene.scope, parameters, rotor->first_frequency, speed);
    const std::optional<Eigen::VectorXd> start = orbit_near(scene, rotor, steps);
    if (!start || !(start->norm() > 0)) return std::nullopt;
    return follow_branch(scene, speed, steps, *start, limits);
  });
  return followed.result.value_or(std::nullopt);
}

/// The examined speeds and both sides of each jump; then, if they are asked for, all others with a periodic motion.
std::vector<double> starts_of(BranchChoice choice, const std::vector<double>& speeds,
                              const FinishedSpeeds& finished) {
  std::set<double> first, others;
  SampledCurve curve;
  for (const double speed : speeds) {
    const SpeedResponse response = finished.read(speed, Depth::full);
    if (response.depth >= Depth::examined) first.insert(speed);
    if (choice == BranchChoice::speeds && response.motion == MotionClass::periodic) others.insert(speed);
    if (response.failure.empty()) curve.push_back({speed, response.amplitude});
  }
  for (const std::size_t low : located_jumps(curve, {})) first.insert({curve[low].speed, curve[low + 1].speed});
  std::vector<double> starts(first.begin(), first.end());
  std::ranges::set_difference(others, first, std::back_inserter(starts));
  return starts;
}

}  // namespace

std::vector<OrbitBranch> follow_branches(const Scene& scene, const std::vector<double>& speeds,
                                         const FinishedSpeeds& finished, Progress::Shown shown) {
  std::vector<OrbitBranch> branches;
  const bool asked =
      scene.parameters.branches != BranchChoice::none && scene.parameters.sweep == SweepDirection::rest;
  if (!asked || !has_symmetric_map(scene)) return branches;
  const std::vector<double> starts = starts_of(scene.parameters.branches, speeds, finished);
  Progress progress("branches", starts.size(), shown);
  for (const double speed : starts) {
    const double amplitude = finished.read(speed, Depth::full).amplitude;
    const auto is_on = [&](const OrbitBranch& branch) { return passes(branch, speed, amplitude); };
    if (std::ranges::none_of(branches, is_on))
      if (std::optional<OrbitBranch> branch = branch_from(scene, speed)) branches.push_back(std::move(*branch));
    progress.advance();
  }
  return branches;
}

}  // namespace tiprub::simulate
