// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/scene_needs_record.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <numbers>

#include "mesh/cells/cell_kind.h"
#include "postprocess/fields/cell_stress.h"
#include "reduce/model/dense_eigen.h"

namespace tiprub::postprocess {

namespace {

/// [m] The length of the tip line that belongs to a node or segment: half way to its neighbours. The centre of an
/// outermost segment, whose weight falls from the edge, lies half as far from the edge as from the next centre; of
/// two segments, as far.
double width_of(const ContactLine& contact, int node) {
  const bool on_splitter = node > contact.trailing_edge();
  const int first = on_splitter ? contact.trailing_edge() + 1 : 0;
  const int last = on_splitter ? contact.size() - 1 : contact.trailing_edge();
  const int before = std::max(node - 1, first), after = std::min(node + 1, last);
  const auto inset = [&](int edge, int next) {
    const bool is_end = contact.kind == ContactKind::segments && (before == edge || after == edge);
    const double share = last - first == 1 ? 1 : 0.5;
    return is_end ? share * std::abs(contact.arc_length[next] - contact.arc_length[edge]) : 0;
  };
  return 0.5 * (contact.arc_length[after] - contact.arc_length[before] + inset(first, std::min(first + 1, last)) +
                inset(last, std::max(last - 1, first)));
}

/// [1] The share of the casing's areas that any blade touches at a contact node. The counts of sector j are those of
/// sector j mod N_s, turned by the angle between the two.
double rubbed_share(const SpeedResponse& response, const SimulatedScene& scene, int nodes, int node) {
  const Eigen::Index areas = response.contact_count.cols();
  Eigen::ArrayX<bool> rubbed = Eigen::ArrayX<bool>::Constant(areas, false);
  for (Eigen::Index j = 0; j < scene.sector_count; ++j) {
    const Eigen::Index held = j % scene.independent_sectors, turn = areas * (j - held) / scene.sector_count;
    for (Eigen::Index area = 0; area < areas; ++area)
      if (response.contact_count(held * nodes + node, area) > 0) rubbed[(area + turn) % areas] = true;
  }
  return static_cast<double>(rubbed.count()) / static_cast<double>(areas);
}

constexpr int more_modes = 20;  // above the one asked for, with which it couples

/// [1] The nodes' shares of a cell's volume: the integrals of the shape functions over the reference cell.
Eigen::VectorXd node_weights(const CellKind& kind) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(kind.nodes());
  for (const ReferencePoint& point : kind.integration) weights += point.weight * kind.shape(point.at);
  return weights / weights.sum();
}

/// [1] CoriolisShift::change; `masses` [kg] of the sector's nodes, `family` from 0, at a speed [rad/s].
double coriolis_change(const FieldsReader& fields, const ReducedModel& model, const Eigen::VectorXd& masses,
                       int nodal_diameter, int family, double speed) {
  const NodalDiameterModel& matrices = model.nodal_diameters[static_cast<std::size_t>(nodal_diameter)];
  const auto [squares, vectors] = eigenpairs(matrices.stiffness(speed), matrices.M);
  const Eigen::Index count = std::min<Eigen::Index>(family + 1 + more_modes, matrices.M.rows());
  // An unstable rotor's modes below zero have no frequency.
  const Eigen::VectorXd modes = squares.head(count).cwiseMax(0.0).cwiseSqrt();
  if (!(modes[family] > 0)) return 0.0;
  const Eigen::MatrixXcd shapes = fields.expand(nodal_diameter, vectors.leftCols(count));
  const Eigen::VectorXd moved = gyroscopic_frequencies(modes, coriolis_coupling(shapes, masses), speed);
  return std::max(std::abs(moved[count + family] / modes[family] - 1),
                  std::abs(-moved[count - 1 - family] / modes[family] - 1));
}

}  // namespace

std::optional<SlidingShare> sliding_share(const SpeedResponse& response, const SimulatedScene& scene,
                                          const ContactLine& contact) {
  const int nodes = contact.size();
  Eigen::VectorXd force = Eigen::VectorXd::Zero(nodes);
  for (int sector = 0; sector < scene.independent_sectors; ++sector)
    force += response.contact_force.middleCols(sector * nodes, nodes).colwise().mean();
  SlidingShare share;
  if (!(force.maxCoeff(&share.node) > 0)) return {};
  double along = 0, squares = 0;
  for (int sector = 0; sector < scene.independent_sectors; ++sector) {
    const Eigen::MatrixX3d moves =
        response.displacement.middleCols<3>(3 * (static_cast<Eigen::Index>(sector) * nodes + share.node));
    const Eigen::VectorXd across = moves * contact.normal.row(share.node).transpose();
    const Eigen::VectorXd swing = across.array() - across.mean();
    along += swing.dot(moves.col(1));
    squares += swing.squaredNorm();
  }
  if (!(squares > 0)) return {};
  share.ratio = along / squares;
  return share;
}

CasingWear casing_wear(const SpeedResponse& response, const SimulatedScene& scene, const ContactLine& contact,
                       double coefficient, double time) {
  CasingWear worst;
  const int nodes = contact.size(), held = scene.independent_sectors;
  for (int node = 0; node < nodes; ++node) {
    double force = 0;
    for (int sector = 0; sector < held; ++sector)
      force += response.contact_force.col(sector * nodes + node).mean() / held;
    const double track = width_of(contact, node) * rubbed_share(response, scene, nodes, node);
    if (!(force > 0 && track > 0)) continue;
    const double depth =
        coefficient * scene.sector_count * force * response.speed * time / (2 * std::numbers::pi * track);
    if (depth > worst.depth) worst = {node, force, depth};
  }
  return worst;
}

Eigen::VectorXd tip_spans(const SectorFields& sector) {
  const auto disc = sector.parts.find("disc");
  if (disc == sector.parts.end()) return {};
  const std::vector<int>& tips = sector.node_set("contact");
  Eigen::VectorXd spans =
      Eigen::VectorXd::Constant(static_cast<Eigen::Index>(tips.size()), std::numeric_limits<double>::infinity());
  for (const int cell : disc->second)
    for (const int node : nodes_of(sector.cells, cell))
      for (std::size_t k = 0; k < tips.size(); ++k) {
        double& span = spans[static_cast<Eigen::Index>(k)];
        span = std::min(span, (sector.nodes.col(node) - sector.nodes.col(tips[k])).norm());
      }
  return spans;
}

Eigen::VectorXd gyroscopic_frequencies(const Eigen::VectorXd& modes, const Eigen::MatrixXcd& coupling, double speed) {
  const Eigen::Index n = modes.size();
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Zero(2 * n, 2 * n);
  matrix.topRightCorner(n, n).diagonal() = modes.cast<std::complex<double>>();
  matrix.bottomLeftCorner(n, n).diagonal() = modes.cast<std::complex<double>>();
  matrix.bottomRightCorner(n, n) = std::complex<double>(0, 2 * speed) * coupling;
  return eigenvalues(matrix);
}

Eigen::VectorXd node_volumes(const SectorFields& sector) {
  const Eigen::VectorXd cells = CellStress(sector).volumes();
  std::map<int, Eigen::VectorXd> weights;  // by number of nodes
  for (const CellKind& kind : all_cell_kinds()) weights[kind.nodes()] = node_weights(kind);
  Eigen::VectorXd volumes = Eigen::VectorXd::Zero(sector.nodes.cols());
  for (Eigen::Index cell = 0; cell < sector.cells.cols(); ++cell) {
    const auto nodes = nodes_of(sector.cells, cell);
    volumes(nodes) += cells[cell] * weights[static_cast<int>(nodes.size())];
  }
  return volumes;
}

Eigen::MatrixXcd coriolis_coupling(const Eigen::MatrixXcd& shapes, const Eigen::VectorXd& masses) {
  const Eigen::Index nodes = masses.size();
  const auto component = [&](Eigen::Index c) -> Eigen::MatrixXcd {
    return shapes(Eigen::seqN(c, nodes, Eigen::fix<3>), Eigen::all);
  };
  const Eigen::MatrixXcd r = component(0), theta = component(1);
  return theta.adjoint() * masses.asDiagonal() * r - r.adjoint() * masses.asDiagonal() * theta;
}

std::optional<double> mesh_shift(const ReducedModel& model, const WaveLabel& wave) {
  if (!model.mesh_error || wave.family >= model.mesh_error->frequency.cols()) return {};
  return model.mesh_error->frequency(std::abs(wave.signed_nodal_diameter), wave.family);
}

FieldEffects field_effects(const FieldsReader& fields, const ReducedModel& model,
                           const std::vector<CriticalSpeed>& critical) {
  FieldEffects effects{.tip_span = tip_spans(fields.sector())};
  const Eigen::VectorXd masses = fields.sector().density * node_volumes(fields.sector());
  for (const CriticalSpeed& peak : critical) {
    const int n = std::abs(peak.naming_wave().signed_nodal_diameter), family = peak.naming_wave().family;
    const double change = coriolis_change(fields, model, masses, n, family, peak.speed);
    if (!effects.coriolis || change > effects.coriolis->change) effects.coriolis = {change, peak.speed, n, family};
  }
  return effects;
}

}  // namespace tiprub::postprocess
