// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "simulate/periodic/periodic_map.h"
#include "simulate/periodic/symmetric_map.h"
#include "simulate/periodic/tangent_march.h"

namespace tiprub {

/// The symmetric map of a march, or a power of it, and its derivative.
class MarchedMap final : public PeriodicMap {
 public:
  /// Refers to the march, and leaves its clock unchanged.
  explicit MarchedMap(TimeMarch& march, int power = 1);

  const SymmetricMap& symmetric() const { return map_; }
  /// Puts the march onto an orbit. The state does not hold the modes without mass, which follow the forces: if there
  /// are any, a whole revolution is marched.
  void put(const Eigen::VectorXd& state);

  MapImage image(const Eigen::VectorXd& state) override;
  Eigen::VectorXd tangent(const std::shared_ptr<const ContactPattern>& pattern,
                          const Eigen::VectorXd& change) override;

 private:
  TimeMarch& march_;
  SymmetricMap map_;
  TangentMarch tangent_;
  bool all_have_mass_;
};

}  // namespace tiprub
