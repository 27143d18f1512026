// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/frequency_table.h"

#include <atomic>
#include <cmath>

#include "cases/program/machine.h"
#include "cases/program/units.h"
#include "simulate/march/rotor_at_speed.h"

namespace tiprub {

namespace {

Eigen::VectorXd signed_frequencies(const Eigen::VectorXd& omega_squared) {
  return omega_squared.unaryExpr(
      [](double square) { return std::copysign(std::sqrt(std::abs(square)), square) * hz_per_rad_s; });
}

}  // namespace

FrequencyTable frequency_table(const ReducedModel& model, const Damping& damping, double speed_max, int threads) {
  FrequencyTable table;
  table.speed = Eigen::VectorXd::LinSpaced(frequency_speeds, 0.0, speed_max);
  const int diameters = model.nodal_diameter_max() + 1;
  std::vector<Eigen::VectorXd> rows(static_cast<std::size_t>(diameters) * frequency_speeds);
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < rows.size(); i = next++) {
      const int n = static_cast<int>(i / frequency_speeds);
      const double speed = table.speed[static_cast<Eigen::Index>(i % frequency_speeds)];
      rows[i] = signed_frequencies(modes_at_speed(model, n, speed, ModeParts::frequencies).omega_squared);
    }
  };
  work_together(threads, work);
  for (int n = 0; n < diameters; ++n) {
    const std::size_t first = static_cast<std::size_t>(n) * frequency_speeds;
    Eigen::MatrixXd& curves = table.by_nodal_diameter.emplace_back(frequency_speeds, rows[first].size());
    for (int s = 0; s < frequency_speeds; ++s) curves.row(s) = rows[first + static_cast<std::size_t>(s)];
    Eigen::MatrixXd& ratios = table.damping_ratio.emplace_back(curves.rows(), curves.cols());
    for (Eigen::Index mode = 0; mode < curves.cols(); ++mode)
      ratios.col(mode) = curves.col(mode).unaryExpr(
          [&](double frequency) { return damping.ratio(static_cast<std::size_t>(mode), frequency); });
  }
  return table;
}

}  // namespace tiprub
