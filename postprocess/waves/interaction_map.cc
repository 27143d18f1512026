// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/waves/interaction_map.h"

#include <algorithm>

namespace tiprub {

InteractionMap interaction_map(const Response& response, const ContactLine& contact, int node, Component component) {
  InteractionMap map;
  map.node = node;
  for (const SpeedResponse& speed : response.speeds) {
    MapColumn column;
    column.speed = speed.speed;
    column.spectrum =
        travelling_spectrum(tip_motion(speed, response.scene, contact, node, component), speed.recorded_revolutions);
    column.parts = column.spectrum.by_nodal_diameter();
    column.total = column.parts.rowwise().sum();
    map.columns.push_back(std::move(column));
  }
  return map;
}

Eigen::VectorXd InteractionMap::wave(double engine_order, int signed_nodal_diameter) const {
  Eigen::VectorXd curve(static_cast<Eigen::Index>(columns.size()));
  for (Eigen::Index i = 0; i < curve.size(); ++i)
    curve[i] = columns[static_cast<std::size_t>(i)].spectrum.at(engine_order, signed_nodal_diameter);
  return curve;
}

double InteractionMap::largest() const {
  double largest = 0;
  for (const MapColumn& column : columns)
    if (column.total.size() > 1) largest = std::max(largest, column.total.tail(column.total.size() - 1).maxCoeff());
  return largest;
}

Eigen::VectorXd energy_shares(const InteractionMap& map) {
  Eigen::VectorXd energy;
  for (const MapColumn& column : map.columns) {
    TravellingSpectrum squared = column.spectrum;
    squared.amplitude = squared.amplitude.cwiseAbs2();
    squared.amplitude.row(0).setZero();
    const Eigen::VectorXd here = squared.by_nodal_diameter().colwise().sum().transpose();
    energy = energy.size() == 0 ? here : Eigen::VectorXd(energy + here);
  }
  const double sum = energy.sum();
  return sum > 0 ? Eigen::VectorXd(energy / sum) : energy;
}

double subharmonic_share(const TravellingSpectrum& spectrum) {
  double all = 0, fractional = 0;
  for (int line = 1; line < spectrum.lines(); ++line) {
    const double here = spectrum.amplitude.row(line).squaredNorm();
    all += here;
    if (line % spectrum.revolutions != 0) fractional += here;
  }
  return all > 0 ? fractional / all : 0.0;
}

}  // namespace tiprub
