// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/speed/speed_run.h"

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "simulate/march/march_state.h"
#include "simulate/motion/attempt.h"
#include "simulate/orbits/excluded_growth.h"
#include "simulate/response/response_groups.h"
#include "simulate/speed/error_budget.h"
#include "simulate/speed/settled_march.h"

namespace tiprub::simulate {

namespace {

constexpr double neighbour = 0.01;  // of the speed, to each side
constexpr double disturbance = 2;   // times the displacement

SettledMotion settled_from(const Scene& scene, const SharedRotor& rotor, const RotorState& start,
                           int steps_per_revolution) {
  return settle(scene, rotor, start, {steps_per_revolution, scene.parameters.min_revolutions});
}

/// The state of the motion from rest at another speed.
RotorState state_at(const Scene& scene, double speed) {
  return state_of(*settle_roughly(scene, rotor_of(scene, speed)).march, scene.model);
}

RotorState disturbed(RotorState state) {
  for (Eigen::VectorXcd& displacement : state.displacement) displacement *= disturbance;
  return state;
}

SettledMotion of_whole_wheel(const Scene& scene, double speed, int steps_per_revolution) {
  SimulateParameters parameters = scene.parameters;
  parameters.nodal_diameters = DiameterChoice::all;
  const SceneScope scope = find_scope(scene.model.sector_count, scene.casing.lobes, parameters);
  const Scene whole{scene.model, scene.casing, parameters, scope};
  return settled_from(whole, rotor_of(whole, speed), {}, steps_per_revolution);
}

/// The motion from another start, compared with the motion found.
OtherStart compared(const Scene& scene, Start start, const Attempt<SettledMotion>& other,
                    const SettledMotion& found) {
  OtherStart compared;
  compared.start = start;
  compared.failure = other.failure;
  if (!other.result) return compared;
  const SampledMotion here = found.sampled(), there = other.result->sampled();
  compared.amplitude = other.result->recorded.amplitude;
  compared.blades = blade_excursions(there.displacement, scene.model.contact);
  compared.motion = other.result->reading.motion;
  compared.period_beats = other.result->reading.period_beats;
  const bool comparable = here.samples_per_revolution == there.samples_per_revolution &&
                          here.displacement.cols() == there.displacement.cols();
  if (comparable) compared.difference = difference(there, here, scene.casing.lobes).value;
  return compared;
}

constexpr const char* not_finite =
    "the motion has numbers that are not finite; check the units of the model, the damping and the casing's "
    "amplitude";

/// The growth of the nodal diameters that symmetry leaves out; empty if it was not computed.
std::optional<Growth> growth_of_excluded(const Scene& scene, const RefinedMotion& found) {
  if (found.excluded) return found.excluded;
  const SettledMotion& motion = found.motion;
  const int revolutions = scene.parameters.symmetry_check_revolutions, period = motion.state.period_revolutions;
  if (revolutions == 0 || motion.recorded.displacement.isZero(0)) return std::nullopt;
  const auto growth = attempt([&] {
    return period > 0 && has_symmetric_map(scene) ? excluded_growth_along(*motion.march, period, revolutions)
                                                  : excluded_growth(*motion.march, period, revolutions);
  });
  return growth.result;
}

/// Checks whether they stay small.
void check_symmetry(const Scene& scene, const RefinedMotion& found, SpeedAudit& audit) {
  if (found.motion.march->rotor().others.empty()) return;
  const std::optional<Growth> growth = growth_of_excluded(scene, found);
  audit.symmetry = growth ? judge(*growth, found.motion.state.period_revolutions) : SymmetryVerdict::unchecked;
  if (!growth) return;
  audit.excluded_growth = growth->factor;
  audit.excluded_growth_uncertainty = growth->uncertainty;
}

/// The difference of a motion from the one from rest; empty if there is none from rest.
std::optional<double> rest_difference(const Scene& scene, const SharedRotor& rotor, const SettledMotion& found) {
  const auto difference_to_rest = attempt([&] {
    const SettledMotion from_rest = settled_from(scene, rotor, {}, found.march->steps_per_revolution());
    return difference(found.sampled(), from_rest.sampled(), scene.casing.lobes).value;
  });
  return difference_to_rest.result;
}

/// The part of a motion that response.h5 keeps.
SpeedResponse response_of(SettledMotion motion) {
  SpeedResponse response;
  static_cast<RecordedMotion&>(response) = std::move(motion.recorded);
  response.steps_per_revolution = motion.march->steps_per_revolution();
  response.revolutions = motion.revolutions;
  response.motion = motion.reading.motion;
  response.period_beats = motion.reading.period_beats;
  response.off_beat_energy = motion.reading.off_beat_energy;
  response.period_revolutions = motion.state.period_revolutions;
  response.change = motion.state.change;
  response.change_rate = motion.state.rate;
  response.clearance = motion.march->scene().obstacle.clearance();
  response.step_ratio = motion.step_ratio;
  response.solver_fallbacks = motion.march->contact().fallbacks();
  response.audit.compliance_condition = motion.compliance_condition;
  return response;
}

/// The other motions of a critical speed: from the motions 1 % below ("up") and 1 % above ("down"), from its own
/// motion with twice the displacement ("disturbed"), and, where symmetry does not clearly hold, from rest with all
/// nodal diameters ("whole wheel"). Each is marched with the step of `found` and compared with its motion; `end` is
/// the last state of `found`. Costs three or four marches.
std::vector<OtherStart> other_starts(const Scene& scene, const SharedRotor& rotor, const RotorState& end,
                                     const SettledMotion& found, SymmetryVerdict symmetry, Helpers* helpers) {
  const int steps = found.march->steps_per_revolution();
  const auto from_neighbour = [&](double away) {
    return settled_from(scene, rotor, state_at(scene, rotor->speed * (1 + away)), steps);
  };
  using March = std::pair<Start, std::function<SettledMotion()>>;
  std::vector<March> marches = {
      {Start::up, [&] { return from_neighbour(-neighbour); }},
      {Start::down, [&] { return from_neighbour(neighbour); }},
      {Start::disturbed, [&] { return settled_from(scene, rotor, disturbed(end), steps); }}};
  if (symmetry == SymmetryVerdict::breaking || symmetry == SymmetryVerdict::undecided)
    marches.emplace_back(Start::whole_wheel, [&] { return of_whole_wheel(scene, rotor->speed, steps); });
  std::vector<OtherStart> starts(marches.size());
  share(helpers, marches.size(),
        [&](std::size_t i) { starts[i] = compared(scene, marches[i].first, attempt(marches[i].second), found); });
  return starts;
}

/// The change of a motion by half its step, starting from `end`; for motions whose step the case fixes.
Attempt<MotionDifference> halved_step(const Scene& scene, const SharedRotor& rotor, const RotorState& end,
                                      const SettledMotion& found) {
  return attempt([&] {
    const SettledMotion halved = settled_from(scene, rotor, end, 2 * found.march->steps_per_revolution());
    return difference(found.sampled(), halved.sampled(), scene.casing.lobes);
  });
}

SpeedResult run(const Scene& scene, double speed, Depth depth, const RotorState& start, Helpers* helpers) {
  if (depth == Depth::scanned)
    return {response_of(settle_roughly(scene, rotor_of(scene, speed, OtherDiameters::unknown))), {}};
  const bool is_examined = depth >= Depth::examined;
  const SharedRotor rotor = rotor_of(scene, speed);
  RefinedMotion found =
      settle_within_tolerance(scene, rotor, start, is_examined ? CycleChoice::kept : CycleChoice::left);
  SpeedResult result;
  result.end = state_of(*found.motion.march, scene.model);
  SpeedAudit audit;
  audit.orbit = found.orbit;
  audit.step_reached = found.step_reached;
  audit.compliance_condition = found.motion.compliance_condition;
  check_symmetry(scene, found, audit);
  if (!start.at_rest()) audit.rest_difference = rest_difference(scene, rotor, found.motion);
  Attempt<MotionDifference> halving{found.halving, ""};
  if (is_examined && !halving.result) halving = halved_step(scene, rotor, result.end, found.motion);
  audit.halving_failure = halving.failure;
  if (halving.result) {
    audit.halving_difference = halving.result->value;
    audit.halving_measure = halving.result->measure;
  }
  std::vector<OtherStart> others;
  if (is_examined) others = other_starts(scene, rotor, result.end, found.motion, audit.symmetry, helpers);
  std::vector<PeakVariation> budget;
  if (depth == Depth::budgeted) budget = error_budget(scene, speed, found.motion, helpers);
  result.response = response_of(std::move(found.motion));
  result.response.audit = std::move(audit);
  result.response.other_starts = std::move(others);
  result.response.budget = std::move(budget);
  return result;
}

}  // namespace

SpeedResult simulate_speed(const Scene& scene, double speed, Depth depth, const RotorState& start, Helpers* helpers) {
  Attempt<SpeedResult> found = attempt([&] { return run(scene, speed, depth, start, helpers); });
  if (found.result && !is_finite(found.result->response)) found = {std::nullopt, not_finite};
  SpeedResult result = found.result ? std::move(*found.result) : SpeedResult{};
  result.response.speed = speed;
  result.response.failure = found.failure;
  result.response.depth = depth;
  return result;
}

}  // namespace tiprub::simulate
