// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/contact_map.h"

#include <algorithm>

#include "simulate/motion/casing_areas.h"

namespace tiprub {

double contact_contrast(const Eigen::VectorXd& column) {
  const double sum = column.sum();
  if (sum <= 0) return 0.0;
  return 1 - sum * sum / (static_cast<double>(column.size()) * column.squaredNorm());
}

int contact_clusters(const Eigen::VectorXd& column) {
  constexpr double cluster_level = 0.5;
  if (column.size() == 0 || column.maxCoeff() <= 0) return 0;
  const double level = cluster_level * column.maxCoeff();
  const Eigen::Index areas = column.size();
  const auto dark = [&](Eigen::Index area) { return column[(area + areas) % areas] >= level; };
  int starts = 0;  // a dark area after two light ones
  for (Eigen::Index area = 0; area < areas; ++area) starts += dark(area) && !dark(area - 1) && !dark(area - 2);
  return std::max(starts, 1);
}

Eigen::VectorXd contact_shares(const SpeedResponse& speed, int sector_count, const ContactLine& contact, int node) {
  const auto areas = static_cast<int>(speed.contact_count.cols());
  const CasingSteps way{contact.position(node, 1), 0, sector_count, speed.steps_per_revolution};
  const Eigen::VectorXi steps = steps_over_areas(way, areas);
  Eigen::VectorXd share(areas);
  int last = areas - 1;  // area over which a step began
  while (last > 0 && steps[last] == 0) --last;
  for (int area = 0; area < areas; ++area) {
    if (steps[area] > 0) last = area;
    share[area] = static_cast<double>(speed.contact_count(node, last)) / (steps[last] * speed.recorded_revolutions);
  }
  return share;
}

ContactMap contact_map(const Response& response, const ContactLine& contact, int node) {
  const auto speeds = static_cast<Eigen::Index>(response.speeds.size());
  const Eigen::Index areas = speeds == 0 ? 0 : response.speeds.front().contact_count.cols();
  ContactMap map{Eigen::MatrixXd(areas, speeds), Eigen::VectorXd(speeds), Eigen::VectorXi(speeds)};
  for (Eigen::Index i = 0; i < speeds; ++i) {
    map.share.col(i) =
        contact_shares(response.speeds[static_cast<std::size_t>(i)], response.scene.sector_count, contact, node);
    map.contrast[i] = contact_contrast(map.share.col(i));
    map.clusters[i] = contact_clusters(map.share.col(i));
  }
  return map;
}

}  // namespace tiprub
