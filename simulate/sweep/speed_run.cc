// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/speed_run.h"

#include "cases/program/errors.h"
#include "simulate/march/carried_state.h"
#include "simulate/orbits/excluded_growth.h"
#include "simulate/orbits/speed_audit.h"
#include "simulate/sweep/settled_march.h"

namespace tiprub {

namespace {

/// With a step that was given: how far half of it is from it.
void check_halved_step(const Scene& scene, const RotorAtSpeed& rotor, const RotorState& start,
                       SpeedResponse& response) {
  SpeedResponse halved;
  halved.speed = response.speed;
  try {
    settle(scene, rotor, start, {2 * response.steps_per_revolution, {scene.parameters.min_revolutions}}, halved);
    const ResponseDifference found = difference(response, halved);
    response.audit.halving_difference = found.value;
    response.audit.halving_measure = found.measure;
  } catch (const RunError& error) {
    response.audit.halving_measure = error.what();
  }
}

void check_symmetry(const Scene& scene, const TimeMarch& march, const RotorAtSpeed& rotor, SpeedResponse& response) {
  SpeedAudit& audit = response.audit;
  if (rotor.others.empty()) return;
  audit.symmetry = SymmetryVerdict::unchecked;
  if (scene.parameters.symmetry_check_revolutions == 0 || response.displacement.isZero(0)) return;
  try {
    const Growth growth = excluded_growth(march, rotor, scene.casing, scene.model.contact, response.period_revolutions,
                                          scene.parameters.symmetry_check_revolutions);
    audit.excluded_growth = growth.factor;
    audit.excluded_growth_uncertainty = growth.uncertainty;
    audit.symmetry = judge(growth);
  } catch (const RunError&) {  // the whole wheel's contact problem failed: unchecked
  }
}

void compare_with_start_at_rest(const Scene& scene, const RotorAtSpeed& rotor, SpeedResponse& response) {
  SpeedResponse from_rest;
  from_rest.speed = response.speed;
  try {
    settle(scene, rotor, {}, {response.steps_per_revolution, {scene.parameters.min_revolutions}}, from_rest);
    response.audit.rest_difference = difference(response, from_rest).value;
  } catch (const RunError&) {  // nothing to compare with
  }
}

}  // namespace

SpeedResult simulate_speed(const Scene& scene, double speed, StepCheck check, const RotorState& start) {
  SpeedResult result;
  SpeedResponse& response = result.response;
  response.speed = speed;
  try {
    const RotorAtSpeed rotor = rotor_of(scene, speed);
    const std::unique_ptr<TimeMarch> march = settle_within_tolerance(scene, rotor, start, response);
    result.end = state_of(*march, rotor, scene.model);
    if (check == StepCheck::halved) check_halved_step(scene, rotor, start, response);
    check_symmetry(scene, *march, rotor, response);
    if (!start.at_rest()) compare_with_start_at_rest(scene, rotor, response);
  } catch (const RunError& error) {
    response.failure = error.what();
  }
  return result;
}

}  // namespace tiprub
