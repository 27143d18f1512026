// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/speed/speed_run.h"

#include "cases/program/errors.h"
#include "simulate/march/carried_state.h"
#include "simulate/orbits/excluded_growth.h"
#include "simulate/orbits/speed_audit.h"
#include "simulate/response/speed_group.h"
#include "simulate/speed/examination.h"
#include "simulate/speed/settled_march.h"

namespace tiprub {

namespace {

constexpr const char* not_finite =
    "the motion has numbers that are not finite: forces or displacements beyond what can be counted; look at the "
    "model's units, the damping and the casing's amplitude";

void check_symmetry(const Scene& scene, const TimeMarch& march, const RotorAtSpeed& rotor, SpeedResponse& response) {
  SpeedAudit& audit = response.audit;
  if (rotor.others.empty() || audit.excluded_growth) return;
  audit.symmetry = SymmetryVerdict::unchecked;
  if (scene.parameters.symmetry_check_revolutions == 0 || response.displacement.isZero(0)) return;
  try {
    const Growth growth = excluded_growth(march, rotor, scene.casing, scene.model.contact,
                                          response.period_revolutions, scene.parameters.symmetry_check_revolutions);
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
    settle(scene, rotor, {}, {response.steps_per_revolution, scene.parameters.min_revolutions}, from_rest);
    response.audit.rest_difference = difference(response, from_rest, scene.casing.lobes).value;
  } catch (const RunError&) {  // nothing to compare with
  }
}

void run(const Scene& scene, Depth depth, const RotorState& start, SpeedResult& result) {
  SpeedResponse& response = result.response;
  if (depth == Depth::scanned) {
    settle_roughly(scene, rotor_of(scene, response.speed, OtherDiameters::unknown), response);
    return;
  }
  const RotorAtSpeed rotor = rotor_of(scene, response.speed);
  const CycleChoice cycle = depth == Depth::examined ? CycleChoice::kept : CycleChoice::left;
  const std::unique_ptr<TimeMarch> march = settle_within_tolerance(scene, rotor, start, cycle, response);
  result.end = state_of(*march, rotor, scene.model);
  check_symmetry(scene, *march, rotor, response);
  if (!start.at_rest()) compare_with_start_at_rest(scene, rotor, response);
  if (depth == Depth::examined) examine(scene, rotor, result.end, response);
}

}  // namespace

SpeedResult simulate_speed(const Scene& scene, double speed, Depth depth, const RotorState& start) {
  SpeedResult result;
  result.response.speed = speed;
  std::string failure;
  try {
    run(scene, depth, start, result);
    if (!is_finite(result.response)) failure = not_finite;
  } catch (const RunError& error) {
    failure = error.what();
  }
  if (!is_finite(result.response)) {
    result = {};
    result.response.speed = speed;
  }
  result.response.failure = failure;
  result.response.depth = depth;
  return result;
}

}  // namespace tiprub
