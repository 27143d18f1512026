// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/contact_map.h"

#include <algorithm>

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

ContactMap contact_map(const Response& response, int node) {
  Eigen::Index areas = 0;
  for (const SpeedResponse& speed : response.speeds)
    areas = std::max<Eigen::Index>(areas, speed.contact_count.cols());
  const auto speeds = static_cast<Eigen::Index>(response.speeds.size());
  ContactMap map{Eigen::MatrixXd::Zero(areas, speeds), Eigen::VectorXd::Zero(speeds), Eigen::VectorXi::Zero(speeds)};
  for (Eigen::Index i = 0; i < speeds; ++i) {
    const SpeedResponse& speed = response.speeds[static_cast<std::size_t>(i)];
    if (!speed.failure.empty()) continue;
    const double steps = static_cast<double>(speed.steps_per_revolution) * speed.recorded_revolutions;
    map.share.col(i) = speed.contact_count.row(node).transpose().cast<double>() * static_cast<double>(areas) / steps;
    map.contrast[i] = contact_contrast(map.share.col(i));
    map.clusters[i] = contact_clusters(map.share.col(i));
  }
  return map;
}

}  // namespace tiprub
