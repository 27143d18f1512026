// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/speed/examination.h"

#include <utility>

#include "cases/program/errors.h"
#include "simulate/march/carried_state.h"
#include "simulate/orbits/speed_audit.h"
#include "simulate/speed/settled_march.h"

namespace tiprub {

namespace {

constexpr double neighbour = 0.01;  // of the speed, to each side
constexpr double disturbance = 2;   // times the displacement

OtherStart compared(const char* start, const SpeedResponse& found, const SpeedResponse& response, int lobes) {
  return {start,
          "",
          found.amplitude,
          found.motion,
          found.period_beats,
          found.samples_per_revolution == response.samples_per_revolution &&
                  found.displacement.cols() == response.displacement.cols()
              ? difference(found, response, lobes).value
              : 0.0};
}

/// What `motion` comes back with, named; or why it doesn't.
template <class Motion>
OtherStart attempt(const char* start, const SpeedResponse& response, int lobes, const Motion& motion) {
  try {
    return compared(start, motion(), response, lobes);
  } catch (const RunError& error) {
    OtherStart failed;
    failed.start = start;
    failed.failure = error.what();
    return failed;
  }
}

SpeedResponse settled_from(const Scene& scene, const RotorAtSpeed& rotor, const RotorState& start,
                           const SpeedResponse& response) {
  SpeedResponse found;
  found.speed = response.speed;
  settle(scene, rotor, start, {response.steps_per_revolution, scene.parameters.min_revolutions}, found);
  return found;
}

/// The state of the motion from rest at another speed.
RotorState state_at(const Scene& scene, double speed) {
  const RotorAtSpeed rotor = rotor_of(scene, speed);
  SpeedResponse response;
  response.speed = speed;
  return state_of(*settle_roughly(scene, rotor, response), rotor, scene.model);
}

RotorState disturbed(RotorState state) {
  for (Eigen::VectorXcd& displacement : state.displacement) displacement *= disturbance;
  return state;
}

SpeedResponse of_whole_wheel(const Scene& scene, const SpeedResponse& response) {
  SimulateParameters parameters = scene.parameters;
  parameters.nodal_diameters = DiameterChoice::all;
  const SceneScope scope = find_scope(scene.model.sector_count, scene.casing.lobes, parameters);
  const Scene whole{scene.model, scene.casing, parameters, scope};
  return settled_from(whole, rotor_of(whole, response.speed), {}, response);
}

void check_halved_step(const Scene& scene, const RotorAtSpeed& rotor, const RotorState& end,
                       SpeedResponse& response) {
  SpeedResponse halved;
  halved.speed = response.speed;
  try {
    settle(scene, rotor, end, {2 * response.steps_per_revolution, scene.parameters.min_revolutions}, halved);
    const ResponseDifference found = difference(response, halved, scene.casing.lobes);
    response.audit.halving_difference = found.value;
    response.audit.halving_measure = found.measure;
  } catch (const RunError& error) {
    response.audit.halving_measure = error.what();
  }
}

}  // namespace

void examine(const Scene& scene, const RotorAtSpeed& rotor, const RotorState& end, SpeedResponse& response) {
  const int lobes = scene.casing.lobes;
  if (!response.audit.halving_difference) check_halved_step(scene, rotor, end, response);
  for (const auto& [start, speed] :
       {std::pair("up", response.speed * (1 - neighbour)), std::pair("down", response.speed * (1 + neighbour))})
    response.other_starts.push_back(attempt(start, response, lobes, [&, at = speed] {
      return settled_from(scene, rotor, state_at(scene, at), response);
    }));
  response.other_starts.push_back(
      attempt("disturbed", response, lobes, [&] { return settled_from(scene, rotor, disturbed(end), response); }));
  const SymmetryVerdict symmetry = response.audit.symmetry;
  if (symmetry == SymmetryVerdict::breaking || symmetry == SymmetryVerdict::undecided)
    response.other_starts.push_back(
        attempt("whole wheel", response, lobes, [&] { return of_whole_wheel(scene, response); }));
}

}  // namespace tiprub
