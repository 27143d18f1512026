// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/speed_run.h"

#include <cmath>
#include <sstream>

#include "cases/errors.h"
#include "simulate/recording.h"
#include "simulate/rotor_at_speed.h"
#include "simulate/steady_state.h"
#include "simulate/time_march.h"

namespace tiprub {

namespace {

constexpr double quiet_motion = 1e-3;     // of the casing's amplitude: less is no motion
constexpr double boundless_motion = 1e6;  // times amplitude and clearance: more has blown up

void require_open_at_rest(const Scene& scene, double speed) {
  const Eigen::VectorXd clearance = scene.casing.running_clearance(scene.model.contact, speed);
  Eigen::Index node = 0;
  if (clearance.minCoeff(&node) >= 0) return;
  std::ostringstream text;
  text << "spin closes the cold clearance: contact node " << node << " (from 0, leading edge first) is left with "
       << clearance[node] << " m at " << speed << " rad/s; widen [casing] clearance, or give the running one";
  throw RunError(text.str());
}

/// h < 2/omega_max, damping or not: the paper's eq. 13 damps at the middle instant.
void require_stable_step(const Scene& scene, const RotorAtSpeed& rotor, const SpeedResponse& response) {
  if (scene.parameters.scheme != Scheme::central_differences || response.step_ratio <= 1) return;
  std::ostringstream text;
  text << "central differences need h omega_max / 2 <= 1, and have " << response.step_ratio << " with "
       << response.steps_per_revolution << " steps a revolution (omega_max " << rotor.omega_max
       << " rad/s); set [simulate] steps_per_revolution to at least "
       << std::ceil(response.steps_per_revolution * response.step_ratio) << ", or scheme = \"trigonometric\"";
  throw RunError(text.str());
}

/// What the march of one speed needs to know about its settling.
struct Settling {
  const SimulateParameters& parameters;
  SteadyState state;
  double bound;  ///< [m]
  int revolutions = 0;

  void add(Eigen::VectorXd motion) {
    ++revolutions;
    if (!(motion.cwiseAbs().maxCoeff() <= bound)) {
      std::ostringstream text;
      text << "the motion grew beyond " << bound << " m in revolution " << revolutions
           << "; take smaller steps, or look at the model";
      throw RunError(text.str());
    }
    state.add(std::move(motion));
  }
  bool settled() const {
    return revolutions >= parameters.min_revolutions && state.judge().settled == SteadyVerdict::Settled::yes;
  }
};

Settling make_settling(const Scene& scene, const TimeMarch& march) {
  const double size =
      std::sqrt(static_cast<double>(march.sectors()) * march.node_count() * scene.scope.samples_per_revolution);
  const double length = scene.casing.amplitude + scene.casing.given_clearance(scene.model.contact).maxCoeff();
  return {scene.parameters,
          SteadyState(scene.parameters.settle_tolerance, quiet_motion * scene.casing.amplitude * size),
          boundless_motion * length};
}

/// Marches until the motion has settled or the allowed revolutions are spent, then records. A motion that is no
/// longer settled at the end of its recording is given more time.
void march_and_record(const Scene& scene, const RotorAtSpeed& rotor, TimeMarch& march, SpeedResponse& response) {
  const SimulateParameters& parameters = scene.parameters;
  const Recording::Grid grid{scene.scope.samples_per_revolution, parameters.recorded_revolutions,
                             parameters.casing_areas};
  const int last_start = parameters.max_revolutions - parameters.recorded_revolutions;
  Settling settling = make_settling(scene, march);
  while (true) {
    while (settling.revolutions < last_start && !settling.settled())
      settling.add(march_revolution(march, grid.samples_per_revolution));
    Recording recording(march, rotor, scene.model.contact, grid);
    for (int i = 0; i < grid.revolutions; ++i) settling.add(recording.revolution(march));
    if (!settling.settled() && settling.revolutions <= last_start) continue;
    recording.finish(march, response);
    break;
  }
  const SteadyVerdict verdict = settling.state.judge();
  response.revolutions = settling.revolutions;
  response.motion = verdict.motion;
  response.period_revolutions = verdict.period_revolutions;
  response.change = verdict.change;
  response.change_rate = verdict.rate;
  response.solver_fallbacks = march.contact().fallbacks();
}

}  // namespace

SpeedResponse simulate_speed(const Scene& scene, double speed) {
  SpeedResponse response;
  response.speed = speed;
  response.samples_per_revolution = scene.scope.samples_per_revolution;
  response.recorded_revolutions = scene.parameters.recorded_revolutions;
  try {
    const RotorAtSpeed rotor =
        rotor_at_speed(scene.model, speed, scene.scope.nodal_diameters, scene.parameters.damping_ratios);
    require_open_at_rest(scene, speed);
    response.steps_per_revolution = steps_per_revolution(scene.scope, scene.parameters, rotor.first_frequency, speed);
    TimeMarch march(
        rotor, scene.casing, scene.model.contact,
        {scene.parameters.scheme, scene.parameters.contact, response.steps_per_revolution, scene.scope.symmetry});
    response.step_ratio = march.time_step() * rotor.omega_max / 2;
    require_stable_step(scene, rotor, response);
    march_and_record(scene, rotor, march, response);
  } catch (const RunError& error) {
    response.failure = error.what();
  }
  return response;
}

}  // namespace tiprub
