// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "postprocess/waves/interaction_map.h"

namespace tiprub {

/// Amplitudes of points (nodal diameter, engine order) of the two-way spectrum, followed over speed (paper, sec.
/// 5.2.3), and their mean.
struct HarmonicTracking {
  Eigen::MatrixXd curves;  ///< [m] speeds x points
  Eigen::VectorXd mean;    ///< [m] over the points
};

/// At one engine order, all nodal diameters 0 .. floor(N/2) (both directions added); their mean is the paper's "mean
/// amplitude of the six bars for a given EO".
HarmonicTracking nodal_diameter_tracking(const InteractionMap& map, int engine_order);

/// At one nodal diameter (both directions added), the engine orders of a list; with 1 .. 6 the mean is the paper's.
HarmonicTracking engine_order_tracking(const InteractionMap& map, int nodal_diameter,
                                       const std::vector<int>& engine_orders);

}  // namespace tiprub
