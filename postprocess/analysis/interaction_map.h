// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "postprocess/analysis/postprocess_parameters.h"
#include "postprocess/waves/travelling_spectrum.h"
#include "postprocess/waves/wave_label.h"

namespace tiprub::postprocess {

/// One speed of an interaction map. Frequencies are (line / revolutions) Omega / (2 pi).
struct MapColumn {
  double speed = 0;             ///< [rad/s]
  TravellingSpectrum spectrum;  ///< [m]
  Eigen::MatrixXd parts;  ///< [m] by nodal diameter 0 .. floor(N/2), both directions added; lines x nodal diameters
  Eigen::VectorXd total;  ///< [m] the sum of the parts (paper, fig. 22a); lines
};

/// Amplitude of one contact node over speed and frequency (paper, sec. 5.2.1), ascending in speed.
struct InteractionMap {
  int node = 0;
  std::vector<MapColumn> columns;

  /// [m] The amplitude of one travelling wave at each speed.
  Eigen::VectorXd wave(double engine_order, int signed_nodal_diameter) const;
  /// [m] The largest value of the total above frequency zero.
  double largest() const;
};

/// Needs a response at every speed.
InteractionMap interaction_map(const Response& response, const ContactLine& contact, int node, Component component);

/// How the mean square of the motion, without its mean, divides over the nodal diameters; sums to 1 (0 without
/// motion).
Eigen::VectorXd energy_shares(const InteractionMap& map);

/// The share of the mean square of a motion, without its mean, that is not on whole engine orders.
double subharmonic_share(const TravellingSpectrum& spectrum);

/// Amplitudes at some points (nodal diameter, engine order) of the two-way spectrum, followed over speed (paper, sec.
/// 5.2.3), and their mean.
struct HarmonicTracking {
  Eigen::MatrixXd curves;  ///< [m] speeds x points
  Eigen::VectorXd mean;    ///< [m] over the points
};

/// All nodal diameters 0 .. floor(N/2) at one engine order, both directions added. Their mean is the paper's "mean
/// amplitude of the six bars for a given EO".
HarmonicTracking nodal_diameter_tracking(const InteractionMap& map, int engine_order);

/// These engine orders at one nodal diameter, both directions added. For 1 .. 6 the mean is the paper's.
HarmonicTracking engine_order_tracking(const InteractionMap& map, int nodal_diameter,
                                       const std::vector<int>& engine_orders);

/// A travelling wave's peak over speed, on one line of the interaction map.
struct Ridge {
  double speed = 0;  ///< [rad/s]
  WaveLabel wave;
};

/// The interaction maps of both edges of the main blade.
struct WaveMaps {
  TipEdge asked = TipEdge::leading;  ///< whose spectra, trackings and ridges are drawn
  InteractionMap leading, trailing;
  std::vector<Ridge> ridges;

  const InteractionMap& of(TipEdge edge) const { return edge == TipEdge::leading ? leading : trailing; }
  const InteractionMap& first() const { return of(asked); }
};

/// Needs a response at every speed.
WaveMaps wave_maps(const Response& response, const ContactLine& contact, const FrequencyCurves& curves,
                   const PostprocessParameters& parameters);

}  // namespace tiprub::postprocess
