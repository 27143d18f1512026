// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "simulate/march/integrators/contact_law.h"
#include "simulate/march/integrators/step_coefficients.h"

namespace tiprub {

StepCoefficients moreau_jean(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio, double step,
                             double theta) {
  const Eigen::ArrayXd angle_2 = (omega * step).square();
  const Eigen::ArrayXd divisor = 1 + theta * theta * angle_2 + 2 * theta * damping_ratio * omega * step;
  return {2 - 1 / theta + (1 / theta - theta * angle_2) / divisor,
          1 - 1 / theta + (1 / theta + (1 - theta) * angle_2) / divisor, step * step / divisor};
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class VelocityContact final : public ContactLaw {
 public:
  VelocityContact(const Eigen::MatrixXd& compliance, double theta)
      : compliance_(compliance),
        theta_(theta),
        impulses_(compliance, ContactRule::complementarity),
        lambda_(Eigen::VectorXd::Zero(compliance.rows())),
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
  std::int64_t factorizations() const override { return impulses_.factorizations(); }
  std::int64_t fallbacks() const override { return impulses_.fallbacks(); }

 private:
  /// `share` of the forces acts in this step.
  void add_forces(double share, const Eigen::VectorXd& forces, Eigen::VectorXd& gap) {
    for (Eigen::Index i = 0; i < forces.size(); ++i) {
      if (forces[i] == 0 || share == 0) continue;
      multipliers_[i] += share * forces[i];
      correction_.noalias() += share * forces[i] * compliance_.col(i);
      gap.noalias() += share * forces[i] * compliance_.col(i);
    }
  }
  /// Takes rate_free_ to G+. An open node's rate is no constraint: it counts as infinite in the problem.
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

  const Eigen::MatrixXd compliance_;
  double theta_;
  ContactImpulses impulses_;
  Eigen::VectorXd lambda_, multipliers_, correction_;
  Eigen::VectorXd rate_, rate_free_, constrained_;  ///< [m] G, by node
  std::vector<int> closed_;
};

}  // namespace

std::unique_ptr<ContactLaw> velocity_contact(const Eigen::MatrixXd& compliance, double theta) {
  return std::make_unique<VelocityContact>(compliance, theta);
}

}  // namespace tiprub
