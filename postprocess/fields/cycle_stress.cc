// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/cycle_stress.h"

#include <algorithm>

namespace tiprub::postprocess {

namespace {

/// The waves of each of some samples.
std::vector<std::vector<WaveField>> recovered(const WheelCycle& cycle, int first, int count,
                                              const WaveRecovery& recover) {
  std::vector<std::vector<WaveField>> by_sample(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < cycle.states.size(); ++i) {
    std::vector<WaveField> waves = recover(i, cycle.states[i].middleCols(first, count));
    for (std::size_t s = 0; s < waves.size(); ++s) by_sample[s].push_back(std::move(waves[s]));
  }
  return by_sample;
}

/// [Pa] The mean stress, spin included, by blades with different histories. A blade's mean is that of all sectors
/// whose states it passes through.
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

constexpr Eigen::Index nodes_at_once = 256;  // their waves fit into a processor's second cache

/// Goes through the states and keeps the largest values.
class Maxima {
 public:
  /// `mean` by blades with different histories; if it is empty, there is no alternating part.
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

  /// All sectors at some samples.
  void add(const std::vector<std::vector<WaveField>>& by_sample, int first_sample, int sectors, int sector_count) {
    for (Eigen::Index first = 0; first < spin_.cols(); first += nodes_at_once) {
      const Eigen::Index count = std::min(nodes_at_once, spin_.cols() - first);
      for (std::size_t s = 0; s < by_sample.size(); ++s)
        for (int j = 0; j < sectors; ++j)
          add(on_sector(by_sample[s], j, sector_count, first, count), first, j, first_sample + static_cast<int>(s));
    }
  }

  CycleStress found;

 private:
  /// The nodes from `first` on.
  void add(const SectorField& now, Eigen::Index first, int sector, int sample) {
    found.displacement = std::max(found.displacement, now.displacement.colwise().norm().maxCoeff());
    const Eigen::VectorXd vibration = von_mises(now.stress);
    const Eigen::Index count = vibration.size();
    for (Eigen::Index k = 0; k < count; ++k) {
      if (vibration[k] <= found.vibration[first + k]) continue;
      found.vibration[first + k] = vibration[k];
      found.sector[first + k] = sector;
      found.sample[first + k] = sample;
    }
    const Tensors both = now.stress + spin_.middleCols(first, count);
    auto largest = found.both.segment(first, count);
    largest = largest.cwiseMax(von_mises(both));
    if (mean_.empty()) return;
    const std::size_t history = static_cast<std::size_t>(sector) % mean_.size();
    auto alternating = found.alternating.col(static_cast<Eigen::Index>(history)).segment(first, count);
    alternating = alternating.cwiseMax(von_mises(both - mean_[history].middleCols(first, count)));
  }

  const Tensors& spin_;
  std::vector<Tensors> mean_;
};

}  // namespace

CycleStress cycle_stress(const WheelCycle& cycle, const Tensors& spin, int sector_count, const WaveRecovery& recover,
                         int block, Progress& progress) {
  Maxima maxima(spin, cycle.whole ? mean_stress(cycle, spin, sector_count, recover) : std::vector<Tensors>());
  for (int first = 0; first < cycle.samples(); first += block) {
    const int count = std::min(block, cycle.samples() - first);
    const std::vector<std::vector<WaveField>> waves = recovered(cycle, first, count, recover);
    maxima.add(waves, cycle.first_sample + first, cycle.sectors, sector_count);
    for (int s = 0; s < count; ++s) progress.advance();
  }
  return std::move(maxima.found);
}

}  // namespace tiprub::postprocess
