// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/speed/settled_march.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "cases/program/errors.h"
#include "simulate/march/carried_state.h"
#include "simulate/march/integrators/penalty.h"
#include "simulate/orbits/recording.h"
#include "simulate/orbits/settling.h"
#include "simulate/orbits/speed_audit.h"

namespace tiprub {

namespace {

constexpr double leftover_gap = 1e-9;  // of amplitude and clearance: a penetration above is no rounding
constexpr double seed_motion = 1e-3;   // of the casing's amplitude: seeds nodal diameters that symmetry keeps still
constexpr double worst_condition = 1e12;  // of W, if modes are dropped: beyond it, it has lost its rank
constexpr std::size_t most_halvings = 10;
constexpr int most_steps_to_halve = 1 << 23;  // a revolution: with the step halved once more it takes a minute
constexpr int longest_cycle = 2;              // revolutions of a motion that doesn't settle, whose states are kept
constexpr double coarse_steps = 100;          // a period of the lowest frequency
constexpr double coarse_settling = 1e-3;
constexpr double scatter = 1.6;            // the true error over the differences, against a closed-form impact orbit
constexpr double useless_halving = 0.9;    // of the difference before it: the error doesn't fall
constexpr int min_revolutions_again = 10;  // from a motion that has settled with twice the step

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

void report(const Settling& settling, SpeedResponse& response) {
  const SettlingState state = settling.state();
  const MotionReading reading = settling.reading();
  response.revolutions += settling.revolutions();
  response.motion = reading.motion;
  response.period_beats = reading.period_beats;
  response.off_beat_energy = reading.off_beat_energy;
  response.period_revolutions = state.period_revolutions;
  response.change = state.change;
  response.change_rate = state.rate;
}

/// As many revolutions as are worth keeping: one period of a settled motion, else what was asked for.
int revolutions_to_record(const SimulateParameters& parameters, const SettlingState& state) {
  const bool settled = state.settled == SettlingState::Settled::yes;
  return settled ? std::min(state.period_revolutions, parameters.recorded_revolutions)
                 : parameters.recorded_revolutions;
}

/// Jumps, or marches until the motion has settled or the allowed revolutions are spent.
void come_to_rest(OrbitSearch* search, int last_start, TimeMarch& march, Settling& settling) {
  if (search && search->jump(march))
    settling.stand_on_orbit(search->period_revolutions(), search->report().multiplier);
  while (settling.revolutions() < last_start && !settling.settled()) settling.advance();
}

/// Whether the revolutions just recorded bear out an orbit, if the march was put on one.
bool is_confirmed(const Scene& scene, OrbitSearch* search, TimeMarch& march, Settling& settling) {
  if (!settling.stands_on_orbit()) return true;
  const double drift = search->drift(march);
  settling.confirm_orbit(drift);
  if (drift <= scene.parameters.settle_tolerance) return true;
  search->give_up();
  settling.leave_orbit();
  return false;
}

/// Marches until the motion has settled or the allowed revolutions are spent, then records. A motion that is no
/// longer settled, or of another period, at the end of its recording is given more time.
void march_and_record(const Scene& scene, const RotorAtSpeed& rotor, TimeMarch& march, const MarchPlan& plan,
                      SpeedResponse& response) {
  const SimulateParameters& parameters = scene.parameters;
  const int last_start = parameters.max_revolutions - parameters.recorded_revolutions;
  Settling settling(scene, march, plan.min_revolutions);
  Recording::Grid grid{scene.scope.samples_per_revolution, 0, parameters.casing_areas,
                       leftover_gap * length_scale(scene), static_cast<double>(settling.highest_order())};
  while (true) {
    come_to_rest(plan.search, last_start, march, settling);
    grid.revolutions =
        settling.settled() ? revolutions_to_record(parameters, settling.state()) : parameters.recorded_revolutions;
    if (plan.cycle == CycleChoice::kept)
      grid.cycle_revolutions = settling.settled() ? grid.revolutions : longest_cycle;
    Recording recording(march, rotor, scene.model.contact, grid);
    for (int i = 0; i < grid.revolutions; ++i) settling.add(recording.revolution(march));
    if (!is_confirmed(scene, plan.search, march, settling)) continue;
    const bool same = settling.settled() && revolutions_to_record(parameters, settling.state()) <= grid.revolutions;
    if (!same && settling.revolutions() <= last_start) continue;
    recording.finish(march, response);
    break;
  }
  response.recorded_revolutions = grid.revolutions;
  report(settling, response);
  response.solver_fallbacks = march.contact().fallbacks();
}

void start_march(const Scene& scene, const RotorState& start, const RotorAtSpeed& rotor, TimeMarch& march) {
  if (!start.at_rest()) {
    put_state(start, rotor, scene.model, march);
    march.set_step(march.steps_per_revolution() *
                   static_cast<std::int64_t>(std::ceil(scene.casing.ramp_revolutions)));
  } else if (scene.parameters.nodal_diameters == DiameterChoice::all) {
    seed_excluded_diameters(scene, rotor, march);
  }
}

MarchSetup setup_of(const Scene& scene, const RotorAtSpeed& rotor, const MarchPlan& plan) {
  const SimulateParameters& parameters = scene.parameters;
  return {parameters.scheme,    parameters.contact, plan.steps_per_revolution,
          scene.scope.symmetry, parameters.theta,   parameters.penalty_stiffness * rotor.tip_stiffness};
}

/// The motion of a state with half the step, and how far the two are apart.
std::unique_ptr<TimeMarch> halve(const Scene& scene, const RotorAtSpeed& rotor, const TimeMarch& march,
                                 const MarchPlan& coarse, SpeedResponse& response) {
  SpeedResponse finer;
  finer.speed = response.speed;
  finer.revolutions = response.revolutions;
  const MarchPlan plan{2 * response.steps_per_revolution,
                       std::min(min_revolutions_again, scene.parameters.min_revolutions), coarse.cycle,
                       coarse.search};
  std::unique_ptr<TimeMarch> finer_march = settle(scene, rotor, state_of(march, rotor, scene.model), plan, finer);
  const ResponseDifference found = difference(finer, response, scene.casing.lobes);
  finer.audit.halving_difference = found.value;
  finer.audit.halving_measure = found.measure;
  response = std::move(finer);
  return finer_march;
}

/// Through impacts the error is of first order, and its differences scatter: a small one counts only as far as half
/// of the one before, a quarter of the one before that, ... are small as well.
bool is_small(const std::vector<double>& differences, double tolerance) {
  double error = 0;
  for (const double difference : differences) error = std::max(difference, error / 2);
  return scatter * error <= tolerance;
}

/// Whether half the step can be counted, and isn't lost in rounding: velocities are differences of positions, which
/// are good to their last digit.
bool can_halve(const TimeMarch& march, const RotorAtSpeed& rotor, double tolerance) {
  const double angle = std::numbers::pi * rotor.first_frequency * march.time_step();  // of half a step
  return march.steps_per_revolution() <= most_steps_to_halve &&
         std::numeric_limits<double>::epsilon() <= tolerance * angle * angle;
}

/// Two halvings after which the differences stand where they were.
bool is_useless(const std::vector<double>& differences) {
  const std::size_t count = differences.size();
  return count > 2 && differences[count - 1] > useless_halving * differences[count - 2] &&
         differences[count - 2] > useless_halving * differences[count - 3];
}

/// An orbit that a march from rest is on its way to, found with a coarse step, as a state to start from; at rest if
/// there is none. `search` knows then, and is empty where nothing is to be looked for.
RotorState approach(const Scene& scene, const RotorAtSpeed& rotor, double speed, std::optional<OrbitSearch>& search) {
  if (scene.parameters.steady_state != SteadyStateMethod::orbit || !has_symmetric_map(scene)) return {};
  SimulateParameters parameters = scene.parameters;
  parameters.steps_per_period = std::min(parameters.steps_per_period, coarse_steps);
  const int steps = steps_per_revolution(scene.scope, parameters, rotor.first_frequency, speed);
  TimeMarch march(rotor, scene.casing, scene.model.contact, open_clearance(scene, speed),
                  setup_of(scene, rotor, {steps}));
  search.emplace(scene, rotor);
  return search->approach(march) ? state_of(march, rotor, scene.model) : RotorState{};
}

void report(const OrbitSearch& search, SpeedAudit& audit) {
  audit.orbit = search.report();
  if (audit.orbit.outcome != OrbitReport::Outcome::found || !search.excluded()) return;
  audit.excluded_growth = search.excluded()->factor;
  audit.excluded_growth_uncertainty = search.excluded()->uncertainty;
  audit.symmetry = judge(*search.excluded());
}

/// Halves the step until the tolerance is met.
std::unique_ptr<TimeMarch> refine(const Scene& scene, const RotorAtSpeed& rotor, const MarchPlan& plan,
                                  std::unique_ptr<TimeMarch> march, SpeedResponse& response) {
  std::vector<double> found;
  while (found.size() < most_halvings && can_halve(*march, rotor, scene.parameters.step_tolerance)) {
    march = halve(scene, rotor, *march, plan, response);
    found.push_back(*response.audit.halving_difference);
    if (!response.settled() || is_small(found, scene.parameters.step_tolerance) || is_useless(found)) break;
  }
  return march;
}

}  // namespace

Eigen::VectorXd open_clearance(const Scene& scene, double speed) {
  Eigen::VectorXd clearance = scene.casing.running_clearance(scene.model.contact, speed);
  Eigen::Index node = 0;
  if (clearance.minCoeff(&node) >= 0) return clearance;
  std::ostringstream text;
  text << "spin closes the clearance: contact node " << node << " (from 0, leading edge first"
       << (node > scene.model.contact.trailing_edge() ? "; on the splitter" : "") << ") is left with "
       << clearance[node] << " m at " << speed << " rad/s; widen [casing] clearance, or give the running one";
  throw RunError(text.str());
}

RotorAtSpeed rotor_of(const Scene& scene, double speed, OtherDiameters others) {
  return rotor_at_speed(scene.model, speed, scene.scope.nodal_diameters, scene.parameters.damping,
                        mode_choice(scene.parameters), others);
}

std::unique_ptr<TimeMarch> settle(const Scene& scene, const RotorAtSpeed& rotor, const RotorState& start,
                                  const MarchPlan& plan, SpeedResponse& response) {
  const SimulateParameters& parameters = scene.parameters;
  response.samples_per_revolution = scene.scope.samples_per_revolution;
  response.recorded_revolutions = parameters.recorded_revolutions;
  response.steps_per_revolution = plan.steps_per_revolution;
  response.clearance = open_clearance(scene, response.speed);
  const MarchSetup setup = setup_of(scene, rotor, plan);
  auto march = std::make_unique<TimeMarch>(rotor, scene.casing, scene.model.contact, response.clearance, setup);
  const double omega_max =
      parameters.scheme == Scheme::penalty ? penalised_omega_max(rotor, setup.penalty_stiffness) : rotor.omega_max;
  response.step_ratio = march->time_step() * omega_max / 2;
  require_stable_step(parameters, omega_max, response);
  response.audit.compliance_condition = compliance_condition(*march);
  require_full_rank(scene, rotor, response.audit.compliance_condition);
  start_march(scene, start, rotor, *march);
  march_and_record(scene, rotor, *march, plan, response);
  return march;
}

std::unique_ptr<TimeMarch> settle_within_tolerance(const Scene& scene, const RotorAtSpeed& rotor,
                                                   const RotorState& start, CycleChoice cycle,
                                                   SpeedResponse& response) {
  const SimulateParameters& parameters = scene.parameters;
  std::optional<OrbitSearch> search;
  RotorState orbit;
  if (start.at_rest()) orbit = approach(scene, rotor, response.speed, search);
  const MarchPlan plan{steps_per_revolution(scene.scope, parameters, rotor.first_frequency, response.speed),
                       parameters.min_revolutions, cycle, search ? &*search : nullptr};
  const SpeedResponse blank = response;
  const auto run = [&](const RotorState& from) {
    response = blank;
    std::unique_ptr<TimeMarch> march = settle(scene, rotor, from, plan, response);
    const bool halves = parameters.steps_per_revolution == 0;
    return halves ? refine(scene, rotor, plan, std::move(march), response) : std::move(march);
  };
  std::unique_ptr<TimeMarch> march = run(orbit.at_rest() ? start : orbit);
  if (!orbit.at_rest() && !search->stands(*march)) march = run(start);
  if (search) report(*search, response.audit);
  return march;
}

std::unique_ptr<TimeMarch> settle_roughly(const Scene& scene, const RotorAtSpeed& rotor, SpeedResponse& response) {
  SimulateParameters parameters = scene.parameters;
  parameters.steps_per_period = std::min(parameters.steps_per_period, coarse_steps);
  parameters.settle_tolerance = std::max(parameters.settle_tolerance, coarse_settling);
  const Scene coarse{scene.model, scene.casing, parameters, scene.scope};
  std::optional<OrbitSearch> search;
  const RotorState orbit = approach(coarse, rotor, response.speed, search);
  const MarchPlan plan{steps_per_revolution(scene.scope, parameters, rotor.first_frequency, response.speed),
                       std::min(min_revolutions_again, parameters.min_revolutions), CycleChoice::left,
                       search ? &*search : nullptr};
  return settle(coarse, rotor, orbit, plan, response);
}

}  // namespace tiprub
