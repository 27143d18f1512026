// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "simulate/periodic/periodic_map.h"
#include "simulate/periodic/symmetric_map.h"
#include "simulate/periodic/tangent_march.h"

namespace tiprub {

/// The symmetric map of a march, and its derivative.
class MarchedMap final : public PeriodicMap {
 public:
  /// The march's clock is left where it is. All are referred to.
  MarchedMap(TimeMarch& march, const RotorAtSpeed& rotor, const Casing& casing, const ContactLine& contact);

  const SymmetricMap& symmetric() const { return map_; }
  /// Puts a state into the march.
  void put(const Eigen::VectorXd& state) { map_.put(state); }

  MapImage image(const Eigen::VectorXd& state) override;
  Eigen::VectorXd tangent(const std::shared_ptr<const ContactPattern>& pattern,
                          const Eigen::VectorXd& change) override;

 private:
  TimeMarch& march_;
  SymmetricMap map_;
  TangentMarch tangent_;
};

}  // namespace tiprub
