// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/verification.h"
#include "reduce/model/nodal_diameter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tiprub {

namespace {

struct Compared {
  double unreduced = 0;  ///< [Hz]
  double error = 0;      ///< [1]
};

/// The wheel's frequencies at one verified speed, as far as all nodal diameters reach; ascending.
std::vector<Compared> compared_frequencies(const ReducedModel& model, Eigen::Index speed) {
  const Verification& verified = model.verification;
  double end = std::numeric_limits<double>::infinity();
  for (const Eigen::MatrixXd& table : verified.unreduced) end = std::min(end, table.row(speed).maxCoeff());
  std::vector<Compared> wheel;
  for (std::size_t n = 0; n < verified.unreduced.size(); ++n) {
    const int count = wave_count(static_cast<int>(n), model.sector_count);
    for (Eigen::Index mode = 0; mode < verified.unreduced[n].cols(); ++mode) {
      const double exact = verified.unreduced[n](speed, mode);
      if (exact <= end && exact != 0)  // a rigid motion has no relative error
        wheel.insert(wheel.end(), count, {exact, std::abs(verified.reduced[n](speed, mode) / exact - 1)});
    }
  }
  std::sort(wheel.begin(), wheel.end(),
            [](const Compared& a, const Compared& b) { return a.unreduced < b.unreduced; });
  return wheel;
}

}  // namespace

ModelError model_error(const ReducedModel& model, int most) {
  ModelError found;
  const Eigen::VectorXd& speeds = model.verification.speeds;
  if (speeds.size() == 0 || model.verification.unreduced.empty()) return found;
  std::vector<std::vector<Compared>> wheels;
  std::size_t count = static_cast<std::size_t>(std::max(most, 0));
  for (Eigen::Index speed = 0; speed < speeds.size(); ++speed) {
    wheels.push_back(compared_frequencies(model, speed));
    count = std::min(count, wheels.back().size());
  }
  found.frequencies = static_cast<int>(count);
  for (std::size_t speed = 0; speed < wheels.size(); ++speed)
    for (std::size_t i = 0; i < count; ++i) {
      if (wheels[speed][i].error <= found.error) continue;
      found.error = wheels[speed][i].error;
      found.speed = speeds[static_cast<Eigen::Index>(speed)];
    }
  return found;
}

}  // namespace tiprub
