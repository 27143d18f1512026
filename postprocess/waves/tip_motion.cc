// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/waves/tip_motion.h"

namespace tiprub {

namespace {

Eigen::RowVector3d direction_of(const ContactLine& contact, int node, Component component) {
  switch (component) {
    case Component::normal:
      return contact.normal.row(node);
    case Component::radial:
      return Eigen::RowVector3d::UnitX();
    case Component::tangential:
      return Eigen::RowVector3d::UnitY();
    case Component::axial:
      return Eigen::RowVector3d::UnitZ();
  }
  return Eigen::RowVector3d::Zero();
}

}  // namespace

Eigen::MatrixXd tip_motion(const SpeedResponse& response, const SimulatedScene& scene, const ContactLine& contact,
                           int node, Component component) {
  const Eigen::Vector3d direction = direction_of(contact, node, component).transpose();
  const Eigen::Index nodes = scene.clearance.size();
  Eigen::MatrixXd motion(response.displacement.rows(), scene.sector_count);
  for (int sector = 0; sector < scene.sector_count; ++sector) {
    const Eigen::Index first = 3 * ((sector % scene.independent_sectors) * nodes + node);
    motion.col(sector) = response.displacement.middleCols(first, 3) * direction;
  }
  return motion;
}

Eigen::MatrixXd tip_force(const SpeedResponse& response, const SimulatedScene& scene, int node) {
  Eigen::MatrixXd force(response.contact_force.rows(), scene.sector_count);
  for (int sector = 0; sector < scene.sector_count; ++sector)
    force.col(sector) =
        response.contact_force.col((sector % scene.independent_sectors) * scene.clearance.size() + node);
  return force;
}

double vibration_amplitude(const Eigen::MatrixXd& motion) {
  if (motion.size() == 0) return 0.0;
  return 0.5 * (motion.colwise().maxCoeff() - motion.colwise().minCoeff()).maxCoeff();
}

}  // namespace tiprub
