// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/cycle_stress.h"

#include <algorithm>

namespace tiprub {

namespace {

/// The waves of each sample of some columns.
std::vector<std::vector<WaveField>> recovered(const WheelCycle& cycle, int first, int count,
                                              const WaveRecovery& recover) {
  std::vector<std::vector<WaveField>> by_sample(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < cycle.states.size(); ++i) {
    std::vector<WaveField> waves = recover(i, cycle.states[i].middleCols(first, count));
    for (std::size_t s = 0; s < waves.size(); ++s) by_sample[s].push_back(std::move(waves[s]));
  }
  return by_sample;
}

/// [Pa] of spin and mean vibration, by blades that live differently: a blade's mean is that of all sectors whose
/// states it passes through.
std::vector<Tensors> mean_stress(const WheelCycle& cycle, const Tensors& spin, int sector_count,
                                 const WaveRecovery& recover) {
  std::vector<WaveField> mean;
  for (std::size_t i = 0; i < cycle.states.size(); ++i)
    mean.push_back(std::move(recover(i, cycle.states[i].rowwise().mean()).front()));
  const int histories = cycle.histories();
  std::vector<Tensors> stress(static_cast<std::size_t>(histories), spin);
  const double share = static_cast<double>(histories) / cycle.sectors;
  for (int j = 0; j < cycle.sectors; ++j)
    stress[static_cast<std::size_t>(j % histories)] += share * on_sector(mean, j, sector_count).stress;
  return stress;
}

/// Goes through the states and keeps the largest values.
class Maxima {
 public:
  /// `mean` by blades that live differently; none: no mean and no alternating part.
  Maxima(const Tensors& spin, std::vector<Tensors> mean) : spin_(spin), mean_(std::move(mean)) {
    const Eigen::Index nodes = spin.cols();
    found.vibration = found.both = Eigen::VectorXd::Zero(nodes);
    found.spin = von_mises(spin);
    found.sector = found.sample = Eigen::VectorXi::Zero(nodes);
    found.mean.resize(nodes, static_cast<Eigen::Index>(mean_.size()));
    found.alternating = Eigen::MatrixXd::Zero(nodes, found.mean.cols());
    for (Eigen::Index h = 0; h < found.mean.cols(); ++h)
      found.mean.col(h) = von_mises(mean_[static_cast<std::size_t>(h)]);
  }

  void add(const SectorField& now, int sector, int sample) {
    found.displacement = std::max(found.displacement, now.displacement.colwise().norm().maxCoeff());
    const Eigen::VectorXd vibration = von_mises(now.stress);
    for (Eigen::Index node = 0; node < vibration.size(); ++node) {
      if (vibration[node] <= found.vibration[node]) continue;
      found.vibration[node] = vibration[node];
      found.sector[node] = sector;
      found.sample[node] = sample;
    }
    const Tensors both = now.stress + spin_;
    found.both = found.both.cwiseMax(von_mises(both));
    if (mean_.empty()) return;
    const std::size_t history = static_cast<std::size_t>(sector) % mean_.size();
    auto alternating = found.alternating.col(static_cast<Eigen::Index>(history));
    alternating = alternating.cwiseMax(von_mises(both - mean_[history]));
  }

  CycleStress found;

 private:
  const Tensors& spin_;
  std::vector<Tensors> mean_;
};

}  // namespace

CycleStress cycle_stress(const WheelCycle& cycle, const Tensors& spin, int sector_count, const WaveRecovery& recover,
                         int block) {
  Maxima maxima(spin, cycle.whole ? mean_stress(cycle, spin, sector_count, recover) : std::vector<Tensors>());
  for (int first = 0; first < cycle.samples(); first += block) {
    const int count = std::min(block, cycle.samples() - first);
    const std::vector<std::vector<WaveField>> waves = recovered(cycle, first, count, recover);
    for (int s = 0; s < count; ++s)
      for (int j = 0; j < cycle.sectors; ++j)
        maxima.add(on_sector(waves[static_cast<std::size_t>(s)], j, sector_count), j, cycle.first_sample + first + s);
  }
  return std::move(maxima.found);
}

}  // namespace tiprub
