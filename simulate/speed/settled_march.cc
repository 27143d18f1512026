// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/speed/settled_march.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "cases/program/text.h"
#include "simulate/march/march_state.h"
#include "simulate/motion/attempt.h"

namespace tiprub::simulate {

namespace {

constexpr double leftover_gap = 1e-9;  // of amplitude and clearance: a larger penetration is more than rounding
constexpr double seed_motion = 1e-3;   // of the casing's amplitude: start of nodal diameters that it does not excite
constexpr double worst_condition = 1e12;  // of W, if modes are dropped: beyond it W is singular
constexpr std::size_t most_halvings = 10;
constexpr int most_steps_to_halve = 1 << 23;  // per revolution, which then takes a minute
constexpr int longest_cycle = 2;              // revolutions of a motion that does not settle
constexpr double coarse_steps = 100;          // in a period of the lowest frequency
constexpr double coarse_settling = 1e-3;
constexpr double scatter = 1.6;            // true error over difference, measured on a closed-form impact orbit
constexpr std::size_t scatter_memory = 3;  // halvings
constexpr double useless_halving = 0.9;    // of the difference before: the error does not fall
constexpr int min_revolutions_again = 10;  // when the start has settled with twice the step
constexpr double opening_settling = 0.2;   // of step_tolerance

/// h < 2/omega_max, with and without damping, because the paper's eq. 13 damps at the middle instant.
void require_stable_step(const TimeMarch& march, double omega_max) {
  const SchemeTraits traits = traits_of(march.scene().setup.scheme);
  const double step_ratio = march.time_step() * omega_max / 2;
  if (!traits.limits_step || step_ratio <= 1) return;
  throw NoMotion(text_of(traits.springs ? "the springs of the penalty" : "central differences",
                         " need h omega_max / 2 <= 1, and have ", step_ratio, " with ", march.steps_per_revolution(),
                         " steps a revolution (omega_max ", omega_max,
                         " rad/s); set [simulate] steps_per_revolution to at least ",
                         std::ceil(march.steps_per_revolution() * step_ratio),
                         (traits.springs ? ", a lower penalty_stiffness" : ""), ", or scheme = \"trigonometric\""));
}

/// With fewer modes than closed nodes no finite force can close all nodes.
void require_full_rank(const TimeMarch& march, int modes, double condition) {
  const SchemeTraits traits = traits_of(march.scene().setup.scheme);
  const bool dropped = !traits.quasi_static && march.rotor().waves[0].residual_compliance.size();
  if (!dropped || traits.springs || condition < worst_condition) return;
  throw NoMotion(
      text_of("the contact compliance has condition ", condition, ", at most ", worst_condition,
              " is allowed: ", modes, " modes a nodal diameter can't move ", march.node_count(),
              " contact nodes independently; raise [simulate] modes, or set scheme = \"residual_flexibility\""));
}

/// A march of all nodal diameters from a symmetric state stays symmetric for hundreds of revolutions, even if that
/// motion is unstable. The nodal diameters that the casing does not excite therefore get a small start.
void seed_excluded_diameters(const Scene& scene, TimeMarch& march) {
  const int symmetry = std::gcd(scene.model.sector_count, scene.casing.lobes);
  for (std::size_t i = 0; i < march.wave_count(); ++i) {
    const WaveModes& wave = march.rotor().waves[i];
    if (wave.nodal_diameter % symmetry == 0) continue;
    const double unit = wave.normal_rows.col(0).cwiseAbs().maxCoeff();
    if (!(unit > 0)) continue;
    Eigen::VectorXcd q = Eigen::VectorXcd::Zero(wave.omega.size());
    q[0] = seed_motion * scene.casing.amplitude / unit;
    march.set_state(i, q, Eigen::VectorXcd::Zero(q.size()));
  }
}

/// One period of a settled motion if it is shorter than asked for; else the revolutions asked for.
int revolutions_to_record(const SimulateParameters& parameters, const SettlingState& state) {
  return state.settled() ? std::min(state.period_revolutions, parameters.recorded_revolutions)
                         : parameters.recorded_revolutions;
}

/// Jumps to the orbit, or marches until the motion has settled or no revolutions are left.
void come_to_rest(OrbitSearch* search, int last_start, TimeMarch& march, Settling& settling) {
  if (search && search->reach(march, [&] { settling.advance(); }))
    settling.stand_on_orbit(search->period_revolutions(), search->report().multiplier);
  while (settling.revolutions() < last_start && !settling.settled() && !settling.wanders()) settling.advance();
}

/// Whether the recorded revolutions confirm the orbit onto which the march was put, if any.
bool is_confirmed(const Scene& scene, OrbitSearch* search, TimeMarch& march, Settling& settling) {
  if (!settling.stands_on_orbit()) return true;
  const double drift = search->drift(march);
  settling.confirm_orbit(drift);
  if (drift <= scene.parameters.settle_tolerance) return true;
  search->give_up();
  settling.leave_orbit();
  return false;
}

/// Marches until the motion has settled or no revolutions are left, then records. If the motion is no longer settled
/// at the end of the recording, or has another period, marching continues.
SettledMotion march_and_record(const Scene& scene, const MarchPlan& plan, std::unique_ptr<TimeMarch> march) {
  const SimulateParameters& parameters = scene.parameters;
  const int last_start = parameters.max_revolutions - parameters.recorded_revolutions;
  Settling settling(scene, *march, plan.min_revolutions, plan.start);
  Recording::Grid grid{scene.scope.samples_per_revolution, 0, parameters.casing_areas,
                       leftover_gap * length_scale(scene), static_cast<double>(settling.highest_order())};
  while (true) {
    come_to_rest(plan.search, last_start, *march, settling);
    grid.revolutions =
        settling.settled() ? revolutions_to_record(parameters, settling.state()) : parameters.recorded_revolutions;
    if (plan.cycle == CycleChoice::kept)
      grid.cycle_revolutions = settling.settled() ? grid.revolutions : longest_cycle;
    Recording recording(*march, grid);
    for (int i = 0; i < grid.revolutions; ++i) settling.add(recording.revolution());
    if (!is_confirmed(scene, plan.search, *march, settling)) continue;
    const bool same = settling.settled() && revolutions_to_record(parameters, settling.state()) <= grid.revolutions;
    if (!same && settling.revolutions() <= last_start && !settling.wanders()) continue;
    SettledMotion settled;
    settled.recorded = recording.finish();
    settled.reading = settling.reading();
    settled.state = settling.state();
    settled.revolutions = settling.revolutions();
    settled.march = std::move(march);
    return settled;
  }
}

void start_march(const Scene& scene, const RotorState& start, TimeMarch& march) {
  if (!start.at_rest()) {
    put_state(start, scene.model, march);
    march.set_step(march.steps_per_revolution() * scene.casing.grown_after());
  } else if (scene.parameters.nodal_diameters == DiameterChoice::all) {
    seed_excluded_diameters(scene, march);
  }
}

/// The same motion with half the step.
SettledMotion halved(const Scene& scene, const SettledMotion& coarse, const MarchPlan& before) {
  const MarchPlan plan{2 * coarse.march->steps_per_revolution(),
                       std::min(min_revolutions_again, scene.parameters.min_revolutions), before.cycle, before.search,
                       coarse.state.settled() ? StartMotion::unknown : StartMotion::wanders};
  SettledMotion finer = settle(scene, coarse.march->scene().rotor, state_of(*coarse.march, scene.model), plan);
  finer.revolutions += coarse.revolutions;
  return finer;
}

/// [1] With impacts the differences scatter. A small difference therefore counts only if half of the one before and a
/// quarter of the one before that are small as well. Older ones are forgotten: where a coarser step led to another
/// motion, they tell how far apart these motions are.
double estimated_error(const std::vector<double>& differences) {
  double error = 0;
  const std::size_t count = differences.size();
  for (std::size_t i = count - std::min(count, scatter_memory); i < count; ++i)
    error = std::max(differences[i], error / 2);
  return scatter * error;
}

/// Whether half the step is possible and not lost in rounding: velocities are differences of positions, which have
/// the precision of a double.
bool can_halve(const TimeMarch& march, double tolerance) {
  const double angle = std::numbers::pi * march.rotor().first_frequency * march.time_step();  // of half a step
  return march.steps_per_revolution() <= most_steps_to_halve &&
         std::numeric_limits<double>::epsilon() <= tolerance * angle * angle;
}

/// Whether two halvings in succession have hardly changed the difference.
bool is_useless(const std::vector<double>& differences) {
  const std::size_t count = differences.size();
  return count > 2 && differences[count - 1] > useless_halving * differences[count - 2] &&
         differences[count - 2] > useless_halving * differences[count - 3];
}

/// Where the case asks for orbits and they are possible.
std::optional<OrbitSearch> search_for(const Scene& scene, OrbitUse wanted) {
  if (scene.parameters.steady_state != SteadyStateMethod::orbit || !has_symmetric_map(scene)) return {};
  return OrbitSearch(scene, wanted);
}

/// The motion from rest with twice the step, in which transients and searches cost half.
SettledMotion opened(const Scene& scene, const SharedRotor& rotor, MarchPlan plan) {
  SimulateParameters parameters = scene.parameters;
  parameters.steps_per_period /= 2;
  parameters.settle_tolerance = std::max(parameters.settle_tolerance, opening_settling * parameters.step_tolerance);
  plan.steps_per_revolution = steps_per_revolution(scene.scope, parameters, rotor->first_frequency, rotor->speed);
  plan.cycle = CycleChoice::left;
  return settle({scene.model, scene.casing, parameters, scene.scope}, rotor, {}, plan);
}

/// Halves the step until it is no longer than planned and the tolerance is met.
RefinedMotion refined(const Scene& scene, const MarchPlan& plan, SettledMotion motion) {
  const double tolerance = scene.parameters.step_tolerance;
  RefinedMotion refined;
  std::vector<double> differences;
  while (motion.march->steps_per_revolution() < plan.steps_per_revolution ||
         (differences.size() < most_halvings && can_halve(*motion.march, tolerance))) {
    const bool is_opening = motion.march->steps_per_revolution() < plan.steps_per_revolution;
    SettledMotion finer = halved(scene, motion, plan);
    refined.halving = difference(finer.sampled(), motion.sampled(), scene.casing.lobes);
    differences.push_back(refined.halving->value);
    refined.step_reached = estimated_error(differences) / tolerance;
    motion = std::move(finer);
    if (!motion.state.settled() || *refined.step_reached <= 1 || is_useless(differences)) break;
    if (is_opening) differences.clear();  // a step as long as its tells little of the finer ones
  }
  refined.motion = std::move(motion);
  return refined;
}

}  // namespace

SettledMotion settle(const Scene& scene, const SharedRotor& rotor, const RotorState& start, const MarchPlan& plan) {
  auto march = std::make_unique<TimeMarch>(marched_scene(scene, rotor, plan.steps_per_revolution));
  const double omega_max = march->scene().omega_max();
  require_stable_step(*march, omega_max);
  const double condition = compliance_condition(*march);
  require_full_rank(*march, scene.parameters.modes, condition);
  start_march(scene, start, *march);
  SettledMotion settled = march_and_record(scene, plan, std::move(march));
  settled.step_ratio = settled.march->time_step() * omega_max / 2;
  settled.compliance_condition = condition;
  return settled;
}

RefinedMotion settle_within_tolerance(const Scene& scene, const SharedRotor& rotor, const RotorState& start,
                                      CycleChoice cycle) {
  const SimulateParameters& parameters = scene.parameters;
  std::optional<OrbitSearch> search = start.at_rest() ? search_for(scene, OrbitUse::motion) : std::nullopt;
  const MarchPlan plan{steps_per_revolution(scene.scope, parameters, rotor->first_frequency, rotor->speed),
                       parameters.min_revolutions, cycle, search ? &*search : nullptr};
  const auto run = [&] {
    if (parameters.steps_per_revolution > 0) return RefinedMotion{settle(scene, rotor, start, plan), {}, {}, {}, {}};
    if (start.at_rest()) {
      auto opening = attempt([&] { return opened(scene, rotor, plan); });
      if (opening.result) return refined(scene, plan, std::move(*opening.result));
      if (search) search->give_up();  // its step may be beyond the limit of the scheme
    }
    return refined(scene, plan, settle(scene, rotor, start, plan));
  };
  RefinedMotion found = run();
  if (search && search->has_found() && !search->stands(*found.motion.march)) found = run();
  if (search) found.orbit = search->report();
  if (found.orbit.outcome == OrbitReport::Outcome::found) found.excluded = search->excluded();
  return found;
}

SettledMotion settle_roughly(const Scene& scene, const SharedRotor& rotor) {
  SimulateParameters parameters = scene.parameters;
  parameters.steps_per_period = std::min(parameters.steps_per_period, coarse_steps);
  parameters.settle_tolerance = std::max(parameters.settle_tolerance, coarse_settling);
  const Scene coarse{scene.model, scene.casing, parameters, scene.scope};
  std::optional<OrbitSearch> search = search_for(coarse, OrbitUse::amplitude);
  const MarchPlan plan{steps_per_revolution(scene.scope, parameters, rotor->first_frequency, rotor->speed),
                       std::min(min_revolutions_again, parameters.min_revolutions), CycleChoice::left,
                       search ? &*search : nullptr};
  return settle(coarse, rotor, {}, plan);
}

}  // namespace tiprub::simulate
