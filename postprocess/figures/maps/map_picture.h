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

/// [mm] the total over speed and frequency; NaN at speeds without a response.
Eigen::MatrixXf map_pixels(const Study& study, const InteractionMap& map, int columns, int rows);
/// Likewise, of the edge asked for, the part of one nodal diameter.
Eigen::MatrixXf part_pixels(const Study& study, int nodal_diameter, int columns, int rows);

}  // namespace tiprub
