// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/periodic/orbit_search.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numeric>

#include "cases/program/errors.h"
#include "simulate/periodic/multipliers.h"

namespace tiprub {

namespace {

constexpr int tries[] = {12, 24, 48};  // revolutions after the casing has grown: contact has found its place
constexpr double newton_step = 10;     // settle_tolerances: the last one; what is left after it is a hundredth of it
constexpr double clear_distance = 5;   // uncertainties of a multiplier from 1: nearer, it is found more exactly
constexpr double close_call = 0.98;    // a multiplier a revolution: with another step it may be beyond 1
constexpr double exact = 2e-5;         // of a multiplier

/// Once roughly; more exactly where that leaves open on which side of 1 it is.
Multiplier clear_multiplier(const LinearMap& map, Eigen::Index size) {
  const Multiplier rough = largest_multiplier(map, size);
  const double distance = std::abs(std::abs(rough.value) - 1);
  return distance > clear_distance * rough.uncertainty ? rough : largest_multiplier(map, size, exact);
}

}  // namespace

bool has_symmetric_map(const Scene& scene) {
  const SimulateParameters& parameters = scene.parameters;
  return parameters.contact == ContactRule::complementarity && parameters.scheme != Scheme::moreau_jean &&
         parameters.scheme != Scheme::penalty &&
         scene.scope.symmetry == std::gcd(scene.model.sector_count, scene.casing.lobes);
}

bool OrbitSearch::approach(TimeMarch& coarse) {
  const auto grown = static_cast<std::int64_t>(std::ceil(scene_.casing.ramp_revolutions));
  try {
    for (const int revolutions : tries) {
      while (coarse.step_count() < (grown + revolutions) * coarse.steps_per_revolution()) coarse.step();
      if (jump(coarse)) return true;
      if (report_.multiplier > 0) break;  // there is one, and it repels
      report_.outcome = OrbitReport::Outcome::none;
    }
  } catch (const RunError&) {  // a step too coarse for its scheme
  }
  give_up();
  return false;
}

bool OrbitSearch::jump(TimeMarch& march) {
  if (has_given_up()) return false;
  const MarchState before(march);
  try {
    if (find(march)) return true;
  } catch (const RunError&) {  // a state that no march would come to
  }
  before.restore(march);
  give_up();
  return false;
}

bool OrbitSearch::find(TimeMarch& march) {
  MarchedMap map(march, rotor_, scene_.casing, scene_.model.contact);
  const int steps = solver_->steps();
  const NewtonLimits limits{newton_step * scene_.parameters.settle_tolerance};
  const NewtonResult orbit = find_fixed_point(map, map.symmetric().state(), limits, solver_);
  const double maps = solver_->steps() - steps + orbit.iterations + 1;
  report_.revolutions += maps / map.symmetric().maps_per_revolution();
  if (orbit.found == NewtonResult::Found::no) return false;
  const bool is_first = orbit_.size() == 0;
  if ((is_first || report_.multiplier > close_call) && !attracts(map, orbit)) return false;
  if (is_first || (excluded_ && std::abs(excluded_->factor - 1) < 1 - close_call)) follow_excluded(march, orbit);
  map.put(orbit.state);
  orbit_ = orbit.state;
  report_.outcome = OrbitReport::Outcome::found;
  report_.residual = orbit.residual;
  return true;
}

bool OrbitSearch::attracts(MarchedMap& map, const NewtonResult& orbit) {
  const int maps = map.symmetric().maps_per_revolution();
  double applied = 0;
  const LinearMap tangent = [&](const Eigen::VectorXd& change) {
    ++applied;
    return map.tangent(orbit.pattern, change);
  };
  const Multiplier largest = clear_multiplier(tangent, orbit.state.size());
  const Growth growth = per_revolution(largest, maps);
  report_.revolutions += applied / maps;
  report_.multiplier = growth.factor;
  report_.multiplier_uncertainty = growth.uncertainty;
  report_.multiplier_angle = std::abs(std::arg(largest.value));
  return growth.factor + growth.uncertainty < 1;
}

void OrbitSearch::follow_excluded(const TimeMarch& march, const NewtonResult& orbit) {
  if (rotor_.others.empty() || scene_.parameters.symmetry_check_revolutions == 0) return;
  TangentMarch tangent(rotor_, scene_.casing, scene_.model.contact, march, Disturbance::excluded);
  const LinearMap map = [&](const Eigen::VectorXd& change) { return tangent(orbit.pattern, change); };
  excluded_ = per_revolution(clear_multiplier(map, tangent.size()), tangent.maps_per_revolution());
}

double OrbitSearch::drift(TimeMarch& march) const {
  const double moved = (SymmetricMap(march, scene_.casing.lobes).state() - orbit_).norm(), size = orbit_.norm();
  return size > 0 ? moved / size : moved;  // at rest
}

void OrbitSearch::give_up() {
  report_.outcome = OrbitReport::Outcome::marched;
}

}  // namespace tiprub
