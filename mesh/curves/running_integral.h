// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

namespace tiprub {

/// F(x), the integral of a smooth f from 0 to x in [0, 1]: five-point Gauss on equal panels, so that 64 panels are
/// exact to round-off for the curves of a blade. The whole panels are summed once; a call pays for one panel.
class RunningIntegral {
 public:
  explicit RunningIntegral(std::function<double(double)> integrand);

  double at(double x) const;
  double total() const { return sums_.back(); }
  /// The x with F(x) = value, for a positive f.
  double inverse(double value) const;

 private:
  double piece(double from, double to) const;

  std::function<double(double)> integrand_;
  std::vector<double> sums_;  ///< F at the ends of the panels
};

}  // namespace tiprub
