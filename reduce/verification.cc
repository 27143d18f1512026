// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/verification.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "reduce/condensation.h"
#include "reduce/parallel_for.h"

namespace tiprub {

namespace {

/// Waves of the whole wheel that a nodal diameter stands for: both directions, or one standing wave.
int waves_of(const ReducedModel& model, std::size_t nodal_diameter) {
  return nodal_diameter == 0 || 2 * static_cast<int>(nodal_diameter) == model.sector_count ? 1 : 2;
}

}  // namespace

void find_reduced_frequencies(ReducedModel& model, int threads) {
  Verification& table = model.verification;
  table.reduced = table.unreduced;
  parallel_for(static_cast<int>(table.reduced.size()), threads, [&](int n) {
    for (Eigen::Index row = 0; row < table.speeds.size(); ++row)
      table.reduced[n].row(row) =
          condense(model.nodal_diameters[n], table.speeds[row], model.contact_dofs(), model.modes_at_speed)
              .natural_frequencies()
              .head(table.reduced[n].cols())
              .transpose();
  });
}

int verified_frequencies(const ReducedModel& model) {
  int fewest = std::numeric_limits<int>::max();
  for (Eigen::Index speed = 0; speed < model.verification.speeds.size(); ++speed) {
    double end = std::numeric_limits<double>::infinity();
    for (const Eigen::MatrixXd& table : model.verification.unreduced)
      end = std::min(end, table.row(speed).maxCoeff());
    int count = 0;
    for (std::size_t n = 0; n < model.verification.unreduced.size(); ++n) {
      count +=
          waves_of(model, n) * static_cast<int>((model.verification.unreduced[n].row(speed).array() <= end).count());
    }
    fewest = std::min(fewest, count);
  }
  return model.verification.speeds.size() == 0 ? 0 : fewest;
}

double verification_error(const ReducedModel& model, int count) {
  double worst = 0;
  for (Eigen::Index speed = 0; speed < model.verification.speeds.size(); ++speed) {
    std::vector<std::pair<double, double>> wheel;  // unreduced frequency, its relative error
    for (std::size_t n = 0; n < model.nodal_diameters.size(); ++n) {
      for (Eigen::Index mode = 0; mode < model.verification.unreduced[n].cols(); ++mode) {
        const double exact = model.verification.unreduced[n](speed, mode);
        const double error = std::abs(model.verification.reduced[n](speed, mode) / exact - 1);
        wheel.insert(wheel.end(), waves_of(model, n), {exact, error});
      }
    }
    std::sort(wheel.begin(), wheel.end());
    wheel.resize(std::min<std::size_t>(wheel.size(), count));
    for (const auto& [frequency, error] : wheel) worst = std::max(worst, error);
  }
  return worst;
}

}  // namespace tiprub
