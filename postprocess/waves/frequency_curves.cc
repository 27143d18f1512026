// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/waves/frequency_curves.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <future>

namespace tiprub {

namespace {

Eigen::MatrixXd squares_over_speed(const NodalDiameterModel& model, const Eigen::VectorXd& speeds) {
  Eigen::MatrixXd squares(speeds.size(), model.M.rows());
  for (Eigen::Index i = 0; i < speeds.size(); ++i) {
    const Eigen::ArrayXd frequencies = model.natural_frequencies(speeds[i]);
    squares.row(i) = (frequencies * frequencies.abs()).transpose();
  }
  return squares;
}

}  // namespace

FrequencyCurves::FrequencyCurves(const ReducedModel& model, double speed_max)
    : speeds_(Eigen::VectorXd::LinSpaced(speed_samples, 0.0, std::max(speed_max, 1.0))) {
  std::vector<std::future<Eigen::MatrixXd>> pending;
  for (const NodalDiameterModel& matrices : model.nodal_diameters)
    pending.push_back(std::async(std::launch::async, squares_over_speed, std::cref(matrices), std::cref(speeds_)));
  for (auto& squares : pending) squares_.push_back(squares.get());
}

double FrequencyCurves::frequency(int nodal_diameter, int family, double speed) const {
  constexpr int stencil = 4;
  const double step = speeds_[1] - speeds_[0];
  const int first = std::clamp(static_cast<int>(speed / step) - 1, 0, speed_samples - stencil);
  double square = 0;
  for (int i = first; i < first + stencil; ++i) {
    double weight = 1;  // Lagrange's, in Omega^2
    for (int k = first; k < first + stencil; ++k)
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
