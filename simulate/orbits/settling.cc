// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/settling.h"

#include <cmath>
#include <numeric>
#include <sstream>
#include <utility>

#include "cases/program/errors.h"
#include "simulate/orbits/anderson.h"
#include "simulate/orbits/recording.h"

namespace tiprub {

namespace {

constexpr double quiet_motion = 1e-3;     // of the casing's amplitude: less is no motion
constexpr double boundless_motion = 1e6;  // times amplitude and clearance: more has blown up
constexpr std::size_t remembered = 24;    // revolutions, for the class of a motion that doesn't settle
constexpr int approach = 4;               // revolutions after the casing has grown: contact has found its place
constexpr int shortest_confirmation = 14, longest_confirmation = 20;  // revolutions
constexpr double disturbance = 3;  // settle_tolerances: what the confirmation must see die out

/// The two tries: first with changes lifted (most of the modes then need no iteration: 3 .. 6 revolutions on the
/// quick impeller, but it may leap), then with the map as it is.
struct Try {
  double lift;            ///< [1] share of the lifted change; 0: the map as it is
  double residual_share;  ///< of settle_tolerance: the map's own change is that of a part of a revolution only
  int revolutions;        ///< of the map, at most
  int restarts;
};
constexpr Try tries[] = {{0.3, 1e-1, 10, 0}, {0, 1e-2, 15, 4}};
constexpr int depth = 30;     // 8 leave the many slow modes to plain iteration
constexpr int patience = 90;  // evaluations

SteadyState make_judge(const Scene& scene, const TimeMarch& march) {
  const double size =
      std::sqrt(static_cast<double>(march.sectors()) * march.node_count() * scene.scope.samples_per_revolution);
  return {scene.parameters.settle_tolerance, quiet_motion * scene.casing.amplitude * size};
}

double highest_resolved_order(const Scene& scene, const TimeMarch& march) {
  const double turns_per_second = 1 / (march.time_step() * march.steps_per_revolution());
  return scene.parameters.resolved_frequency / turns_per_second;
}

bool steady(const SteadyState& state) {
  return state.judge().settled == SettlingState::Settled::yes;
}

}  // namespace

Settling::Settling(const Scene& scene, TimeMarch& march, const SettlingPlan& plan)
    : scene_(scene),
      march_(march),
      band_(scene.scope.samples_per_revolution, highest_resolved_order(scene, march)),
      state_(make_judge(scene, march)),
      bound_(boundless_motion * length_scale(scene)),
      plan_(plan) {}

void Settling::add(Eigen::VectorXd motion) {
  ++revolutions_;
  if (!(motion.cwiseAbs().maxCoeff() <= bound_)) {
    std::ostringstream text;
    text << "the motion grew beyond " << bound_ << " m in revolution " << revolutions_
         << "; take smaller steps, or look at the model";
    throw RunError(text.str());
  }
  const Eigen::MatrixXd coefficients = band_.coefficients(motion);
  state_.add(coefficients.reshaped());
  last_.push_back(std::move(motion));
  if (last_.size() > remembered) last_.pop_front();
}

MotionReading Settling::reading() const {
  const SettlingState state = state_.judge();
  std::deque<Eigen::VectorXd> revolutions = last_;
  Change change = state_.decays() ? Change::decays : Change::stands;
  if (state.settled == SettlingState::Settled::yes) {
    change = Change::settled;
    while (static_cast<int>(revolutions.size()) > state.period_revolutions) revolutions.pop_front();
  }
  return read_motion(revolutions, march_.displacement().size(), band_.orders(), scene_.casing.lobes, change);
}

bool Settling::settled() const {
  return revolutions_ >= plan_.min_revolutions && steady(state_);
}

void Settling::advance() {
  if (should_jump())
    jump();
  else
    add(march_revolution(march_, scene_.scope.samples_per_revolution));
}

/// All nodal diameters of a scene that needs only some: what breaks the symmetry is looked for, and the map would
/// keep to it.
bool Settling::should_jump() const {
  if (plan_.acceleration == Acceleration::none) return false;
  if (acceleration_.outcome != AccelerationReport::Outcome::none) return false;
  if (march_.symmetry() != std::gcd(march_.sector_count(), scene_.casing.lobes)) return false;
  const auto start = static_cast<std::int64_t>(std::ceil(scene_.casing.ramp_revolutions)) + approach;
  return march_.step_count() >= start * march_.steps_per_revolution();
}

/// A little off the orbit towards where the march came from: an unstable orbit is left in the directions in
/// which a march from rest goes elsewhere.
void Settling::put_beside(const Eigen::VectorXd& orbit, const Eigen::VectorXd& start, SymmetricMap& map) const {
  const Eigen::VectorXd away = start - orbit;
  const double size = away.norm(), wanted = disturbance * scene_.parameters.settle_tolerance * orbit.norm();
  map.put(size > wanted ? Eigen::VectorXd(orbit + wanted / size * away) : orbit);
}

bool Settling::find_orbit() {
  SymmetricMap map(march_, scene_.casing.lobes);
  const Eigen::VectorXd start = map.state();
  FixedPoint found;
  found.x = start;
  for (const Try& next : tries) {
    const auto image = [&](const Eigen::VectorXd& state) -> Eigen::VectorXd {
      const Eigen::VectorXd mapped = map(state);
      return next.lift > 0 ? Eigen::VectorXd(state + next.lift * map.lifted(mapped - state)) : mapped;
    };
    found = find_fixed_point(image, found.x,
                             {next.residual_share * scene_.parameters.settle_tolerance,
                              next.revolutions * map.maps_per_revolution(), depth, next.restarts, 3, patience});
    acceleration_.residual = found.residual;
    acceleration_.revolutions += std::ceil(static_cast<double>(found.evaluations) / map.maps_per_revolution());
    if (found.reached == FixedPoint::Reached::no) continue;
    put_beside(found.x, start, map);
    return true;
  }
  return false;
}

void Settling::jump() {
  const MarchState before(march_);
  acceleration_.outcome = AccelerationReport::Outcome::fell_back;
  try {
    if (find_orbit() && confirm()) acceleration_.outcome = AccelerationReport::Outcome::settled;
  } catch (const RunError&) {  // a combination of states that no march would come to
  }
  if (acceleration_.outcome == AccelerationReport::Outcome::fell_back) before.restore(march_);
}

bool Settling::confirm() {
  Settling judged(scene_, march_, {shortest_confirmation});
  while (judged.revolutions_ < shortest_confirmation ||
         (judged.revolutions_ < longest_confirmation && !steady(judged.state_)))
    judged.add(march_revolution(march_, scene_.scope.samples_per_revolution));
  if (!steady(judged.state_)) {
    acceleration_.revolutions += judged.revolutions_;
    return false;
  }
  state_ = std::move(judged.state_);
  last_ = std::move(judged.last_);
  revolutions_ += judged.revolutions_;
  return true;
}

}  // namespace tiprub
