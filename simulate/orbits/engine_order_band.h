// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

namespace tiprub {

/// Engine orders 0 .. `orders` of the samples of one revolution: what of a motion counts as the wheel's. A tip that
/// chatters above the highest resolved frequency leaves them alone.
class EngineOrderBand {
 public:
  /// `samples` a revolution; all orders that they resolve, if `orders` asks for more.
  EngineOrderBand(int samples, double orders);

  int orders() const { return orders_; }
  /// Of values by sample, each a mean over the sample's interval, channel by channel within a sample: the Fourier
  /// coefficients, channels x (2 orders + 1), the mean first. The sum of their squares is that of the band's motion
  /// over the samples (what the means took off the higher orders is put back). If all orders count, the values
  /// themselves.
  Eigen::MatrixXd coefficients(const Eigen::VectorXd& revolution) const;

 private:
  int orders_;
  int samples_;
  Eigen::MatrixXd waves_;  ///< samples x (2 orders + 1); empty if all orders count
};

}  // namespace tiprub
