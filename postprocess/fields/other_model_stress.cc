// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/other_model_stress.h"

#include <string>

#include "cases/program/errors.h"
#include "postprocess/fields/field_recovery.h"

namespace tiprub::postprocess {

namespace {

constexpr double nearby = 0.3;  // of the largest radius; more than the distance of two nodes

void require_dofs(const FieldsReader& other, const RotorCycle& cycle, const SimulatedScene& scene) {
  for (std::size_t i = 0; i < cycle.displacement.size(); ++i)
    if (const int n = scene.nodal_diameters[i]; cycle.displacement[i].rows() != other.dofs(n))
      throw InputError(other.path() + ": has " + std::to_string(other.dofs(n)) + " dofs at nodal diameter " +
                       std::to_string(n) + ", and the states of the response have " +
                       std::to_string(cycle.displacement[i].rows()) + "; one of both files is damaged");
}

}  // namespace

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
  const std::vector<int> near =
      nodes_near(nodes, sector, other.sector(), stress_zones(other.sector(), zones.tip_patch));
  if (near.empty())
    throw InputError(other.path() + ": has no node where the wheel is stressed most; give fields of the same wheel");
  return largest_stress(NodeStress(other, near), other, scene.nodal_diameters);
}

}  // namespace tiprub::postprocess
