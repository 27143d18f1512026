// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/effects/second_order_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/cells/cell_kind.h"

namespace tiprub {

namespace {

/// [m/rad] the largest magnitude, between neighbouring points.
double steepest_slope(const Eigen::VectorXd& angle, const Eigen::VectorXd& distortion) {
  double steepest = 0;
  for (Eigen::Index i = 0; i + 1 < angle.size(); ++i)
    steepest = std::max(steepest, std::abs((distortion[i + 1] - distortion[i]) / (angle[i + 1] - angle[i])));
  return steepest;
}

}  // namespace

SecondOrderGap second_order_gap(const SpeedResponse& response, const SimulatedScene& scene,
                                const ContactLine& contact, const Eigen::VectorXd& span) {
  const double slope = steepest_slope(scene.casing_angle, scene.casing_distortion);
  SecondOrderGap gap;
  if (span.size() > 0) gap.foreshortening = 0;
  for (Eigen::Index point = 0; point < response.displacement.cols() / 3; ++point) {
    const Eigen::Index node = point % contact.size();
    const auto motion = response.displacement.middleCols(3 * point, 3);
    const Eigen::RowVector3d normal = contact.normal.row(node);
    const double radius = contact.position(node, 0), tangential = motion.col(1).cwiseAbs().maxCoeff();
    gap.curvature = std::max(gap.curvature, std::abs(normal[0]) * tangential * tangential / (2 * radius));
    gap.distortion = std::max(gap.distortion, slope * tangential / radius);
    if (!gap.foreshortening) continue;
    const Eigen::VectorXd along = motion * normal.transpose();
    const double bending = (motion - along * normal).rowwise().squaredNorm().maxCoeff();
    gap.foreshortening = std::max(*gap.foreshortening, 0.6 * bending / span[node]);
  }
  return gap;
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

}  // namespace tiprub
