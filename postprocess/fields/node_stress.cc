// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/node_stress.h"

#include <algorithm>
#include <complex>
#include <mutex>
#include <set>
#include <string>

#include "cases/program/errors.h"
#include "cases/program/machine.h"
#include "mesh/cells/cell_kind.h"
#include "postprocess/fields/field_recovery.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub::postprocess {

namespace {

constexpr Eigen::Index samples_of_product = 16;

/// The cells at some nodes, and those at their partners on the cuts, as a sector of its own.
SectorFields cells_around(const SectorFields& sector, const std::vector<int>& nodes, std::vector<int>& used) {
  std::set<int> wanted(nodes.begin(), nodes.end());
  const std::vector<int>&low = sector.node_set("cyclic_low"), &high = sector.node_set("cyclic_high");
  for (std::size_t k = 0; k < low.size(); ++k)
    if (wanted.contains(low[k]) || wanted.contains(high[k])) wanted.insert({low[k], high[k]});
  std::vector<int> cells;
  std::set<int> around;
  for (int cell = 0; cell < sector.cells.cols(); ++cell) {
    const auto of_cell = nodes_of(sector.cells, cell);
    if (std::ranges::none_of(of_cell, [&](int node) { return wanted.contains(node); })) continue;
    cells.push_back(cell);
    around.insert(of_cell.begin(), of_cell.end());
  }
  used.assign(around.begin(), around.end());
  std::vector<int> place(static_cast<std::size_t>(sector.nodes.cols()), -1);
  for (std::size_t i = 0; i < used.size(); ++i) place[static_cast<std::size_t>(used[i])] = static_cast<int>(i);
  SectorFields part;
  part.sector_count = sector.sector_count;
  part.young = sector.young;
  part.poisson = sector.poisson;
  part.nodes = sector.nodes(Eigen::all, used);
  part.cells = sector.cells(Eigen::all, cells).unaryExpr([&](int node) {
    return node < 0 ? node : place[static_cast<std::size_t>(node)];
  });
  std::vector<int>&part_low = part.node_sets["cyclic_low"], &part_high = part.node_sets["cyclic_high"];
  for (std::size_t k = 0; k < low.size(); ++k) {
    const int first = place[static_cast<std::size_t>(low[k])], second = place[static_cast<std::size_t>(high[k])];
    if (first < 0 || second < 0) continue;
    part_low.push_back(first);
    part_high.push_back(second);
  }
  return part;
}

/// Real and imaginary part of a product of complex matrices, as one product of real ones.
class RealFactors {
 public:
  explicit RealFactors(const Eigen::MatrixXcd& A) : both_(A.rows(), 2 * A.cols()) { both_ << A.real(), -A.imag(); }

  /// The real parts of A B, then the imaginary ones.
  Eigen::MatrixXd times(const Eigen::MatrixXcd& B) const {
    Eigen::MatrixXd factors(2 * B.rows(), 2 * B.cols());
    factors << B.real(), B.imag(), B.imag(), -B.real();
    return both_ * factors;
  }

 private:
  Eigen::MatrixXd both_;
};

/// The largest von Mises stress at some samples of a cycle. `stress`: by nodal diameter.
double largest_at(const std::vector<RealFactors>& stress, const std::vector<int>& nodal_diameters, int sector_count,
                  const WheelCycle& cycle, Eigen::Index first, Eigen::Index count) {
  std::vector<Eigen::MatrixXd> waves;
  for (std::size_t i = 0; i < stress.size(); ++i)
    waves.push_back(stress[i].times(cycle.states[i].middleCols(first, count)));
  double largest = 0;
  for (int j = 0; j < cycle.sectors; ++j) {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(waves.front().rows(), count);
    for (std::size_t i = 0; i < waves.size(); ++i) {
      const std::complex<double> phase = sector_phase(nodal_diameters[i], j, sector_count);
      sum += phase.real() * waves[i].leftCols(count) - phase.imag() * waves[i].rightCols(count);
    }
    largest = std::max(largest, von_mises(sum.reshaped(6, sum.size() / 6)).maxCoeff());
  }
  return largest;
}

constexpr double nearby = 0.3;  // of the largest radius; more than the distance of two nodes

void require_dofs(const FieldsReader& other, const RotorCycle& cycle, const SimulatedScene& scene) {
  for (std::size_t i = 0; i < cycle.displacement.size(); ++i)
    if (const int n = scene.nodal_diameters[i]; cycle.displacement[i].rows() != other.dofs(n))
      throw InputError(other.path() + ": has " + std::to_string(other.dofs(n)) + " dofs at nodal diameter " +
                       std::to_string(n) + ", and the states of the response have " +
                       std::to_string(cycle.displacement[i].rows()) + "; one of both files is damaged");
}

}  // namespace

std::vector<int> nodes_above(double least, const CycleStress& stress, const StressZones& zones) {
  const double largest = stress.vibration[largest_in(StressZone::body, zones, stress.vibration)];
  std::vector<int> nodes;
  for (int node = 0; node < stress.vibration.size(); ++node)
    if (zones.at_node[static_cast<std::size_t>(node)] == StressZone::body &&
        stress.vibration[node] >= least * largest)
      nodes.push_back(node);
  return nodes;
}

NodeStress::NodeStress(const FieldsReader& reader, const std::vector<int>& nodes)
    : reader_(reader), part_(cells_around(reader.sector(), nodes, used_)), cells_(part_) {
  for (const int node : nodes)
    places_.push_back(static_cast<int>(std::ranges::lower_bound(used_, node) - used_.begin()));
}

std::vector<WaveField> NodeStress::waves(int nodal_diameter, const Eigen::MatrixXcd& basis) const {
  Eigen::MatrixXcd moved(3 * static_cast<Eigen::Index>(used_.size()), basis.rows());
  for (Eigen::Index dof = 0; dof < basis.rows(); ++dof) {
    const Eigen::VectorXcd shape = reader_.shape(nodal_diameter, dof);
    for (std::size_t i = 0; i < used_.size(); ++i)
      moved.block<3, 1>(3 * static_cast<Eigen::Index>(i), dof) = shape.segment<3>(3 * used_[i]);
  }
  moved *= basis;
  std::vector<WaveField> waves;
  for (Eigen::Index k = 0; k < basis.cols(); ++k)
    waves.push_back({nodal_diameter, cartesian(part_, moved.col(k)), {}});
  add_stress(part_, cells_, waves);
  for (WaveField& wave : waves)
    wave = {nodal_diameter, wave.displacement(Eigen::all, places_), wave.stress(Eigen::all, places_)};
  return waves;
}

Eigen::MatrixXcd NodeStress::of(int nodal_diameter, const Eigen::MatrixXcd& basis) const {
  Eigen::MatrixXcd stress(6 * static_cast<Eigen::Index>(places_.size()), basis.cols());
  Eigen::Index column = 0;
  for (const WaveField& wave : waves(nodal_diameter, basis)) stress.col(column++) = wave.stress.reshaped();
  return stress;
}

LargestStress largest_stress(const NodeStress& stress, const FieldsReader& reader,
                             const std::vector<int>& nodal_diameters) {
  std::vector<RealFactors> factors;
  for (const int n : nodal_diameters)
    factors.emplace_back(stress.of(n, Eigen::MatrixXcd::Identity(reader.dofs(n), reader.dofs(n))));
  return [factors, nodal_diameters, sectors = reader.sector().sector_count](const WheelCycle& cycle) {
    std::mutex mutex;
    double largest = 0;
    work_on_pieces(cycle.samples(), samples_of_product, 0, [&](Eigen::Index first, Eigen::Index count) {
      const double here = largest_at(factors, nodal_diameters, sectors, cycle, first, count);
      const std::lock_guard lock(mutex);
      largest = std::max(largest, here);
    });
    return largest;
  };
}

void check_budget_fields(const FieldsReader& other, const Response& response) {
  bool budgeted = false, varied = false;
  for (const SpeedResponse& speed : response.speeds)
    for (const PeakVariation& peak : speed.budget) {
      budgeted = true;
      if (peak.model_digest.empty()) continue;
      varied = true;
      if (peak.model_digest != other.model_digest())
        throw InputError(other.path() +
                         ": was not written with the model that the error budgets compare with; give the fields of "
                         "[simulate] budget_model");
      if (peak.cycle) require_dofs(other, *peak.cycle, response.scene);
    }
  if (budgeted && !varied)
    throw InputError(other.path() +
                     ": no error budget of the response compares with another model ([simulate] budget_model), whose "
                     "fields these could be; leave --budget-fields out, or simulate with that key");
  sound_cells(other);
}

std::vector<int> nodes_near(const std::vector<int>& nodes, const SectorFields& sector, const SectorFields& other,
                            const StressZones& zones_of_other) {
  std::vector<bool> is_one(static_cast<std::size_t>(sector.nodes.cols()));
  for (const int node : nodes) is_one[static_cast<std::size_t>(node)] = true;
  const Eigen::Matrix3Xd places = sector.nodes(Eigen::all, nodes);
  const double reach = nearby * outer_radius(sector);
  std::vector<int> found;
  for (int node = 0; node < other.nodes.cols(); ++node) {
    if (zones_of_other.at_node[static_cast<std::size_t>(node)] != StressZone::body) continue;
    const auto squares_to = [&](const Eigen::Matrix3Xd& all) -> Eigen::RowVectorXd {
      return (all.colwise() - other.nodes.col(node)).colwise().squaredNorm();
    };
    if (squares_to(places).minCoeff() > reach * reach) continue;
    Eigen::Index nearest = 0;
    squares_to(sector.nodes).minCoeff(&nearest);
    if (is_one[static_cast<std::size_t>(nearest)]) found.push_back(node);
  }
  return found;
}

LargestStress stress_of_other_model(const FieldsReader& other, const SectorFields& sector,
                                    const std::vector<int>& nodes, const StressZones& zones,
                                    const SimulatedScene& scene) {
  const std::vector<int> near = nodes_near(nodes, sector, other.sector(), stress_zones(other.sector(), zones.width));
  if (near.empty())
    throw InputError(other.path() + ": has no node where the wheel is stressed most; give fields of the same wheel");
  return largest_stress(NodeStress(other, near), other, scene.nodal_diameters);
}

}  // namespace tiprub::postprocess
