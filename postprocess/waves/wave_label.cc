// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/waves/wave_label.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

FrequencyCurves::FrequencyCurves(const FrequencyTable& table) : speeds_(table.speed), damping_(table.damping_ratio) {
  for (const Eigen::MatrixXd& frequencies : table.by_nodal_diameter)
    squares_.emplace_back(frequencies.cwiseProduct(frequencies.cwiseAbs()));
}

double FrequencyCurves::frequency(int nodal_diameter, int family, double speed) const {
  const auto above = std::ranges::upper_bound(speeds_, speed) - speeds_.begin();
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

std::optional<double> FrequencyCurves::damping_ratio(int nodal_diameter, int family, double speed) const {
  if (damping_.empty()) return std::nullopt;
  Eigen::Index row = 0;
  (speeds_.array() - speed).abs().minCoeff(&row);
  return damping_[static_cast<std::size_t>(nodal_diameter)](row, family);
}

std::optional<double> FrequencyCurves::smallest_damping_ratio() const {
  std::optional<double> smallest;
  for (const Eigen::MatrixXd& ratios : damping_)
    smallest = std::min(smallest.value_or(ratios.minCoeff()), ratios.minCoeff());
  return smallest;
}

WaveLabel label_wave(const FrequencyCurves& curves, int sector_count, double speed, double engine_order,
                     int signed_nodal_diameter, double amplitude) {
  WaveLabel label;
  label.engine_order = engine_order;
  label.signed_nodal_diameter = signed_nodal_diameter;
  label.amplitude = amplitude;
  label.direction = wave_direction(signed_nodal_diameter, sector_count);
  const int nodal_diameter = std::abs(signed_nodal_diameter);
  const double frequency = engine_order * speed * hz_per_rad_s;
  label.family = curves.nearest_family(nodal_diameter, frequency, speed);
  label.natural_frequency = curves.frequency(nodal_diameter, label.family, speed);
  label.detuning = (frequency - label.natural_frequency) / label.natural_frequency;
  if (const auto damping = curves.damping_ratio(nodal_diameter, label.family, speed))
    label.half_width = *damping * std::abs(label.natural_frequency) / (engine_order * hz_per_rad_s);
  return label;
}

std::string engine_order_text(double engine_order) {
  constexpr int digits = 4;
  return significant(engine_order, digits);
}

std::string engine_order_name(double engine_order) {
  return "EO " + engine_order_text(engine_order);
}

std::string wave_name(double engine_order, int signed_nodal_diameter) {
  return engine_order_name(engine_order) + " ND " + (signed_nodal_diameter > 0 ? "+" : "") +
         std::to_string(signed_nodal_diameter);
}

std::string wave_name(const WaveLabel& wave) {
  return wave_name(wave.engine_order, wave.signed_nodal_diameter);
}

}  // namespace tiprub::postprocess
