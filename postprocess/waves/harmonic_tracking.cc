// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/waves/harmonic_tracking.h"

namespace tiprub {

namespace {

double part(const MapColumn& column, int engine_order, Eigen::Index nodal_diameter) {
  const Eigen::Index line = static_cast<Eigen::Index>(engine_order) * column.spectrum.revolutions;
  return line < column.parts.rows() ? column.parts(line, nodal_diameter) : 0.0;
}

}  // namespace

HarmonicTracking nodal_diameter_tracking(const InteractionMap& map, int engine_order) {
  const auto speeds = static_cast<Eigen::Index>(map.columns.size());
  const Eigen::Index count = speeds == 0 ? 0 : map.columns.front().parts.cols();
  HarmonicTracking tracking{Eigen::MatrixXd(speeds, count), {}};
  for (Eigen::Index i = 0; i < speeds; ++i)
    for (Eigen::Index n = 0; n < count; ++n)
      tracking.curves(i, n) = part(map.columns[static_cast<std::size_t>(i)], engine_order, n);
  tracking.mean = tracking.curves.rowwise().mean();
  return tracking;
}

HarmonicTracking engine_order_tracking(const InteractionMap& map, int nodal_diameter,
                                       const std::vector<int>& engine_orders) {
  const auto speeds = static_cast<Eigen::Index>(map.columns.size());
  HarmonicTracking tracking{Eigen::MatrixXd(speeds, static_cast<Eigen::Index>(engine_orders.size())), {}};
  for (Eigen::Index i = 0; i < speeds; ++i)
    for (std::size_t k = 0; k < engine_orders.size(); ++k)
      tracking.curves(i, static_cast<Eigen::Index>(k)) =
          part(map.columns[static_cast<std::size_t>(i)], engine_orders[k], nodal_diameter);
  tracking.mean = tracking.curves.rowwise().mean();
  return tracking;
}

}  // namespace tiprub
