// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/waves/frequency_curves.h"

#include <algorithm>
#include <cmath>

namespace tiprub {

FrequencyCurves::FrequencyCurves(const FrequencyTable& table) : speeds_(table.speed) {
  for (const Eigen::MatrixXd& frequencies : table.by_nodal_diameter)
    squares_.emplace_back(frequencies.cwiseProduct(frequencies.cwiseAbs()));
}

double FrequencyCurves::frequency(int nodal_diameter, int family, double speed) const {
  const auto above = std::upper_bound(speeds_.begin(), speeds_.end(), speed) - speeds_.begin();
  const auto first = std::clamp<Eigen::Index>(above - stencil / 2, 0, speeds_.size() - stencil);
  double square = 0;
  for (Eigen::Index i = first; i < first + stencil; ++i) {
    double weight = 1;  // Lagrange's, in Omega^2
    for (Eigen::Index k = first; k < first + stencil; ++k)
      if (k != i) {
        const double node = speeds_[i] * speeds_[i], other = speeds_[k] * speeds_[k];
        weight *= (speed * speed - other) / (node - other);
      }
    square += weight * squares_[nodal_diameter](i, family);
  }
  return std::copysign(std::sqrt(std::abs(square)), square);
}

int FrequencyCurves::nearest_family(int nodal_diameter, double wanted, double speed) const {
  int nearest = 0;
  double smallest = std::abs(frequency(nodal_diameter, 0, speed) - wanted);
  for (int family = 1; family < families(nodal_diameter); ++family) {
    const double distance = std::abs(frequency(nodal_diameter, family, speed) - wanted);
    if (distance < smallest) {
      smallest = distance;
      nearest = family;
    }
  }
  return nearest;
}

}  // namespace tiprub
