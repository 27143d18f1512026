// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/stress_between.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "postprocess/fields/cell_stress.h"
#include "postprocess/fields/stress_over_speed.h"

namespace tiprub::postprocess {

std::vector<std::size_t> speeds_between(const Study& study) {
  constexpr int most = 48;
  const std::vector<SpeedResponse>& speeds = study.response.speeds;
  std::set<std::size_t> chosen;
  for (int i = 0; i < most; ++i) {
    const double place = study.range.low + (study.range.high - study.range.low) * i / (most - 1);
    const auto nearest = std::ranges::min_element(
        speeds, {}, [&](const SpeedResponse& speed) { return std::abs(speed.speed - place); });
    if (nearest->snapshot) chosen.insert(static_cast<std::size_t>(nearest - speeds.begin()));
  }
  return {chosen.begin(), chosen.end()};
}

std::vector<int> nodes_between(const Study& study, const StressZones& zones,
                               const std::optional<MaterialStrength>& strength, const SectorStress& on_sector,
                               Progress& progress) {
  std::vector<SectorStress::At> instants;
  for (const std::size_t index : speeds_between(study)) {
    const SpeedResponse& response = study.response.speeds[index];
    instants.push_back({wheel_instant(response, study.response.scene), response.speed});
  }
  std::vector<int> all;
  on_sector.over(instants, progress, [&](std::size_t, const CycleStress& stress) {
    const std::vector<int> nodes = governing_nodes(stress, zones, strength);
    all.insert(all.end(), nodes.begin(), nodes.end());
  });
  return all;
}

EstimatedStress estimated_stress(const FieldsReader& reader, const Study& study, const std::vector<int>& nodes,
                                 const WaveField& spin, const std::optional<MaterialStrength>& strength) {
  const Eigen::MatrixXd stress = stress_over_speed(reader, study, nodes);
  EstimatedStress estimated;
  if (stress.size() == 0) return estimated;
  estimated.vibration = stress.colwise().maxCoeff();
  if (!strength) return estimated;
  const Eigen::VectorXd of_spin = von_mises(spin.stress.real());
  estimated.utilisation = Eigen::VectorXd::Zero(stress.cols());
  for (Eigen::Index k = 0; k < stress.cols(); ++k) {
    const double share = std::pow(study.speed_at(k).speed / study.range.high, 2);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      estimated.utilisation[k] = std::max(
          estimated.utilisation[k],
          goodman_utilisation(*strength, stress(static_cast<Eigen::Index>(i), k), share * of_spin[nodes[i]]));
  }
  return estimated;
}

}  // namespace tiprub::postprocess
