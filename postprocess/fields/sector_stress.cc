// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/sector_stress.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <complex>
#include <set>
#include <string>
#include <thread>

#include "cases/program/errors.h"
#include "cases/program/machine.h"
#include "cases/program/signal_cleanup.h"
#include "postprocess/fields/field_recovery.h"
#include "postprocess/fields/node_stress.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

constexpr double wave_memory = 1 << 30;      // [bytes] for the waves of a cycle
constexpr int samples_of_a_revolution = 60;  // that suffice to find the nodes that may matter
constexpr double may_be_largest = 0.7;       // of a value at these samples

/// Squares of the stress are computed later, and stress beyond this limit comes from damaged numbers.
void require_sound_stress(const WaveField& wave, const std::string& name) {
  constexpr double largest = 1e100;  // [Pa]
  if (!(wave.stress.array().abs2() < largest * largest).all())
    throw RunError(name + ": the stress of nodal diameter " + std::to_string(wave.nodal_diameter) + " is beyond " +
                   significant(largest, 1) + " Pa or no number; the fields, or the response's states, are damaged");
}

/// How many fields of a wave, with their stress, the memory is used for. Samples that need more are taken in parts.
/// Where these begin decides the last digits, which must not depend on the memory of a machine.
int fields_at_once(Eigen::Index nodes) {
  const double numbers_at_node = 3 + 3 + 6;  // expanded, turned to x, y, z, and stress
  const double field = sizeof(std::complex<double>) * numbers_at_node * static_cast<double>(nodes);
  return std::max(1, static_cast<int>(wave_memory / field));
}

/// From one sample on the whole sector to the next: 1 if the cycle repeats itself after less than a revolution.
int stride_of(const WheelCycle& cycle) {
  if (!cycle.whole || cycle.samples() < cycle.samples_per_revolution) return 1;
  return std::max(1, cycle.samples_per_revolution / samples_of_a_revolution);
}

/// Adds the nodes whose value is at least `may_be_largest` of the largest one of their zone.
void add_large(const Eigen::VectorXd& values, const StressZones& zones, std::set<int>& nodes) {
  for (const StressZone zone : {StressZone::body, StressZone::tip_patch, StressZone::clamp_rim}) {
    const Eigen::Index largest = largest_in(zone, zones, values);
    if (largest < 0) continue;
    for (Eigen::Index node = 0; node < values.size(); ++node)
      if (zones.at_node[static_cast<std::size_t>(node)] == zone && values[node] >= may_be_largest * values[largest])
        nodes.insert(static_cast<int>(node));
  }
}

/// Ascending.
std::vector<int> nodes_that_may_matter(const CycleStress& stress, const StressZones& zones,
                                       const std::optional<MaterialStrength>& strength) {
  std::set<int> nodes;
  add_large(stress.vibration, zones, nodes);
  add_large(stress.both, zones, nodes);
  add_large(stress.displacement, zones, nodes);
  for (Eigen::Index h = 0; h < stress.alternating.cols(); ++h) {
    Eigen::VectorXd severity = stress.alternating.col(h);
    add_large(severity, zones, nodes);
    if (!strength) continue;
    for (Eigen::Index node = 0; node < severity.size(); ++node)
      severity[node] = goodman_utilisation(*strength, severity[node], stress.mean(node, h));
    add_large(severity, zones, nodes);
  }
  return {nodes.begin(), nodes.end()};
}

}  // namespace

int samples_on_sector(const WheelCycle& cycle) {
  const int stride = stride_of(cycle);
  return (cycle.samples() + stride - 1) / stride;
}

SectorStress::SectorStress(const FieldsReader& reader, const CellStress& bricks,
                           const std::vector<int>& nodal_diameters, const StressZones& zones,
                           const std::optional<MaterialStrength>& strength)
    : reader_(reader), bricks_(bricks), nodal_diameters_(nodal_diameters), zones_(zones), strength_(strength) {}

CycleStress SectorStress::operator()(const WheelCycle& cycle, double speed, Progress& progress) const {
  const WaveField spin = spin_at(speed);
  const auto recover_all = [&](std::size_t diameter, const Eigen::MatrixXcd& states) {
    return recover(diameter, states);
  };
  const SectorFields& sector = reader_.sector();
  const int stride = stride_of(cycle);
  CycleStress stress = cycle_stress(every(stride, cycle), spin.stress.real(), sector.sector_count, recover_all,
                                    fields_at_once(sector.nodes.cols()), progress);
  if (stride > 1) look_closer(cycle, spin.stress.real(), stress);
  return stress;
}

WaveField SectorStress::spin_at(double speed) const {
  WaveField spin = spin_field(reader_.sector(), bricks_, speed);
  require_sound_stress(spin, reader_.path());
  return spin;
}

void SectorStress::at_instants(const std::vector<WheelCycle>& instants, const std::vector<double>& speeds,
                               Progress& progress, const std::function<void(const CycleStress&)>& take) const {
  const int most = fields_at_once(reader_.sector().nodes.cols());
  const std::size_t together = std::max<std::size_t>(1, static_cast<std::size_t>(most) / nodal_diameters_.size());
  for (std::size_t first = 0; first < instants.size(); first += together) {
    const std::size_t count = std::min(together, instants.size() - first);
    std::vector<std::vector<WaveField>> waves;  // by nodal diameter, then instant
    for (std::size_t i = 0; i < nodal_diameters_.size(); ++i) {
      Eigen::MatrixXcd states(instants[first].states[i].rows(), static_cast<Eigen::Index>(count));
      for (std::size_t k = 0; k < count; ++k)
        states.col(static_cast<Eigen::Index>(k)) = instants[first + k].states[i].col(0);
      waves.push_back(recover(i, states));
    }
    for (std::size_t k = 0; k < count; ++k) {
      const auto own = [&](std::size_t i, const Eigen::MatrixXcd&) { return std::vector{std::move(waves[i][k])}; };
      take(cycle_stress(instants[first + k], spin_at(speeds[first + k]).stress.real(), reader_.sector().sector_count,
                        own, most, progress));
    }
  }
}

std::vector<WaveField> SectorStress::recover(std::size_t diameter, const Eigen::MatrixXcd& states) const {
  stop_if_interrupted();
  const int n = nodal_diameters_[diameter];
  const Eigen::MatrixXcd found = reader_.expand(n, states);
  std::vector<WaveField> waves(static_cast<std::size_t>(found.cols()));
  std::atomic<std::size_t> next = 0;
  work_together(static_cast<int>(std::thread::hardware_concurrency()), [&] {
    for (std::size_t i = 0; (i = next++) < waves.size();) {
      waves[i] = {n, cartesian(reader_.sector(), found.col(static_cast<Eigen::Index>(i))), {}};
      add_stress(reader_.sector(), bricks_, waves[i]);
      require_sound_stress(waves[i], reader_.path());
    }
  });
  return waves;
}

void SectorStress::look_closer(const WheelCycle& cycle, const Tensors& spin, CycleStress& stress) const {
  const std::vector<int> nodes = nodes_that_may_matter(stress, zones_, strength_);
  const NodeStress at_nodes(reader_, nodes);
  const auto recover_some = [&](std::size_t diameter, const Eigen::MatrixXcd& states) {
    stop_if_interrupted();
    std::vector<WaveField> waves = at_nodes.waves(nodal_diameters_[diameter], states);
    for (const WaveField& wave : waves) require_sound_stress(wave, reader_.path());
    return waves;
  };
  Progress unseen("", 0, Progress::Shown::never);
  const CycleStress closer = cycle_stress(cycle, spin(Eigen::all, nodes), reader_.sector().sector_count, recover_some,
                                          fields_at_once(static_cast<Eigen::Index>(nodes.size())), unseen);
  stress.vibration(nodes) = closer.vibration;
  stress.both(nodes) = closer.both;
  stress.displacement(nodes) = closer.displacement;
  stress.sector(nodes) = closer.sector;
  stress.sample(nodes) = closer.sample;
  stress.mean(nodes, Eigen::all) = closer.mean;
  stress.alternating(nodes, Eigen::all) = closer.alternating;
}

}  // namespace tiprub::postprocess
