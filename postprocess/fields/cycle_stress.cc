// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/cycle_stress.h"

#include <algorithm>
#include <complex>
#include <utility>

#include "cases/program/machine.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub::postprocess {

namespace {

FewStates few_of(const Eigen::MatrixXcd& states) {
  constexpr double left_out = 1e-7;  // of the largest one: fields.h5 has single precision
  if (states.cols() == 1) return {states, Eigen::MatrixXcd::Ones(1, 1)};
  Eigen::ColPivHouseholderQR<Eigen::MatrixXcd> qr(states);
  qr.setThreshold(left_out);
  const Eigen::Index few = std::max<Eigen::Index>(qr.rank(), 1);
  const Eigen::MatrixXcd first_rows = qr.matrixR().topRows(few).triangularView<Eigen::Upper>();
  return {qr.householderQ() * Eigen::MatrixXcd::Identity(states.rows(), few),
          first_rows * qr.colsPermutation().transpose()};
}

/// By nodal diameter. `count` is halved until no more than `most_fields` are needed, or one sample is left.
std::vector<SampledWaves> recovered(const WheelCycle& cycle, int first, int& count, const WaveRecovery& recover,
                                    int most_fields) {
  const std::vector<FewStates> few = few_states(cycle, first, count);
  if (fields_of(few) > most_fields && count > 1) return recovered(cycle, first, count /= 2, recover, most_fields);
  std::vector<SampledWaves> waves;
  for (std::size_t i = 0; i < few.size(); ++i) waves.push_back({recover(i, few[i].basis), few[i].coefficients});
  return waves;
}

/// The means of waves over their samples.
std::vector<WaveField> means(const std::vector<SampledWaves>& waves) {
  std::vector<WaveField> all;
  for (const auto& [fields, coefficients] : waves) {
    const Eigen::VectorXcd factors = coefficients.rowwise().mean();
    WaveField mean{fields[0].nodal_diameter, factors[0] * fields[0].displacement, factors[0] * fields[0].stress};
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

constexpr Eigen::Index nodes_at_once = 32;  // their components on all sectors fit into a processor's second cache

/// A column for each component, a row for each node: sums and products then run along the memory, several at once.
using Components = Eigen::ArrayXXd;
using ConstComponents = Eigen::Map<const Components>;

Components by_component(const Tensors& tensors, Eigen::Index first, Eigen::Index count) {
  return tensors.middleCols(first, count).transpose();
}

/// [Pa^2] The square of the von Mises stress in six columns.
template <class Stress>
Eigen::ArrayXd von_mises_square(const Stress& stress) {
  const auto s = [&](Eigen::Index k) { return stress.col(k); };
  return 0.5 * ((s(0) - s(1)).square() + (s(1) - s(2)).square() + (s(2) - s(0)).square()) +
         3 * (s(3).square() + s(4).square() + s(5).square());
}

constexpr Eigen::Index rows_of_node = 9;      // x, y, z of the displacement, then the stress
constexpr Eigen::Index samples_at_once = 32;  // of the sums at these nodes, which then stay in a second cache

/// The factors of the real parts of a wave's fields, then of their imaginary ones, by sample.
struct SampleFactors {
  Eigen::MatrixXd real, imaginary;  ///< that make the real part of the sum, and its imaginary part

  explicit SampleFactors(const Eigen::MatrixXcd& coefficients)
      : real(2 * coefficients.rows(), coefficients.cols()), imaginary(real.rows(), real.cols()) {
    real << coefficients.real(), -coefficients.imag();
    imaginary << coefficients.imag(), coefficients.real();
  }
};

/// Some nodes: a row for each component and node. Its memory is used again from nodes to nodes.
class Block {
 public:
  void take_nodes(const std::vector<SampledWaves>& waves, Eigen::Index first, Eigen::Index count) {
    shapes_.resize(waves.size());
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

  /// The waves at some samples, with the factors of these.
  void take_samples(const std::vector<SampleFactors>& factors, Eigen::Index first, Eigen::Index count) {
    const Eigen::Index rows = shapes_.front().rows(), columns = 2 * static_cast<Eigen::Index>(factors.size());
    parts_.resize(rows, columns * count);
    double* into = parts_.data();
    for (std::size_t i = 0; i < factors.size(); ++i)
      for (const Eigen::MatrixXd* of_part : {&factors[i].real, &factors[i].imaginary}) {
        Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>(into, rows, count, {columns * rows}).noalias() =
            shapes_[i] * of_part->middleCols(first, count);
        into += rows;
      }
  }

  /// The sum of the waves at one of these samples, by sector. `phases`: for each wave, the factor of its real part
  /// and of its imaginary one; by sector.
  void sum(Eigen::Index sample, const Eigen::MatrixXd& phases, Eigen::MatrixXd& now) const {
    now.noalias() = parts_.middleCols(phases.rows() * sample, phases.rows()) * phases;
  }

 private:
  std::vector<Eigen::MatrixXd> shapes_;  // by waves
  Eigen::MatrixXd parts_;                // by sample, then wave, real and imaginary
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
    std::vector<SampleFactors> factors;
    Eigen::MatrixXd phases(2 * static_cast<Eigen::Index>(waves.size()), sectors);
    for (const SampledWaves& wave : waves) {
      const auto row = 2 * static_cast<Eigen::Index>(factors.size());
      factors.emplace_back(wave.coefficients);
      for (int j = 0; j < sectors; ++j) {
        const std::complex<double> phase = sector_phase(wave.fields.front().nodal_diameter, j, sector_count);
        phases.col(j).segment<2>(row) << phase.real(), -phase.imag();
      }
    }
    work_on_pieces(spin_.cols(), nodes_at_once, 0, [&](Eigen::Index first, Eigen::Index count) {
      Block block;
      block.take_nodes(waves, first, count);
      add(block, factors, phases, first, count, at);
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
  void add(Block& block, const std::vector<SampleFactors>& factors, const Eigen::MatrixXd& phases, Eigen::Index first,
           Eigen::Index count, const Samples& at) {
    const Components spin = by_component(spin_, first, count);
    std::vector<Components> spin_less_mean;
    for (const Tensors& mean : mean_) spin_less_mean.push_back(spin - by_component(mean, first, count));
    Eigen::MatrixXd now;
    const Eigen::Index samples = factors.front().real.cols();
    for (Eigen::Index begin = 0; begin < samples; begin += samples_at_once) {
      const Eigen::Index taken = std::min(samples_at_once, samples - begin);
      block.take_samples(factors, begin, taken);
      for (Eigen::Index s = 0; s < taken; ++s) {
        block.sum(s, phases, now);
        for (Eigen::Index j = 0; j < now.cols(); ++j) {
          const ConstComponents moved(now.col(j).data(), count, 3), stress(moved.data() + moved.size(), count, 6);
          keep(moved.square().rowwise().sum(), found_.displacement.segment(first, count));
          keep_vibration(von_mises_square(stress), first, static_cast<int>(j),
                         at.first + at.stride * static_cast<int>(begin + s));
          keep(von_mises_square(stress + spin), found_.both.segment(first, count));
          if (mean_.empty()) continue;
          const auto history = j % static_cast<Eigen::Index>(mean_.size());
          keep(von_mises_square(stress + spin_less_mean[static_cast<std::size_t>(history)]),
               found_.alternating.col(history).segment(first, count));
        }
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

std::vector<FewStates> few_states(const WheelCycle& cycle, Eigen::Index first, Eigen::Index count) {
  std::vector<FewStates> few;
  for (const Eigen::MatrixXcd& states : cycle.states) few.push_back(few_of(states.middleCols(first, count)));
  return few;
}

int fields_of(const std::vector<FewStates>& few) {
  Eigen::Index fields = 0;
  for (const FewStates& of_diameter : few) fields += of_diameter.basis.cols();
  return static_cast<int>(fields);
}

CycleStress cycle_stress(const WheelCycle& cycle, const Tensors& spin, int sector_count,
                         const std::vector<SampledWaves>& waves) {
  std::vector<Tensors> mean;
  if (cycle.whole) mean = mean_stress(cycle, spin, sector_count, means(waves));
  Maxima maxima(spin, std::move(mean));
  maxima.add(waves, {cycle.first_sample, cycle.stride}, cycle.sectors, sector_count);
  return std::move(maxima).found();
}

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
