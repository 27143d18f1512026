// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/integrators/contact_law.h"

namespace tiprub {

namespace {

class PositionContact final : public ContactLaw {
 public:
  PositionContact(const Eigen::MatrixXd& compliance, ContactRule rule) : impulses_(compliance, rule) {}

  bool step(const Eigen::VectorXd& /*gap_before*/, Eigen::VectorXd& gap, bool penetrates) override {
    if (penetrates)
      impulses_.solve(gap);
    else
      impulses_.open();
    return penetrates;
  }
  const Eigen::VectorXd& multipliers() const override { return impulses_.multipliers(); }
  const Eigen::VectorXd& correction() const override { return impulses_.correction(); }
  const std::vector<int>& closed() const override { return impulses_.closed(); }
  std::int64_t factorizations() const override { return impulses_.factorizations(); }
  std::int64_t fallbacks() const override { return impulses_.fallbacks(); }

 private:
  ContactImpulses impulses_;
};

}  // namespace

std::unique_ptr<ContactLaw> position_contact(const Eigen::MatrixXd& compliance, ContactRule rule) {
  return std::make_unique<PositionContact>(compliance, rule);
}

}  // namespace tiprub
