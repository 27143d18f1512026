// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/sector_stress.h"

#include <algorithm>
#include <complex>
#include <iterator>
#include <set>
#include <string>

#include "cases/program/errors.h"
#include "cases/program/signal_cleanup.h"
#include "postprocess/fields/field_recovery.h"
#include "postprocess/fields/node_stress.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

constexpr double wave_memory = 1 << 30;      // [bytes] for the waves of a cycle
constexpr int samples_of_a_revolution = 60;  // that suffice to find the nodes that may matter
constexpr double may_be_largest = 0.7;       // of a value at these samples
constexpr double left_out = 5e-3;            // of the norm of these samples' states

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
    const Eigen::VectorXd severity = stress.alternating.col(h);
    add_large(severity, zones, nodes);
    if (!strength) continue;
    add_large(goodman_utilisation<Eigen::VectorXd>(*strength, severity, stress.mean.col(h)), zones, nodes);
  }
  return {nodes.begin(), nodes.end()};
}

}  // namespace

int samples_on_sector(const WheelCycle& cycle) {
  const int stride = stride_of(cycle);
  return (cycle.samples() + stride - 1) / stride;
}

SectorStress::SectorStress(const FieldsReader& reader, const CellStress& bricks, const ReducedModel& model,
                           const std::vector<int>& nodal_diameters, const StressZones& zones,
                           const std::optional<MaterialStrength>& strength)
    : reader_(reader),
      bricks_(bricks),
      model_(model),
      nodal_diameters_(nodal_diameters),
      zones_(zones),
      strength_(strength),
      most_fields_(fields_at_once(reader.sector().nodes.cols())) {}

void SectorStress::over(const std::vector<At>& cycles, Progress& progress, const Take& take) const {
  const int most = most_fields_, sectors = reader_.sector().sector_count;
  const auto alone = [&](std::size_t i, const Eigen::MatrixXcd& states) { return recover(i, states); };
  for (std::size_t first = 0; first < cycles.size();) {
    std::vector<OnSector> together = {on_sector(cycles[first])};
    int fields = fields_of(together.front().few);
    const bool is_long = fields > most;
    while (!is_long && first + together.size() < cycles.size()) {
      OnSector next = on_sector(cycles[first + together.size()]);
      if ((fields += fields_of(next.few)) > most) break;
      together.push_back(std::move(next));
    }
    const std::vector<std::vector<SampledWaves>> waves =
        is_long ? std::vector<std::vector<SampledWaves>>(1) : recover(together);
    for (std::size_t k = 0; k < together.size(); ++k) {
      const auto& [cycle, speed] = cycles[first + k];
      const WheelCycle& some = together[k].cycle;
      const Tensors spin = spin_at(speed).stress.real();
      CycleStress stress = is_long ? cycle_stress(some, spin, sectors, alone, most, progress)
                                   : cycle_stress(some, spin, sectors, waves[k]);
      for (int s = 0; !is_long && s < some.samples(); ++s) progress.advance();
      if (some.stride > cycle.stride) look_closer(cycle, spin, stress);
      take(first + k, stress);
    }
    first += together.size();
  }
}

SectorStress::OnSector SectorStress::on_sector(const At& at) const {
  const int stride = stride_of(at.cycle);
  OnSector on{at.cycle, {}};
  if (stride > 1) {
    std::vector<Eigen::MatrixXcd> stiffness;
    for (const int n : nodal_diameters_)
      stiffness.push_back(model_.nodal_diameters[static_cast<std::size_t>(n)].stiffness(at.speed));
    on.cycle = of_fewer_states(every(stride, at.cycle), stiffness, left_out);
  }
  on.few = few_states(on.cycle, 0, on.cycle.samples());
  return on;
}

WaveField SectorStress::spin_at(double speed) const {
  WaveField spin = spin_field(reader_.sector(), bricks_, speed);
  require_sound_stress(spin, reader_.path());
  return spin;
}

std::vector<std::vector<SampledWaves>> SectorStress::recover(const std::vector<OnSector>& cycles) const {
  std::vector<std::vector<SampledWaves>> waves(cycles.size());
  for (std::size_t i = 0; i < nodal_diameters_.size(); ++i) {
    Eigen::Index columns = 0;
    for (const OnSector& at : cycles) columns += at.few[i].basis.cols();
    Eigen::MatrixXcd states(cycles.front().few[i].basis.rows(), columns);
    Eigen::Index column = 0;
    for (const OnSector& at : cycles) {
      states.middleCols(column, at.few[i].basis.cols()) = at.few[i].basis;
      column += at.few[i].basis.cols();
    }
    std::vector<WaveField> fields = recover(i, states);
    auto field = std::make_move_iterator(fields.begin());
    for (std::size_t k = 0; k < cycles.size(); ++k) {
      const FewStates& few = cycles[k].few[i];
      const auto end = field + few.basis.cols();
      waves[k].push_back({std::vector<WaveField>(field, end), few.coefficients});
      field = end;
    }
  }
  return waves;
}

std::vector<WaveField> SectorStress::recover(std::size_t diameter, const Eigen::MatrixXcd& states) const {
  stop_if_interrupted();
  const int n = nodal_diameters_[diameter];
  const Eigen::MatrixXcd found = reader_.expand(n, states);
  std::vector<WaveField> waves(static_cast<std::size_t>(found.cols()));
  for (std::size_t i = 0; i < waves.size(); ++i)
    waves[i] = {n, cartesian(reader_.sector(), found.col(static_cast<Eigen::Index>(i))), {}};
  add_stress(reader_.sector(), bricks_, waves);
  for (const WaveField& wave : waves) require_sound_stress(wave, reader_.path());
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
