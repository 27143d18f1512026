// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/speed_run.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <sstream>

#include "cases/program/errors.h"
#include "simulate/march/carried_state.h"
#include "simulate/march/integrators/penalty.h"
#include "simulate/march/rotor_at_speed.h"
#include "simulate/march/time_march.h"
#include "simulate/orbits/recording.h"
#include "simulate/orbits/settling.h"
#include "simulate/orbits/speed_audit.h"

namespace tiprub {

namespace {

constexpr double leftover_gap = 1e-9;  // of amplitude and clearance: a penetration above is no rounding
constexpr double seed_motion = 1e-3;   // of the casing's amplitude: seeds nodal diameters that symmetry keeps still
constexpr double worst_condition = 1e12;  // of W, if modes are dropped: beyond it, it has lost its rank

/// [m] of a speed in rad/s. Raises RunError if spin closes it.
Eigen::VectorXd open_clearance(const Scene& scene, double speed) {
  Eigen::VectorXd clearance = scene.casing.running_clearance(scene.model.contact, speed);
  Eigen::Index node = 0;
  if (clearance.minCoeff(&node) >= 0) return clearance;
  std::ostringstream text;
  text << "spin closes the cold clearance: contact node " << node << " (from 0, leading edge first) is left with "
       << clearance[node] << " m at " << speed << " rad/s; widen [casing] clearance, or give the running one";
  throw RunError(text.str());
}

/// h < 2/omega_max, damping or not: the paper's eq. 13 damps at the middle instant. `omega_max` includes the springs
/// of a penalty.
void require_stable_step(const SimulateParameters& parameters, double omega_max, const SpeedResponse& response) {
  const bool penalty = parameters.scheme == Scheme::penalty;
  if ((!penalty && parameters.scheme != Scheme::central_differences) || response.step_ratio <= 1) return;
  std::ostringstream text;
  text << "central differences need h omega_max / 2 <= 1, and have " << response.step_ratio << " with "
       << response.steps_per_revolution << " steps a revolution (omega_max " << omega_max << " rad/s"
       << (penalty ? ", the penalty's springs included" : "") << "); set [simulate] steps_per_revolution to at least "
       << std::ceil(response.steps_per_revolution * response.step_ratio)
       << (penalty ? ", a lower penalty_stiffness" : "") << ", or scheme = \"trigonometric\"";
  throw RunError(text.str());
}

/// With fewer modes than closed nodes, no force can close them all, and small errors meet huge ones.
void require_full_rank(const Scene& scene, const RotorAtSpeed& rotor, double condition) {
  const bool dropped =
      scene.parameters.scheme != Scheme::residual_flexibility && rotor.waves[0].residual_compliance.size();
  if (!dropped || scene.parameters.scheme == Scheme::penalty || condition < worst_condition) return;
  std::ostringstream text;
  text << "the contact compliance has condition " << condition << ", at most " << worst_condition
       << " is allowed: " << scene.parameters.modes << " modes a nodal diameter can't move "
       << scene.model.contact.size()
       << " contact nodes independently; raise [simulate] modes, or set scheme = \"residual_flexibility\"";
  throw RunError(text.str());
}

ModeChoice mode_choice(const SimulateParameters& parameters) {
  return {parameters.modes, parameters.scheme == Scheme::residual_flexibility ? ModeChoice::Others::quasi_static
                                                                              : ModeChoice::Others::dropped};
}

/// All nodal diameters from exact symmetry stay in it for hundreds of revolutions, stable or not: those that the
/// casing's orders can't move get a small start.
void seed_excluded_diameters(const Scene& scene, const RotorAtSpeed& rotor, TimeMarch& march) {
  const int symmetry = std::gcd(scene.model.sector_count, scene.casing.lobes);
  for (std::size_t i = 0; i < rotor.waves.size(); ++i) {
    const WaveModes& wave = rotor.waves[i];
    if (wave.nodal_diameter % symmetry == 0) continue;
    const double unit = wave.normal_rows.col(0).cwiseAbs().maxCoeff();
    if (!(unit > 0)) continue;
    Eigen::VectorXcd q = Eigen::VectorXcd::Zero(wave.omega.size());
    q[0] = seed_motion * scene.casing.amplitude / unit;
    march.set_state(i, q, q);
  }
}

/// As many revolutions as are worth keeping: one period of a settled motion, else what was asked for.
int revolutions_to_record(const SimulateParameters& parameters, const SettlingState& state) {
  const bool settled = state.settled == SettlingState::Settled::yes;
  return settled ? std::min(state.period_revolutions, parameters.recorded_revolutions)
                 : parameters.recorded_revolutions;
}

/// Marches until the motion has settled or the allowed revolutions are spent, then records. A motion that is no
/// longer settled, or of another period, at the end of its recording is given more time.
void march_and_record(const Scene& scene, const RotorAtSpeed& rotor, TimeMarch& march, SpeedResponse& response) {
  const SimulateParameters& parameters = scene.parameters;
  Recording::Grid grid{scene.scope.samples_per_revolution, 0, parameters.casing_areas,
                       leftover_gap * length_scale(scene)};
  const int last_start = parameters.max_revolutions - parameters.recorded_revolutions;
  Settling settling(scene, march);
  while (true) {
    while (settling.revolutions() < last_start && !settling.settled()) settling.advance();
    grid.revolutions =
        settling.settled() ? revolutions_to_record(parameters, settling.state()) : parameters.recorded_revolutions;
    Recording recording(march, rotor, scene.model.contact, grid);
    for (int i = 0; i < grid.revolutions; ++i) settling.add(recording.revolution(march));
    const bool same = settling.settled() && revolutions_to_record(parameters, settling.state()) <= grid.revolutions;
    if (!same && settling.revolutions() <= last_start) continue;
    recording.finish(march, response);
    break;
  }
  const SettlingState state = settling.state();
  response.recorded_revolutions = grid.revolutions;
  response.audit.acceleration = settling.acceleration();
  response.revolutions = settling.revolutions() + static_cast<int>(settling.acceleration().revolutions);
  response.motion = state.motion;
  response.period_revolutions = state.period_revolutions;
  response.change = state.change;
  response.change_rate = state.rate;
  response.solver_fallbacks = march.contact().fallbacks();
}

/// One march at one speed, with all that it hangs on.
struct Marched {
  std::unique_ptr<RotorAtSpeed> rotor;
  std::unique_ptr<TimeMarch> march;
};

void start_march(const Scene& scene, const RotorState& start, const RotorAtSpeed& rotor, TimeMarch& march) {
  if (!start.at_rest()) {
    put_state(start, rotor, scene.model, march);
    march.set_step(march.steps_per_revolution() *
                   static_cast<std::int64_t>(std::ceil(scene.casing.ramp_revolutions)));
  } else if (scene.parameters.nodal_diameters == DiameterChoice::all) {
    seed_excluded_diameters(scene, rotor, march);
  }
}

/// Raises RunError with the reason of a failure.
Marched settle(const Scene& scene, const RotorState& start, int step_factor, SpeedResponse& response) {
  const SimulateParameters& parameters = scene.parameters;
  response.samples_per_revolution = scene.scope.samples_per_revolution;
  response.recorded_revolutions = parameters.recorded_revolutions;
  Marched marched;
  marched.rotor = std::make_unique<RotorAtSpeed>(rotor_at_speed(
      scene.model, response.speed, scene.scope.nodal_diameters, parameters.damping_ratios, mode_choice(parameters)));
  response.clearance = open_clearance(scene, response.speed);
  response.steps_per_revolution =
      step_factor * steps_per_revolution(scene.scope, parameters, marched.rotor->first_frequency, response.speed);
  const double stiffness = parameters.penalty_stiffness * marched.rotor->tip_stiffness;
  marched.march =
      std::make_unique<TimeMarch>(*marched.rotor, scene.casing, scene.model.contact, response.clearance,
                                  MarchSetup{parameters.scheme, parameters.contact, response.steps_per_revolution,
                                             scene.scope.symmetry, parameters.theta, stiffness});
  const double omega_max = parameters.scheme == Scheme::penalty ? penalised_omega_max(*marched.rotor, stiffness)
                                                                : marched.rotor->omega_max;
  response.step_ratio = marched.march->time_step() * omega_max / 2;
  require_stable_step(parameters, omega_max, response);
  response.audit.compliance_condition = compliance_condition(*marched.march);
  require_full_rank(scene, *marched.rotor, response.audit.compliance_condition);
  start_march(scene, start, *marched.rotor, *marched.march);
  march_and_record(scene, *marched.rotor, *marched.march, response);
  return marched;
}

void check_halved_step(const Scene& scene, const RotorState& start, SpeedResponse& response) {
  SpeedResponse halved;
  halved.speed = response.speed;
  try {
    settle(scene, start, 2, halved);
    const ResponseDifference found = difference(response, halved);
    response.audit.halving_difference = found.value;
    response.audit.halving_measure = found.measure;
  } catch (const RunError& error) {
    response.audit.halving_measure = error.what();
  }
}

void check_symmetry(const Scene& scene, const Marched& marched, SpeedResponse& response) {
  SpeedAudit& audit = response.audit;
  if (marched.rotor->others.empty()) return;
  audit.symmetry = SymmetryVerdict::unchecked;
  if (scene.parameters.symmetry_check_revolutions == 0 || response.displacement.isZero(0)) return;
  try {
    audit.excluded_growth = excluded_growth(*marched.march, *marched.rotor, scene.casing, scene.model.contact,
                                            scene.parameters.symmetry_check_revolutions);
    audit.symmetry = *audit.excluded_growth > growth_limit ? SymmetryVerdict::breaking : SymmetryVerdict::holds;
  } catch (const RunError&) {  // the whole wheel's contact problem failed: unchecked
  }
}

void compare_with_start_at_rest(const Scene& scene, SpeedResponse& response) {
  SpeedResponse from_rest;
  from_rest.speed = response.speed;
  try {
    settle(scene, {}, 1, from_rest);
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
    const Marched marched = settle(scene, start, 1, response);
    result.end = state_of(*marched.march, *marched.rotor, scene.model);
    if (check == StepCheck::halved) check_halved_step(scene, start, response);
    check_symmetry(scene, marched, response);
    if (!start.at_rest()) compare_with_start_at_rest(scene, response);
  } catch (const RunError& error) {
    response.failure = error.what();
  }
  return result;
}

}  // namespace tiprub
