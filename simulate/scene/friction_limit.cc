// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/friction_limit.h"

#include <Eigen/Cholesky>
#include <optional>
#include <sstream>

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

}  // namespace

std::string FrictionLimit::text() const {
  if (coefficient == std::numeric_limits<double>::infinity()) return "no contact node jams, whatever the friction";
  std::ostringstream text;
  text << "from a friction coefficient of " << coefficient << " on, contact node " << node << " (from 0) jams at "
       << speed * rpm_per_rad_s << " rev/min: friction pushes it into the casing";
  return text.str();
}

FrictionLimit friction_limit(const ReducedModel& model, double speed) {
  const std::optional<Eigen::MatrixXd> compliance = tip_compliance(model, speed);
  FrictionLimit limit;
  if (!compliance) return limit;
  for (int k = 0; k < model.contact.size(); ++k) {
    const Eigen::RowVector3d by_normal =
        model.contact.normal.row(k) * compliance->block<3, 3>(3 * static_cast<Eigen::Index>(k), 3 * k);
    const double coefficient = -by_normal.dot(model.contact.normal.row(k)) / by_normal[1];
    if (by_normal[1] < 0 && coefficient < limit.coefficient) limit = {coefficient, k, speed};
  }
  return limit;
}

FrictionLimit friction_limit(const ReducedModel& model) {
  const FrictionLimit at_rest = friction_limit(model, 0), fastest = friction_limit(model, model.speed_max);
  return fastest.coefficient < at_rest.coefficient ? fastest : at_rest;
}

void require_friction_that_slides(const CaseTable& table, const Casing& casing, const SimulateParameters& parameters,
                                  const ReducedModel& model) {
  if (casing.friction == 0) return;
  const std::string key = "friction_coefficient";
  if (const FrictionLimit limit = friction_limit(model); casing.friction >= limit.coefficient) {
    std::ostringstream text;
    text << "= " << casing.friction << " is too large: " << limit.text() << "; lower it";
    table.reject(key, text.str());
  }
  if (parameters.contact == ContactRule::paper)
    table.reject(key, "needs forces that only push; set [simulate] contact = \"complementarity\"");
}

}  // namespace tiprub::simulate
