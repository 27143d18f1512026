// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/trial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "simulate/march/time_march.h"
#include "simulate/motion/attempt.h"
#include "simulate/scene/scene.h"
#include "tests/simulate/compared_responses.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate::testing {

namespace {

constexpr double inaccurate = 5e-2;  // relative error from which on a stable run is of no use
constexpr int reference_steps = 15360;
constexpr double chattering = 5e-2;  // share of the mean square above the resolved frequency
constexpr int revolutions_beyond = 20;
constexpr double far = 1e3, farther = 1e9;  // clearances and amplitudes: growth is measured from one to the other

/// Marched without a question. e-folds a step if it grows; infinite if it is beyond all numbers before that is seen.
double growth_beyond(const Trial& trial) {
  const BenchWheel& wheel = trial.wheel;
  const SimulateParameters& parameters = trial.parameters;
  const SceneScope scope = find_scope(wheel.model.sector_count, wheel.casing.lobes, parameters);
  const ModeChoice modes{parameters.modes, parameters.scheme == Scheme::residual_flexibility
                                               ? ModeChoice::Others::quasi_static
                                               : ModeChoice::Others::dropped};
  const RotorAtSpeed rotor =
      rotor_at_speed(wheel.model, wheel.speed, scope.nodal_diameters, parameters.damping, modes);
  TimeMarch march = march_of(rotor, wheel.casing, wheel.model.contact,
                             wheel.casing.running_clearance(wheel.model.contact, wheel.speed),
                             {parameters.scheme, parameters.contact, parameters.steps_per_revolution, scope.symmetry,
                              parameters.theta, parameters.penalty_stiffness * rotor.tip_stiffness});
  const double scale = wheel.casing.amplitude + std::abs(wheel.casing.clearance[0][1]);
  double motion_far = 0;
  std::int64_t step_far = 0;
  while (march.step_count() < std::int64_t{revolutions_beyond} * parameters.steps_per_revolution) {
    march.step();
    const double motion = march.displacement().cwiseAbs().maxCoeff<Eigen::PropagateNaN>() / scale;
    if (!std::isfinite(motion)) return std::numeric_limits<double>::infinity();
    if (motion_far == 0 && motion > far) {
      motion_far = motion;
      step_far = march.step_count();
    }
    if (motion_far > 0 && motion > std::max(farther, 2 * motion_far))
      return std::log(motion / motion_far) / static_cast<double>(march.step_count() - step_far);
  }
  return 0;
}

std::string first_words(const std::string& text) {
  return text.substr(0, std::min(text.find_first_of(";("), text.size()));
}

Verdict beyond(const Trial& trial, const std::string& reason) {
  try {
    const double rate = growth_beyond(trial);
    return {rate > 0 ? Outcome::refused_grows : Outcome::refused_bounded, rate, first_words(reason)};
  } catch (const NoMotion& error) {
    return {Outcome::refused, 0, first_words(error.what())};
  }
}

/// A theta below 1/2, that tiprub-simulate doesn't read, as if it were refused at the march.
std::string refused_key(const SimulateParameters& parameters) {
  return parameters.scheme == Scheme::moreau_jean && parameters.theta < 0.5 ? "moreau_jean_theta is below 0.5" : "";
}

const SpeedResponse& reference_of(const Trial& trial, Reference& reference) {
  if (reference && !trial.own_reference) return *reference;
  SimulateParameters fine = bench_parameters(trial.wheel, {20, 60, 6, 1e-4});
  fine.resolved_frequency = trial.parameters.resolved_frequency;
  fine.steps_per_revolution = reference_steps;
  reference = run_speed(trial.wheel, fine, trial.wheel.speed);
  return *reference;
}

std::string note_of(const SpeedResponse& at) {
  std::ostringstream text;
  text.precision(2);
  if (at.audit.tension_share > 0) text << "pulls " << 100 * at.audit.tension_share << " % of the force";
  if (at.contact_steps == 0) text << "no contact";
  if (!at.settled()) text << (text.str().empty() ? "" : ", ") << "not settled";
  return text.str();
}

}  // namespace

const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::stable:
      return "stable";
    case Outcome::inaccurate:
      return "inaccurate";
    case Outcome::chatters:
      return "chatters";
    case Outcome::grows:
      return "grows";
    case Outcome::refused_grows:
      return "refused_grows";
    case Outcome::refused_bounded:
      return "refused_bounded";
    case Outcome::refused:
      return "refused";
  }
  return "";
}

Verdict try_out(const Trial& trial, Reference& reference) {
  const std::string key = refused_key(trial.parameters);
  if (!key.empty()) return beyond(trial, key);
  const SpeedResponse at = run_speed(trial.wheel, trial.parameters, trial.wheel.speed);
  if (at.failure.find("grew beyond") != std::string::npos)
    return {Outcome::grows, growth_beyond(trial), first_words(at.failure)};
  if (!at.failure.empty()) return beyond(trial, at.failure);
  const SpeedResponse& fine = reference_of(trial, reference);
  if (!fine.failure.empty()) return {Outcome::inaccurate, std::numeric_limits<double>::quiet_NaN(), fine.failure};
  const double error = difference(at, fine, trial.wheel.casing.lobes).value;
  const bool chatters = at.chatter > chattering && at.chatter > 2 * fine.chatter;
  return {error <= inaccurate ? Outcome::stable
          : chatters          ? Outcome::chatters
                              : Outcome::inaccurate,
          error, note_of(at)};
}

}  // namespace tiprub::simulate::testing
