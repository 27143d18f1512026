// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/settling.h"

#include <cmath>
#include <numeric>
#include <sstream>
#include <utility>

#include "simulate/motion/attempt.h"
#include "simulate/orbits/recording.h"

namespace tiprub {

namespace {

constexpr double quiet_motion = 1e-3;     // of the casing's amplitude: a smaller motion counts as rest
constexpr double boundless_motion = 1e6;  // times amplitude and clearance: a larger motion has diverged
constexpr std::size_t remembered = 24;    // revolutions, for the class of a motion that does not settle

SteadyState make_judge(const Scene& scene, const TimeMarch& march) {
  const double size =
      std::sqrt(static_cast<double>(march.sectors()) * march.node_count() * scene.scope.samples_per_revolution);
  return {scene.parameters.settle_tolerance, quiet_motion * scene.casing.amplitude * size};
}

double highest_resolved_order(const Scene& scene, const TimeMarch& march) {
  const double turns_per_second = 1 / (march.time_step() * march.steps_per_revolution());
  return scene.parameters.resolved_frequency / turns_per_second;
}

}  // namespace

Settling::Settling(const Scene& scene, TimeMarch& march, int min_revolutions)
    : scene_(scene),
      march_(march),
      band_(scene.scope.samples_per_revolution, highest_resolved_order(scene, march)),
      state_(make_judge(scene, march)),
      bound_(boundless_motion * length_scale(scene)),
      min_revolutions_(min_revolutions) {}

void Settling::add(Eigen::VectorXd motion) {
  ++revolutions_;
  if (!(motion.cwiseAbs().maxCoeff() <= bound_)) {
    std::ostringstream text;
    text << "the motion grew beyond " << bound_ << " m in revolution " << revolutions_
         << "; take smaller steps, or look at the model";
    throw NoMotion(text.str());
  }
  const Eigen::MatrixXd coefficients = band_.coefficients(motion);
  state_.add(coefficients.reshaped());
  last_.push_back(std::move(motion));
  if (last_.size() > remembered) last_.pop_front();
}

MotionReading Settling::reading() const {
  const SettlingState state = this->state();
  std::deque<Eigen::VectorXd> revolutions = last_;
  Change change = state_.decays() ? Change::decays : Change::stands;
  if (state.settled == SettlingState::Settled::yes) {
    change = Change::settled;
    while (static_cast<int>(revolutions.size()) > state.period_revolutions) revolutions.pop_front();
  }
  return read_motion(revolutions, march_.displacement().size(), band_.orders(), scene_.casing.lobes, change);
}

bool Settling::settled() const {
  return orbit_ || (revolutions_ >= min_revolutions_ && state_.judge().settled == SettlingState::Settled::yes);
}

void Settling::advance() {
  add(march_revolution(march_, scene_.scope.samples_per_revolution));
}

void Settling::stand_on_orbit(int period_revolutions, double rate) {
  orbit_ = {SettlingState::Settled::yes, period_revolutions, 0, rate};
  last_.clear();
}

void Settling::confirm_orbit(double drift) {
  orbit_->change = drift;
}

void Settling::leave_orbit() {
  orbit_.reset();
  state_ = make_judge(scene_, march_);
  last_.clear();
}

}  // namespace tiprub
