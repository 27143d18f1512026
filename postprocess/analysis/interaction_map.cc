// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/interaction_map.h"

#include <algorithm>
#include <cmath>

#include "simulate/response/peaks.h"

namespace tiprub::postprocess {

namespace {

double part(const MapColumn& column, int engine_order, Eigen::Index nodal_diameter) {
  const Eigen::Index line = static_cast<Eigen::Index>(engine_order) * column.spectrum.revolutions;
  return line < column.parts.rows() ? column.parts(line, nodal_diameter) : 0.0;
}

/// `amplitude(column, k)` for each speed, and `count` curves.
template <class Amplitude>
HarmonicTracking tracked(const InteractionMap& map, Eigen::Index count, const Amplitude& amplitude) {
  HarmonicTracking tracking{Eigen::MatrixXd(static_cast<Eigen::Index>(map.columns.size()), count), {}};
  for (Eigen::Index i = 0; i < tracking.curves.rows(); ++i)
    for (Eigen::Index k = 0; k < count; ++k)
      tracking.curves(i, k) = amplitude(map.columns[static_cast<std::size_t>(i)], k);
  tracking.mean = tracking.curves.rowwise().mean();
  return tracking;
}

/// Peaks over speed (see find_peaks()) of every wave on the whole engine orders 1 .. engine_order_max, except those
/// that are too small for the maps' colours.
std::vector<Ridge> find_ridges(const InteractionMap& map, const FrequencyCurves& curves, int sector_count,
                               const PostprocessParameters& parameters) {
  const double floor = map.largest() * std::pow(10.0, -parameters.amplitude_decades);
  std::vector<Ridge> ridges;
  for (int order = 1; order <= parameters.engine_order_max; ++order)
    for (int column = 0; column < sector_count; ++column) {
      const int n = signed_nodal_diameter(column, sector_count);
      const Eigen::VectorXd curve = map.wave(order, n);
      for (const Peak& peak : find_peaks(curve, parameters.prominence)) {
        if (curve[peak.index] < floor) continue;
        const double speed = map.columns[static_cast<std::size_t>(peak.index)].speed;
        ridges.push_back({speed, label_wave(curves, sector_count, speed, order, n, curve[peak.index])});
      }
    }
  return ridges;
}

}  // namespace

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

HarmonicTracking nodal_diameter_tracking(const InteractionMap& map, int engine_order) {
  return tracked(map, map.columns.empty() ? 0 : map.columns.front().parts.cols(),
                 [&](const MapColumn& column, Eigen::Index n) { return part(column, engine_order, n); });
}

HarmonicTracking engine_order_tracking(const InteractionMap& map, int nodal_diameter,
                                       const std::vector<int>& engine_orders) {
  return tracked(map, static_cast<Eigen::Index>(engine_orders.size()), [&](const MapColumn& column, Eigen::Index k) {
    return part(column, engine_orders[static_cast<std::size_t>(k)], nodal_diameter);
  });
}

WaveMaps wave_maps(const Response& response, const ContactLine& contact, const FrequencyCurves& curves,
                   const PostprocessParameters& parameters) {
  const auto map_of = [&](int node) { return interaction_map(response, contact, node, parameters.component); };
  WaveMaps maps{parameters.edge, map_of(0), map_of(contact.trailing_edge()), {}};
  maps.ridges = find_ridges(maps.first(), curves, response.scene.sector_count, parameters);
  return maps;
}

}  // namespace tiprub::postprocess
