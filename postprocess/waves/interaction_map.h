// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "postprocess/waves/tip_motion.h"
#include "postprocess/waves/travelling_spectrum.h"

namespace tiprub {

/// One speed of an interaction map. Frequencies are (line / revolutions) Omega / (2 pi).
struct MapColumn {
  double speed = 0;             ///< [rad/s]
  TravellingSpectrum spectrum;  ///< [m]
  Eigen::MatrixXd parts;  ///< [m] by nodal diameter 0 .. floor(N/2), both directions added; lines x nodal diameters
  Eigen::VectorXd total;  ///< [m] the sum of the parts (paper, fig. 22a); lines
};

/// Amplitude over speed and frequency of one contact node (paper, sec. 5.2.1), ascending in speed.
struct InteractionMap {
  int node = 0;
  std::vector<MapColumn> columns;

  /// [m] amplitude over the speeds of one travelling wave.
  Eigen::VectorXd wave(double engine_order, int signed_nodal_diameter) const;
  /// [m] the largest value of the total above frequency zero.
  double largest() const;
};

/// Needs a response at every speed.
InteractionMap interaction_map(const Response& response, const ContactLine& contact, int node, Component component);

/// Share of the mean square of the motion, without its mean, by nodal diameter; sums to 1 (or 0 without motion).
Eigen::VectorXd energy_shares(const InteractionMap& map);

/// Share of the mean square of a motion, without its mean, that is off the whole engine orders.
double subharmonic_share(const TravellingSpectrum& spectrum);

}  // namespace tiprub
