// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/trial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

#include "simulate/march/time_march.h"
#include "simulate/motion/attempt.h"
#include "simulate/scene/friction_limit.h"
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

/// Of the motion along the normal about its mean, of all sectors, at the node that moves most.
struct Statistics {
  double rms = 0;   ///< [m]
  double high = 0;  ///< [m] which 99 % of the motion does not reach
};

Statistics statistics(const SpeedResponse& at, const ContactLine& tips) {
  constexpr double share = 0.99;
  const Eigen::Index nodes = tips.size(), sectors = at.displacement.cols() / (3 * nodes);
  Statistics most;
  for (Eigen::Index k = 0; k < nodes; ++k) {
    Eigen::MatrixXd motion(at.displacement.rows(), sectors);
    for (Eigen::Index j = 0; j < sectors; ++j)
      motion.col(j) = at.displacement.middleCols<3>(3 * (j * nodes + k)) * tips.normal.row(k).transpose();
    motion.rowwise() -= motion.colwise().mean().eval();
    const double rms = std::sqrt(motion.cwiseAbs2().mean());
    if (rms <= most.rms) continue;
    Eigen::VectorXd magnitude = motion.cwiseAbs().reshaped();
    double* const high = magnitude.data() + static_cast<Eigen::Index>(share * static_cast<double>(magnitude.size()));
    std::nth_element(magnitude.data(), high, magnitude.data() + magnitude.size());
    most = {rms, *high};
  }
  return most;
}

double error_of(const SpeedResponse& at, const SpeedResponse& fine, const BenchWheel& wheel) {
  if (repeats(at.motion) && repeats(fine.motion)) return difference(at, fine, wheel.casing.lobes).value;
  const Statistics here = statistics(at, wheel.model.contact), there = statistics(fine, wheel.model.contact);
  return std::max(std::abs(here.rms / there.rms - 1), std::abs(here.high / there.high - 1));
}

/// Marched without a question. e-folds a step if it grows; infinite if it is beyond all numbers before that is seen.
double growth_beyond(const Trial& trial) {
  const BenchWheel& wheel = trial.wheel;
  const SimulateParameters& parameters = trial.parameters;
  const SceneScope scope = find_scope(wheel.model.sector_count, wheel.casing.lobes, parameters);
  const ModeChoice modes{parameters.modes,
                         parameters.scheme == Scheme::residual_flexibility ? ModeChoice::Others::quasi_static
                                                                           : ModeChoice::Others::dropped,
                         parameters.resolved_frequency};
  const RotorAtSpeed rotor =
      rotor_at_speed(wheel.model, wheel.speed, scope.nodal_diameters, parameters.damping, modes);
  MarchSetup setup{parameters.scheme, parameters.contact, parameters.steps_per_revolution,
                   scope.symmetry,    parameters.theta,   parameters.penalty_stiffness * rotor.tip_stiffness};
  if (wheel.casing.has_friction()) setup.friction = wheel.casing.friction_at(wheel.model.contact);
  TimeMarch march = march_of(rotor, wheel.casing, wheel.model.contact,
                             wheel.casing.running_clearance(wheel.model.contact, wheel.speed), setup);
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

/// A theta below 1/2, and friction that jams, which tiprub-simulate doesn't read, as if refused at the march.
std::string refused_key(const Trial& trial) {
  if (trial.parameters.scheme == Scheme::moreau_jean && trial.parameters.theta < 0.5)
    return "moreau_jean_theta is below 0.5";
  const BenchWheel& wheel = trial.wheel;
  if (!wheel.casing.has_friction()) return "";
  const FrictionLimit limit = friction_limit(wheel.model);
  return wheel.casing.friction_at(wheel.model.contact).maxCoeff() >= limit.coefficient ? limit.text() : "";
}

const SpeedResponse& reference_of(const Trial& trial, Reference& reference) {
  if (reference && !trial.own_reference) return *reference;
  SimulateParameters fine = bench_parameters(trial.wheel, patience);
  fine.resolved_frequency = trial.parameters.resolved_frequency;
  fine.steps_per_revolution = reference_steps;
  reference = run_speed(trial.wheel, fine, trial.wheel.speed);
  return *reference;
}

std::string note_of(const SpeedResponse& at) {
  std::ostringstream text;
  text.precision(2);
  if (at.tension_share > 0) text << "pulls " << 100 * at.tension_share << " % of the force";
  if (at.contact_steps == 0) text << "no contact";
  if (!repeats(at.motion)) text << (text.str().empty() ? "" : ", ") << name_of(at.motion);
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
    case Outcome::periodic:
      return "periodic";
    case Outcome::subharmonic:
      return "subharmonic";
    case Outcome::modulated:
      return "modulated";
    case Outcome::broadband:
      return "broadband";
    case Outcome::not_settled:
      return "not_settled";
  }
  return "";
}

Verdict try_out(const Trial& trial, Reference& reference) {
  const std::string key = refused_key(trial);
  if (!key.empty()) return beyond(trial, key);
  const SpeedResponse at = run_speed(trial.wheel, trial.parameters, trial.wheel.speed);
  if (at.failure.find("grew beyond") != std::string::npos)
    return {Outcome::grows, growth_beyond(trial), first_words(at.failure)};
  if (!at.failure.empty()) return beyond(trial, at.failure);
  const SpeedResponse& fine = reference_of(trial, reference);
  if (!fine.failure.empty()) return {Outcome::inaccurate, std::numeric_limits<double>::quiet_NaN(), fine.failure};
  const double error = error_of(at, fine, trial.wheel);
  const bool chatters = at.chatter > chattering && at.chatter > 2 * fine.chatter;
  return {error <= inaccurate ? Outcome::stable
          : chatters          ? Outcome::chatters
                              : Outcome::inaccurate,
          error, note_of(at)};
}

Verdict classify(const Trial& trial) {
  const SpeedResponse at = run_speed(trial.wheel, trial.parameters, trial.wheel.speed);
  if (!at.failure.empty()) return beyond(trial, at.failure);
  static const std::map<MotionClass, Outcome> classes = {{MotionClass::periodic, Outcome::periodic},
                                                         {MotionClass::subharmonic, Outcome::subharmonic},
                                                         {MotionClass::modulated, Outcome::modulated},
                                                         {MotionClass::broadband, Outcome::broadband},
                                                         {MotionClass::not_settled, Outcome::not_settled}};
  const double high = statistics(at, trial.wheel.model.contact).high;
  return {classes.at(at.motion), high / trial.wheel.casing.clearance[0][1], note_of(at)};
}

}  // namespace tiprub::simulate::testing
