// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/engine_order_band.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tiprub {

EngineOrderBand::EngineOrderBand(int samples, double orders)
    : orders_(static_cast<int>(std::min(std::max(orders, 1.0), (samples - 1) / 2.0))), samples_(samples) {
  if (orders >= (samples - 1) / 2.0) return;
  waves_.resize(samples, 2 * orders_ + 1);
  waves_.col(0).setConstant(1 / std::sqrt(samples));
  for (int k = 1; k <= orders_; ++k) {
    const double half = std::numbers::pi * k / samples;
    const double size = std::sqrt(2.0 / samples) * half / std::sin(half);
    for (int s = 0; s < samples; ++s) {
      const double angle = 2 * std::numbers::pi * (static_cast<long long>(k) * s % samples) / samples;
      waves_(s, 2 * k - 1) = size * std::cos(angle);
      waves_(s, 2 * k) = size * std::sin(angle);
    }
  }
}

Eigen::MatrixXd EngineOrderBand::coefficients(const Eigen::VectorXd& revolution) const {
  const Eigen::Map<const Eigen::MatrixXd> motion(revolution.data(), revolution.size() / samples_, samples_);
  return waves_.size() > 0 ? Eigen::MatrixXd(motion * waves_) : Eigen::MatrixXd(motion);
}

}  // namespace tiprub
