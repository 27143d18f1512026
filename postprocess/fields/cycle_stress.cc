// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/cycle_stress.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <complex>
#include <thread>
#include <utility>

#include "cases/program/machine.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub::postprocess {

namespace {

/// The states of a nodal diameter at some samples, as sums of a few states: a motion has far fewer than its model has
/// dofs or its cycle has samples.
struct FewStates {
  Eigen::MatrixXcd basis;         ///< dofs x few
  Eigen::MatrixXcd coefficients;  ///< few x samples
};

FewStates few_states(const Eigen::MatrixXcd& states) {
  constexpr double left_out = 1e-7;  // of the largest one: fields.h5 has single precision
  if (states.cols() == 1) return {states, Eigen::MatrixXcd::Ones(1, 1)};
  Eigen::ColPivHouseholderQR<Eigen::MatrixXcd> qr(states);
  qr.setThreshold(left_out);
  const Eigen::Index few = std::max<Eigen::Index>(qr.rank(), 1);
  const Eigen::MatrixXcd first_rows = qr.matrixR().topRows(few).triangularView<Eigen::Upper>();
  return {qr.householderQ() * Eigen::MatrixXcd::Identity(states.rows(), few),
          first_rows * qr.colsPermutation().transpose()};
}

/// Waves of a nodal diameter at some samples: sums of a few fields.
struct SampledWaves {
  int nodal_diameter = 0;
  std::vector<WaveField> fields;
  Eigen::MatrixXcd coefficients;  ///< fields x samples
};

/// By nodal diameter. `count` is halved until no more than `most_fields` are needed, or one sample is left.
std::vector<SampledWaves> recovered(const WheelCycle& cycle, int first, int& count, const WaveRecovery& recover,
                                    int most_fields) {
  std::vector<FewStates> few;
  Eigen::Index needed = 0;
  for (const Eigen::MatrixXcd& states : cycle.states) {
    few.push_back(few_states(states.middleCols(first, count)));
    needed += few.back().basis.cols();
  }
  if (needed > most_fields && count > 1) return recovered(cycle, first, count /= 2, recover, most_fields);
  std::vector<SampledWaves> waves;
  for (std::size_t i = 0; i < few.size(); ++i) {
    std::vector<WaveField> fields = recover(i, few[i].basis);
    const int nodal_diameter = fields.front().nodal_diameter;
    waves.push_back({nodal_diameter, std::move(fields), few[i].coefficients});
  }
  return waves;
}

/// The means of waves over their samples.
std::vector<WaveField> means(const std::vector<SampledWaves>& waves) {
  std::vector<WaveField> all;
  for (const auto& [nodal_diameter, fields, coefficients] : waves) {
    const Eigen::VectorXcd factors = coefficients.rowwise().mean();
    WaveField mean{nodal_diameter, factors[0] * fields[0].displacement, factors[0] * fields[0].stress};
    for (std::size_t k = 1; k < fields.size(); ++k) {
      mean.displacement += factors[static_cast<Eigen::Index>(k)] * fields[k].displacement;
      mean.stress += factors[static_cast<Eigen::Index>(k)] * fields[k].stress;
    }
    all.push_back(std::move(mean));
  }
  return all;
}

/// The same of a cycle that is too long to recover its waves at once.
std::vector<WaveField> recovered_means(const WheelCycle& cycle, const WaveRecovery& recover) {
  std::vector<WaveField> all;
  for (std::size_t i = 0; i < cycle.states.size(); ++i)
    all.push_back(std::move(recover(i, cycle.states[i].rowwise().mean()).front()));
  return all;
}

/// [Pa] The mean stress, spin included, by blades with different histories. A blade's mean is that of all sectors
/// whose states it passes through.
std::vector<Tensors> mean_stress(const WheelCycle& cycle, const Tensors& spin, int sector_count,
                                 const std::vector<WaveField>& means) {
  const int histories = cycle.histories();
  std::vector<Tensors> stress(static_cast<std::size_t>(histories), spin);
  const double share = static_cast<double>(histories) / cycle.sectors;
  for (int j = 0; j < cycle.sectors; ++j)
    stress[static_cast<std::size_t>(j % histories)] += share * on_sector(means, j, sector_count).stress;
  return stress;
}

constexpr Eigen::Index nodes_at_once = 64;  // their components at one sample fit into a processor's first cache

/// A column for each component, a row for each node: sums and products then run along the memory, several at once.
using Components = Eigen::ArrayXXd;

Components by_component(const Tensors& tensors, Eigen::Index first, Eigen::Index count) {
  return tensors.middleCols(first, count).transpose();
}

/// [Pa^2] The square of the von Mises stress of the six columns from `first` on.
Eigen::ArrayXd von_mises_square(const Components& stress, Eigen::Index first = 0) {
  const auto s = [&](Eigen::Index k) { return stress.col(first + k); };
  return 0.5 * ((s(0) - s(1)).square() + (s(1) - s(2)).square() + (s(2) - s(0)).square()) +
         3 * (s(3).square() + s(4).square() + s(5).square());
}

constexpr Eigen::Index rows_of_node = 9;      // x, y, z of the displacement, then the stress
constexpr Eigen::Index samples_at_once = 32;  // of the sums at these nodes, which then stay in a second cache

/// The factors of the real parts of a wave's fields, then of their imaginary ones: a column for the real part of each
/// sum and another one for its imaginary part.
Eigen::MatrixXd real_factors(const Eigen::MatrixXcd& coefficients) {
  const Eigen::Index few = coefficients.rows();
  Eigen::MatrixXd factors(2 * few, 2 * coefficients.cols());
  for (Eigen::Index s = 0; s < coefficients.cols(); ++s) {
    factors.col(2 * s) << coefficients.col(s).real(), -coefficients.col(s).imag();
    factors.col(2 * s + 1) << coefficients.col(s).imag(), coefficients.col(s).real();
  }
  return factors;
}

/// Some nodes: a row for each component and node. Its memory is used again from nodes to nodes.
class Block {
 public:
  void take_nodes(const std::vector<SampledWaves>& waves, Eigen::Index first, Eigen::Index count) {
    count_ = count;
    shapes_.resize(waves.size());
    parts_.resize(waves.size());
    for (std::size_t i = 0; i < waves.size(); ++i) {
      const auto few = static_cast<Eigen::Index>(waves[i].fields.size());
      shapes_[i].resize(rows_of_node * count, 2 * few);
      for (Eigen::Index k = 0; k < few; ++k) {
        const WaveField& field = waves[i].fields[static_cast<std::size_t>(k)];
        const auto displacement = field.displacement.middleCols(first, count).transpose().reshaped();
        const auto stress = field.stress.middleCols(first, count).transpose().reshaped();
        shapes_[i].col(k) << displacement.real(), stress.real();
        shapes_[i].col(few + k) << displacement.imag(), stress.imag();
      }
    }
  }

  /// The waves at some samples, from the columns of these that real_factors() gave.
  void take_samples(const std::vector<Eigen::MatrixXd>& factors, Eigen::Index first, Eigen::Index count) {
    for (std::size_t i = 0; i < factors.size(); ++i)
      parts_[i].noalias() = shapes_[i] * factors[i].middleCols(2 * first, 2 * count);
  }

  /// The sum of the waves on a sector at one of these samples; `phases` as the waves.
  void sum(Eigen::Index sample, const std::vector<std::complex<double>>& phases, Components& now) const {
    now.setZero(count_, rows_of_node);
    for (std::size_t i = 0; i < parts_.size(); ++i)
      now.matrix().reshaped() +=
          phases[i].real() * parts_[i].col(2 * sample) - phases[i].imag() * parts_[i].col(2 * sample + 1);
  }

 private:
  Eigen::Index count_ = 0;
  std::vector<Eigen::MatrixXd> shapes_, parts_;  // by waves
};

/// The recorded samples that a part of a cycle consists of.
struct Samples {
  int first, stride;
};

/// Goes through the states and keeps the largest values.
class Maxima {
 public:
  /// `mean` by blades with different histories; if it is empty, there is no alternating part.
  Maxima(const Tensors& spin, std::vector<Tensors> mean) : spin_(spin), mean_(std::move(mean)) {
    const Eigen::Index nodes = spin.cols();
    found_.vibration = found_.both = found_.displacement = Eigen::VectorXd::Zero(nodes);
    found_.spin = von_mises(spin);
    found_.sector = found_.sample = Eigen::VectorXi::Zero(nodes);
    found_.mean.resize(nodes, static_cast<Eigen::Index>(mean_.size()));
    found_.alternating = Eigen::MatrixXd::Zero(nodes, found_.mean.cols());
    for (Eigen::Index h = 0; h < found_.mean.cols(); ++h)
      found_.mean.col(h) = von_mises(mean_[static_cast<std::size_t>(h)]);
  }

  /// All sectors at some samples. Threads share the nodes, so that the result does not depend on their number.
  void add(const std::vector<SampledWaves>& waves, const Samples& at, int sectors, int sector_count) {
    std::vector<Eigen::MatrixXd> factors;
    for (const SampledWaves& wave : waves) factors.push_back(real_factors(wave.coefficients));
    std::vector<std::vector<std::complex<double>>> phases(static_cast<std::size_t>(sectors));
    for (int j = 0; j < sectors; ++j)
      for (const SampledWaves& wave : waves)
        phases[static_cast<std::size_t>(j)].push_back(sector_phase(wave.nodal_diameter, j, sector_count));
    std::atomic<Eigen::Index> next = 0;
    work_together(static_cast<int>(std::thread::hardware_concurrency()), [&] {
      Block block;
      for (Eigen::Index first = 0; (first = next.fetch_add(nodes_at_once)) < spin_.cols();) {
        const Eigen::Index count = std::min(nodes_at_once, spin_.cols() - first);
        block.take_nodes(waves, first, count);
        add(block, factors, phases, first, count, at);
      }
    });
  }

  /// The largest values; nothing may be added later.
  CycleStress found() && {
    for (Eigen::VectorXd* const square : {&found_.vibration, &found_.both, &found_.displacement})
      *square = square->cwiseSqrt();
    found_.alternating = found_.alternating.cwiseSqrt();
    return std::move(found_);
  }

 private:
  /// The block's nodes, from `first` on.
  void add(Block& block, const std::vector<Eigen::MatrixXd>& factors,
           const std::vector<std::vector<std::complex<double>>>& phases, Eigen::Index first, Eigen::Index count,
           const Samples& at) {
    const Components spin = by_component(spin_, first, count);
    std::vector<Components> spin_less_mean;
    for (const Tensors& mean : mean_) spin_less_mean.push_back(spin - by_component(mean, first, count));
    Components now;
    const Eigen::Index samples = factors.front().cols() / 2;
    for (Eigen::Index begin = 0; begin < samples; begin += samples_at_once) {
      const Eigen::Index taken = std::min(samples_at_once, samples - begin);
      block.take_samples(factors, begin, taken);
      for (Eigen::Index s = 0; s < taken; ++s)
        for (std::size_t j = 0; j < phases.size(); ++j) {
          block.sum(s, phases[j], now);
          keep(now.leftCols<3>().square().rowwise().sum(), found_.displacement.segment(first, count));
          keep_vibration(von_mises_square(now, 3), first, static_cast<int>(j),
                         at.first + at.stride * static_cast<int>(begin + s));
          keep(von_mises_square(now.rightCols<6>() + spin), found_.both.segment(first, count));
          if (mean_.empty()) continue;
          const std::size_t history = j % mean_.size();
          keep(von_mises_square(now.rightCols<6>() + spin_less_mean[history]),
               found_.alternating.col(static_cast<Eigen::Index>(history)).segment(first, count));
        }
    }
  }

  void keep_vibration(const Eigen::ArrayXd& square, Eigen::Index first, int sector, int sample) {
    for (Eigen::Index k = 0; k < square.size(); ++k) {
      if (square[k] <= found_.vibration[first + k]) continue;
      found_.vibration[first + k] = square[k];
      found_.sector[first + k] = sector;
      found_.sample[first + k] = sample;
    }
  }

  template <class Segment>
  static void keep(const Eigen::ArrayXd& square, Segment largest) {
    largest = largest.cwiseMax(square.matrix());
  }

  const Tensors& spin_;
  std::vector<Tensors> mean_;
  CycleStress found_;  ///< until found(): squares of displacement and of the stress but for that of the spin
};

}  // namespace

CycleStress cycle_stress(const WheelCycle& cycle, const Tensors& spin, int sector_count, const WaveRecovery& recover,
                         int most_fields, Progress& progress) {
  int count = cycle.samples();
  std::vector<SampledWaves> waves = recovered(cycle, 0, count, recover, most_fields);
  std::vector<Tensors> mean;
  if (cycle.whole)
    mean = mean_stress(cycle, spin, sector_count,
                       count == cycle.samples() ? means(waves) : recovered_means(cycle, recover));
  Maxima maxima(spin, std::move(mean));
  for (int first = 0;;) {
    maxima.add(waves, {cycle.first_sample + cycle.stride * first, cycle.stride}, cycle.sectors, sector_count);
    for (int s = 0; s < count; ++s) progress.advance();
    first += count;
    if (first == cycle.samples()) break;
    count = std::min(count, cycle.samples() - first);
    waves = recovered(cycle, first, count, recover, most_fields);
  }
  return std::move(maxima).found();
}

}  // namespace tiprub::postprocess
