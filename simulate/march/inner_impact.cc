// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/inner_impact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tiprub::simulate {

namespace {

constexpr double closed_gap = 1e-9;    // of the way in a step: a smaller gap is that of a closed node
constexpr int newton_steps = 4;        // from the root of the parabola
constexpr double most_damping = 0.99;  // [1] <r> of a step; at 1 a mode forgets its velocity at once
constexpr double far_away = std::numeric_limits<double>::infinity();  // [m] the gap of a node without an impact

/// g(x) through the gaps at x = -1 .. 2.
struct Cubic {
  double g, slope, bend, jerk;

  explicit Cubic(const InnerImpact::Gaps& gaps)
      : g(gaps.now), slope(0), bend((gaps.next - 2 * gaps.now + gaps.before) / 2), jerk(0) {
    jerk = (gaps.ahead - 3 * gaps.next + 3 * gaps.now - gaps.before) / 6;
    slope = (gaps.next - gaps.before) / 2 - jerk;
  }
  double at(double x) const { return g + x * (slope + x * (bend + x * jerk)); }
  double first(double x) const { return slope + x * (2 * bend + 3 * x * jerk); }
  double second(double x) const { return 2 * bend + 6 * x * jerk; }
};

}  // namespace

Recoil::Recoil(double r, double k)
    : damping(r),
      stiffness(k),
      rho(-std::log1p(-std::min(r, most_damping))),
      phi(std::acos(std::clamp((2 - r - k) / 2 * std::exp(rho / 2), -1.0, 1.0))) {}

double Recoil::at(double x) const {
  return std::exp(-rho * x / 2) * (phi > 0 ? std::sin(phi * x) / phi : x);
}

double Recoil::slope(double x) const {
  return std::exp(-rho * x / 2) * std::cos(phi * x) - rho / 2 * at(x);
}

InnerImpact::InnerImpact(int node, const Gaps& gaps, const Recoil& recoil) : node_(node), recoil_(recoil) {
  const Cubic cubic(gaps);
  const double fall = std::sqrt(std::pow((gaps.next - gaps.before) / 2, 2) - 4 * cubic.bend * gaps.now);
  instant_ = 2 * gaps.now / (fall - (gaps.next - gaps.before) / 2);
  for (int i = 0; i < newton_steps; ++i)
    instant_ = std::clamp(instant_ - cubic.at(instant_) / cubic.first(instant_), 0.0, 1.0);
  approach_ = -cubic.first(instant_);
  bend_ = cubic.second(instant_);
  target_ = gaps.next + approach_ * recoil_.at(1 - instant_);
  jump_ = -approach_ * recoil_.at(-instant_);
}

InnerImpact::Change InnerImpact::change(const Gaps& gaps) const {
  const Cubic cubic(gaps);
  const double later = cubic.at(instant_) / approach_, faster = -cubic.first(instant_) - bend_ * later;
  return {gaps.next + faster * recoil_.at(1 - instant_) - approach_ * recoil_.slope(1 - instant_) * later,
          -faster * recoil_.at(-instant_) + approach_ * recoil_.slope(-instant_) * later};
}

InnerImpacts::InnerImpacts(const std::shared_ptr<ContactCompliance>& compliance, std::vector<Recoil> recoils)
    : recoils_(std::move(recoils)),
      impulses_(compliance, ContactRule::complementarity),
      jumps_(Eigen::VectorXd::Constant(compliance->size(), far_away)) {}

bool InnerImpacts::foresee(const GapHistory& gaps) {
  foreseen_.clear();
  for (Eigen::Index i = 0; i < gaps.next.size(); ++i) {
    const double now = gaps.now[i], next = gaps.next[i];
    if (!(next < 0) || !(now > closed_gap * (now - next))) continue;
    const double slope = (next - gaps.before[i]) / 2, bend = next - 2 * now + gaps.before[i];
    const Recoil& recoil = recoils_[static_cast<std::size_t>(i) % recoils_.size()];
    const double approach = std::sqrt(slope * slope - 2 * bend * now);
    if (bend > (recoil.damping + recoil.stiffness) * approach) foreseen_.push_back(static_cast<int>(i));
  }
  return !foreseen_.empty();
}

void InnerImpacts::find(const GapHistory& gaps, const Eigen::VectorXd& ahead) {
  for (const int i : foreseen_) {
    const InnerImpact impact(i, {gaps.before[i], gaps.now[i], gaps.next[i], ahead[i]},
                             recoils_[static_cast<std::size_t>(i) % recoils_.size()]);
    const bool stays_outside = impact.target() >= 0 && gaps.now[i] >= impact.jump();  // at t_{q+1}, and back at t_q
    if (stays_outside && impact.jump() >= 0) all_.push_back(impact);
  }
}

void InnerImpacts::push(const Eigen::VectorXd& forces) {
  std::erase_if(all_, [&](const InnerImpact& impact) { return !(forces[impact.node()] > 0); });
  double deepest = 0;
  for (const InnerImpact& impact : all_) {
    jumps_[impact.node()] = -impact.jump();
    deepest = std::max(deepest, impact.jump());
  }
  if (deepest > 0) impulses_.solve(jumps_);
  for (InnerImpact& impact : all_) impact.impulse = impulses_.multipliers()[impact.node()];
  impulses_.open();
  jumps_.setConstant(far_away);
}

}  // namespace tiprub::simulate
