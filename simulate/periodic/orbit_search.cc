// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/periodic/orbit_search.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <numeric>

#include "simulate/motion/attempt.h"
#include "simulate/orbits/motion_class.h"
#include "simulate/periodic/multipliers.h"

namespace tiprub::simulate {

namespace {

constexpr int tries[] = {8, 16, 32, 48};  // revolutions after the casing has grown
constexpr double come_back = 0.2;      // of the largest distance within the longest period: the march nearly returns
constexpr double returned = 1e-3;      // of the state: a settled march is this near to where it was
constexpr double resonant = 0.01;      // turns: a disturbance that misses its phase by more does not lock
constexpr int iterations_to_lock = 4;  // of Newton's method: more lead back to the repelling orbit
constexpr double same_orbit = 1e-3;    // of the state
constexpr double newton_step = 10;  // of settle_tolerance: bound of the last step, whose error is a hundredth of it
constexpr double rough = 2e-3, common = 2e-4, exact = 2e-5;  // of a multiplier

/// The growth of excluded disturbances while a pattern of contact is held.
Growth excluded_growth_held(const TimeMarch& orbit, const std::shared_ptr<const ContactPattern>& pattern, int power,
                            int revolutions) {
  TangentMarch tangent(orbit, Disturbance::excluded, power);
  const double maps = tangent.maps_per_revolution();
  const auto map = [&](const Eigen::VectorXd& change) { return tangent(pattern, change); };
  return largest_growth(map, tangent.seed(), std::max(static_cast<int>(revolutions * maps), 1), maps);
}

/// A march at the same state. What a search leaves in the solver of the contact forces changes their rounding, which
/// a motion without period amplifies: a march that is searched along stays the one that it would be.
TimeMarch copy_of(const TimeMarch& march) {
  TimeMarch copy(march.scene());
  MarchState(march).restore(copy);
  return copy;
}

/// The number of maps, at most `most`, after which a settled march is where it was.
int maps_in_period(TimeMarch& settled, int most) {
  const SymmetricMap one(settled);
  const Eigen::VectorXd start = one.state();
  const MarchState before(settled);
  int maps = 0;
  double away = 0;
  do {
    for (int i = 0; i < one.steps(); ++i) settled.step();
    ++maps;
    away = (SymmetricMap(settled, maps).image() - start).norm();
  } while (maps < most && away > returned * start.norm());
  before.restore(settled);
  return maps;
}

}  // namespace

Growth per_revolution(const Multiplier& multiplier, double maps) {
  const double magnitude = std::abs(multiplier.value), factor = std::pow(magnitude, maps);
  return {factor, magnitude > 0 ? maps * factor * multiplier.uncertainty / magnitude : multiplier.uncertainty};
}

bool has_symmetric_map(const Scene& scene) {
  return maps_states(scene.parameters.scheme, scene.parameters.contact) &&
         scene.scope.symmetry == std::gcd(scene.model.sector_count, scene.casing.lobes);
}

Growth excluded_growth_along(TimeMarch& settled, int period_revolutions, int revolutions) {
  const int maps = symmetric_maps_per_revolution(settled.sector_count(), settled.scene().obstacle.lobes());
  const int power = maps_in_period(settled, maps * period_revolutions);
  const MarchState before(settled);
  MarchedMap map(settled, power);
  const MapImage image = map.image(map.symmetric().state());
  before.restore(settled);
  return excluded_growth_held(settled, image.pattern, power, revolutions);
}

bool OrbitSearch::reach(TimeMarch& march, const std::function<void()>& revolution) {
  if (has_given_up()) return false;
  if (has_found() ? jump(march) : look_along(march, revolution)) return true;
  give_up();
  return false;
}

bool OrbitSearch::look_along(TimeMarch& coarse, const std::function<void()>& revolution) {
  const auto march_until = [&](std::int64_t revolutions) {
    const std::int64_t most = scene_.parameters.max_revolutions - scene_.parameters.recorded_revolutions;
    const std::int64_t steps =
        std::min(scene_.casing.grown_after() + revolutions, most) * coarse.steps_per_revolution();
    while (coarse.step_count() < steps) revolution();
  };
  for (const int revolutions : tries) {
    march_until(revolutions);
    if (jump(coarse)) return true;
    if (repelling_.size() > 0) break;
  }
  if (wanted_ == OrbitUse::amplitude) return false;
  march_until(std::end(tries)[-1]);
  report_.maps = recurrence(coarse);
  return report_.maps > 1 && jump(coarse);
}

bool OrbitSearch::jump(TimeMarch& march) {
  TimeMarch searched = copy_of(march);
  if (!attempt([&] { return find(searched); }).result.value_or(false)) return false;
  MarchState(searched).restore(march);
  return true;
}

/// Whether a motion may repeat after this number of maps: its whole revolutions fit into a recording, and what leaves
/// the repelling orbit of one map, if there is one, comes back to its phase.
bool OrbitSearch::may_repeat_after(int maps) const {
  if (revolutions_of(maps) > scene_.parameters.recorded_revolutions) return false;
  const double turns = maps * report_.multiplier_angle / (2 * std::numbers::pi);
  return repelling_.size() == 0 || std::abs(turns - std::round(turns)) <= resonant;
}

/// The number of maps, more than one, after which a march nearly returns and may repeat itself; else 1.
int OrbitSearch::recurrence(const TimeMarch& from) const {
  TimeMarch march = copy_of(from);
  const int lobes = scene_.casing.lobes, maps = symmetric_maps_per_revolution(march.sector_count(), lobes);
  const SymmetricMap one(march);
  const Eigen::VectorXd start = one.state();
  Eigen::ArrayXd away = Eigen::ArrayXd::Zero(ClassLimits::longest_period * maps / lobes + 1);
  for (int k = 1; k < away.size(); ++k) {
    for (int i = 0; i < one.steps(); ++i) march.step();
    away[k] = (SymmetricMap(march, k).image() - start).norm();
  }
  for (int k = 2; k < away.size(); ++k)
    if (away[k] <= come_back * away.maxCoeff() && may_repeat_after(k)) return k;
  return 1;
}

int OrbitSearch::revolutions_of(int maps) const {
  return maps / std::gcd(maps, symmetric_maps_per_revolution(scene_.model.sector_count, scene_.casing.lobes));
}

bool OrbitSearch::find(TimeMarch& march) {
  MarchedMap map(march, report_.maps);
  const bool is_first = !has_found();
  NewtonLimits limits{newton_step * scene_.parameters.settle_tolerance};
  if (is_first && report_.maps > 1) limits.iterations = iterations_to_lock;
  const NewtonResult orbit = find_fixed_point(map, map.symmetric().state(), limits);
  const double maps = map.tangents() + orbit.iterations + 1;
  report_.revolutions += maps / map.symmetric().maps_per_revolution();
  if (!orbit.found) return false;
  if (is_first && repels(map, orbit)) return false;  // stands() looks closer
  map.put(orbit.state);
  orbit_ = orbit;
  report_.outcome = OrbitReport::Outcome::found;
  report_.residual = orbit.residual;
  return true;
}

/// Remembers the orbit of one map that repels: it is one of any number of maps, too.
bool OrbitSearch::repels(MarchedMap& map, const NewtonResult& orbit) {
  if (repelling_.size() > 0 && (orbit.state - repelling_).norm() <= same_orbit * repelling_.norm()) return true;
  if (attracts(map, orbit, rough)) return false;
  repelling_ = orbit.state;
  return true;
}

bool OrbitSearch::stands(TimeMarch& march) {
  if (has_given_up()) return false;
  const auto stood = attempt([&] {
    MarchedMap map(march, report_.maps);
    const bool stands = attracts(map, orbit_, common);
    const int revolutions = scene_.parameters.symmetry_check_revolutions;
    if (stands && revolutions > 0 && !march.rotor().others.empty())
      excluded_ = excluded_growth_held(march, orbit_.pattern, report_.maps, revolutions);
    return stands;
  });
  if (stood.result.value_or(false)) return true;
  give_up();
  return false;
}

bool OrbitSearch::attracts(MarchedMap& map, const NewtonResult& orbit, double tolerance) {
  const double maps = map.symmetric().maps_per_revolution();
  double applied = 0;
  const LinearMap tangent = [&](const Eigen::VectorXd& change) {
    ++applied;
    return map.tangent(orbit.pattern, change);
  };
  const Multiplier largest = largest_multiplier(tangent, orbit.state.size(), {tolerance, exact, map.seed()});
  const Growth growth = per_revolution(largest, maps);
  report_.revolutions += applied / maps;
  report_.multiplier = growth.factor;
  report_.multiplier_uncertainty = growth.uncertainty;
  report_.multiplier_angle = std::abs(std::arg(largest.value));
  return growth.factor + growth.uncertainty < 1;
}

double OrbitSearch::drift(TimeMarch& march) const {
  const double moved = (SymmetricMap(march).state() - orbit_.state).norm(), size = orbit_.state.norm();
  return size > 0 ? moved / size : moved;  // an orbit at rest
}

}  // namespace tiprub::simulate
