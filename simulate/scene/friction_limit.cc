// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/friction_limit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <optional>
#include <vector>

#include "cases/program/text.h"
#include "cases/program/units.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub::simulate {

namespace {

/// [m/N] The static compliance of the wheel at the contact dofs of a sector, loaded there; nothing if it has none.
std::optional<Eigen::MatrixXd> tip_compliance(const ReducedModel& model, double speed) {
  Eigen::MatrixXd compliance = Eigen::MatrixXd::Zero(model.contact_dofs(), model.contact_dofs());
  for (int n = 0; n <= model.nodal_diameter_max(); ++n) {
    const Eigen::MatrixXcd K = model.nodal_diameters[n].stiffness(speed);
    const Eigen::MatrixXcd forces = Eigen::MatrixXcd::Identity(K.rows(), model.contact_dofs());
    const double share = static_cast<double>(wave_count(n, model.sector_count)) / model.sector_count;
    const Eigen::LLT<Eigen::MatrixXcd> factor(K);
    if (factor.info() != Eigen::Success) return {};
    compliance += share * factor.solve(forces).topRows(model.contact_dofs()).real();
  }
  return compliance;
}

/// Of each contact node at a speed [rad/s]; none if the rotor is statically unstable there.
std::vector<FrictionLimit> limits_of_nodes(const ReducedModel& model, double speed) {
  std::vector<FrictionLimit> limits;
  const std::optional<Eigen::MatrixXd> compliance = tip_compliance(model, speed);
  for (int k = 0; compliance && k < model.contact.size(); ++k) {
    const Eigen::RowVector3d by_normal =
        model.contact.normal.row(k) * compliance->block<3, 3>(3 * static_cast<Eigen::Index>(k), 3 * k);
    if (by_normal[1] < 0) limits.push_back({-by_normal.dot(model.contact.normal.row(k)) / by_normal[1], k, speed});
  }
  return limits;
}

/// The one that is the smallest beside the coefficient of its node, at standstill and at the model's highest speed.
FrictionLimit nearest(const ReducedModel& model, const Eigen::VectorXd& coefficients) {
  std::vector<FrictionLimit> limits = limits_of_nodes(model, 0), fastest = limits_of_nodes(model, model.speed_max);
  limits.insert(limits.end(), fastest.begin(), fastest.end());
  const auto reserve = [&](const FrictionLimit& limit) { return limit.coefficient / coefficients[limit.node]; };
  const auto found = std::ranges::min_element(limits, {}, reserve);
  return found == limits.end() ? FrictionLimit{} : *found;
}

}  // namespace

std::string FrictionLimit::text() const {
  if (coefficient == std::numeric_limits<double>::infinity()) return "no contact node jams, whatever the friction";
  return text_of("from a friction coefficient of ", coefficient, " on, contact node ", node, " (from 0) jams at ",
                 speed * rpm_per_rad_s, " rev/min: friction pushes it into the casing");
}

FrictionLimit friction_limit(const ReducedModel& model) {
  return nearest(model, Eigen::VectorXd::Ones(model.contact.size()));
}

void require_friction_that_slides(const CaseTable& table, const Casing& casing, const SimulateParameters& parameters,
                                  const ReducedModel& model) {
  if (!casing.has_friction()) return;
  const std::string key = "friction_coefficient";
  const Eigen::VectorXd coefficients = casing.friction_at(model.contact);
  if (const FrictionLimit limit = nearest(model, coefficients); coefficients[limit.node] >= limit.coefficient) {
    table.reject(key, text_of("= ", coefficients[limit.node], " is too large: ", limit.text(), "; lower it"));
  }
  if (parameters.contact == ContactRule::paper)
    table.reject(key, "needs forces that only push; set [simulate] contact = \"complementarity\"");
}

}  // namespace tiprub::simulate
