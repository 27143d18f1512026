// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "simulate/march/contact_impulses.h"
#include "simulate/march/marched_scene.h"

namespace tiprub::simulate {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Moreau-Jean: the gap rate G = h dg/dt follows g+ = g + theta G+ + (1 - theta) G, and for nodes with g + G/2 <= 0
///   0 <= lambda perpendicular to G+ >= 0,   G+ = G_free + W lambda,
/// an inelastic impact on velocities. Nothing constrains the positions: a node may penetrate by about h times its
/// approaching speed, and it stays there until the motion carries it off.
class VelocityContact final : public ContactLaw {
 public:
  VelocityContact(const std::shared_ptr<ContactCompliance>& compliance, double theta)
      : compliance_(compliance),
        theta_(theta),
        impulses_(compliance, ContactRule::complementarity),
        lambda_(Eigen::VectorXd::Zero(compliance->size())),
        multipliers_(lambda_),
        correction_(lambda_) {}

  bool step(const Eigen::VectorXd& gap_before, Eigen::VectorXd& gap, bool /*penetrates*/) override {
    if (rate_.size() == 0) rate_ = gap - gap_before;
    const bool had_force = !impulses_.closed().empty();
    multipliers_.setZero();
    correction_.setZero();
    add_forces(1 - theta_, lambda_, gap);
    rate_free_ = (gap - gap_before - (1 - theta_) * rate_) / theta_;
    const bool has_force = close_approaching(gap_before);
    rate_.swap(rate_free_);
    closed_.clear();
    if (!had_force && !has_force) return false;
    if (has_force)
      lambda_ = impulses_.multipliers();
    else
      lambda_.setZero();
    add_forces(theta_, lambda_, gap);
    for (Eigen::Index i = 0; i < multipliers_.size(); ++i)
      if (multipliers_[i] != 0) closed_.push_back(static_cast<int>(i));
    return true;
  }
  const Eigen::VectorXd& multipliers() const override { return multipliers_; }
  const Eigen::VectorXd& correction() const override { return correction_; }
  const std::vector<int>& closed() const override { return closed_; }
  std::int64_t fallbacks() const override { return impulses_.fallbacks(); }

 private:
  /// `share` of the forces acts in this step.
  void add_forces(double share, const Eigen::VectorXd& forces, Eigen::VectorXd& gap) {
    forced_.clear();
    for (Eigen::Index i = 0; i < forces.size() && share != 0; ++i)
      if (forces[i] != 0) forced_.push_back(static_cast<int>(i));
    for (const int i : forced_) multipliers_[i] += share * forces[i];
    compliance_->open(share, forces, forced_, correction_);
    compliance_->open(share, forces, forced_, gap);
  }
  /// Updates rate_free_ to G+. The rate of an open node is not constrained and counts as infinite.
  bool close_approaching(const Eigen::VectorXd& gap_before) {
    constrained_ = Eigen::VectorXd::Constant(rate_free_.size(), infinity);
    bool any = false;
    for (Eigen::Index i = 0; i < rate_free_.size(); ++i) {
      if (!(gap_before[i] + 0.5 * rate_[i] <= 0)) continue;
      constrained_[i] = rate_free_[i];
      any |= rate_free_[i] < 0;
    }
    if (!any) {
      impulses_.open();
      return false;
    }
    impulses_.solve(constrained_);
    rate_free_ += impulses_.correction();
    return true;
  }

  std::shared_ptr<ContactCompliance> compliance_;
  double theta_;
  ContactImpulses impulses_;
  Eigen::VectorXd lambda_, multipliers_, correction_;
  Eigen::VectorXd rate_, rate_free_, constrained_;  ///< [m] G, by node
  std::vector<int> closed_, forced_;
};

/// lambda = kappa max(0, -g), kappa [N/m]. The law is explicit: the force of a step is known before the step, and
/// there is no system to solve. But the spring raises omega_max (see penalised_omega_max), and the node penetrates by
/// lambda/kappa.
class PenaltyContact final : public ContactLaw {
 public:
  PenaltyContact(const std::shared_ptr<ContactCompliance>& compliance, double stiffness)
      : compliance_(compliance),
        stiffness_(stiffness),
        multipliers_(Eigen::VectorXd::Zero(compliance->size())),
        correction_(multipliers_) {}

  bool step(const Eigen::VectorXd& gap_before, Eigen::VectorXd& gap, bool /*penetrates*/) override {
    for (int i : closed_) multipliers_[i] = 0;
    closed_.clear();
    correction_.setZero();
    for (Eigen::Index i = 0; i < gap.size(); ++i) {
      if (!(gap_before[i] < 0)) continue;
      multipliers_[i] = -stiffness_ * gap_before[i];
      closed_.push_back(static_cast<int>(i));
    }
    compliance_->open(1, multipliers_, closed_, correction_);
    gap += correction_;
    return !closed_.empty();
  }
  const Eigen::VectorXd& multipliers() const override { return multipliers_; }
  const Eigen::VectorXd& correction() const override { return correction_; }
  const std::vector<int>& closed() const override { return closed_; }

 private:
  std::shared_ptr<ContactCompliance> compliance_;
  double stiffness_;
  Eigen::VectorXd multipliers_, correction_;
  std::vector<int> closed_;
};

}  // namespace

std::unique_ptr<ContactLaw> contact_law(const MarchSetup& setup,
                                        const std::shared_ptr<ContactCompliance>& compliance) {
  if (setup.scheme == Scheme::moreau_jean) return std::make_unique<VelocityContact>(compliance, setup.theta);
  if (setup.scheme == Scheme::penalty) return std::make_unique<PenaltyContact>(compliance, setup.penalty_stiffness);
  return std::make_unique<ContactImpulses>(compliance, setup.contact);
}

}  // namespace tiprub::simulate
