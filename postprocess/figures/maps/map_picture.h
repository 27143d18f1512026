// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "postprocess/analysis/study.h"
#include "postprocess/figures/figure.h"

namespace tiprub {

// What the interaction map, its parts and the waterfall share.

/// [Hz] the highest engine order at the highest speed, but not far above the families that are drawn.
double map_frequency_high(const Study& study);

/// [mm] the largest amplitude of both edges' maps, never zero: they share their colours.
double map_amplitude_high(const Study& study);

/// Half of the width of a spectral line as it is drawn, in engine orders.
double line_half_width(const TravellingSpectrum& spectrum);

/// What scripts/map.gp reads, apart from the pixels.
void set_map_axes(Drawing& drawing, const Study& study);

/// What a map is drawn over.
struct MapFrame {
  DrawnRange speed;           ///< [rpm]
  double frequency_high = 0;  ///< [Hz]
  double amplitude_low = 0;   ///< [mm] what is less has the lowest colour: log scales don't know zero
};

/// [mm] the total over speed and frequency; NaN where it has no speed, or one of `failed` [rpm] is nearer.
Eigen::MatrixXf map_pixels(const InteractionMap& map, const Eigen::VectorXd& failed, const MapFrame& frame,
                           int columns, int rows);
/// The same of a study's own map, over its own axes.
Eigen::MatrixXf map_pixels(const Study& study, const InteractionMap& map, int columns, int rows);
/// Likewise, of the edge asked for, the part of one nodal diameter.
Eigen::MatrixXf part_pixels(const Study& study, int nodal_diameter, int columns, int rows);

}  // namespace tiprub
