// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/speed/examination.h"

#include <utility>

#include "simulate/march/march_state.h"

namespace tiprub {

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
OtherStart compared(Start start, const Attempt<SettledMotion>& other, const SettledMotion& found, int lobes) {
  OtherStart compared;
  compared.start = start;
  compared.failure = other.failure;
  if (!other.result) return compared;
  const SampledMotion here = found.sampled(), there = other.result->sampled();
  compared.amplitude = other.result->recorded.amplitude;
  compared.motion = other.result->reading.motion;
  compared.period_beats = other.result->reading.period_beats;
  const bool comparable = here.samples_per_revolution == there.samples_per_revolution &&
                          here.displacement.cols() == there.displacement.cols();
  if (comparable) compared.difference = difference(there, here, lobes).value;
  return compared;
}

}  // namespace

std::vector<OtherStart> other_starts(const Scene& scene, const SharedRotor& rotor, const RotorState& end,
                                     const SettledMotion& found, SymmetryVerdict symmetry) {
  const int lobes = scene.casing.lobes, steps = found.march->steps_per_revolution();
  std::vector<OtherStart> starts;
  for (const auto& [start, speed] : {std::pair(Start::up, rotor->speed * (1 - neighbour)),
                                     std::pair(Start::down, rotor->speed * (1 + neighbour))}) {
    const auto other = attempt([&, at = speed] { return settled_from(scene, rotor, state_at(scene, at), steps); });
    starts.push_back(compared(start, other, found, lobes));
  }
  const auto swung = attempt([&] { return settled_from(scene, rotor, disturbed(end), steps); });
  starts.push_back(compared(Start::disturbed, swung, found, lobes));
  if (symmetry != SymmetryVerdict::breaking && symmetry != SymmetryVerdict::undecided) return starts;
  const auto whole = attempt([&] { return of_whole_wheel(scene, rotor->speed, steps); });
  starts.push_back(compared(Start::whole_wheel, whole, found, lobes));
  return starts;
}

Attempt<MotionDifference> halved_step(const Scene& scene, const SharedRotor& rotor, const RotorState& end,
                                      const SettledMotion& found) {
  return attempt([&] {
    const SettledMotion halved = settled_from(scene, rotor, end, 2 * found.march->steps_per_revolution());
    return difference(found.sampled(), halved.sampled(), scene.casing.lobes);
  });
}

}  // namespace tiprub
