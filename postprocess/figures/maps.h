// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "postprocess/analysis/interaction_map.h"
#include "postprocess/figures/axes.h"
#include "postprocess/figures/drawing.h"

namespace tiprub::postprocess {

/// Axes and colours of a map.
struct MapFrame {
  DrawnRange speed;           ///< [rpm]
  double frequency_high = 0;  ///< [Hz]
  DrawnRange amplitude;       ///< [mm] smaller amplitudes have the lowest colour: a log scale has no zero
};
/// For a study's own maps: both edges share their colours.
MapFrame map_frame(const SpeedFrame& frame, const WaveMaps& waves, const PostprocessParameters& parameters);

/// [Hz] the highest engine order at the highest speed, but not far above the families that are drawn.
double map_frequency_high(const SpeedFrame& frame);

/// [mm] the largest amplitude of both edges' maps, never zero.
double map_amplitude_high(const WaveMaps& waves);

/// Sets what scripts/map.gp reads, except the pixels.
void set_map_axes(Drawing& drawing, const SpeedFrame& frame, const MapFrame& map);

/// [mm] The total over speed and frequency; NaN where the map has no speed or one of `failed` [rpm] is nearer.
Eigen::MatrixXf map_pixels(const InteractionMap& map, const Eigen::VectorXd& failed, const MapFrame& frame,
                           int columns, int rows);

/// An edge's map and the words of its caption.
struct EdgeMap {
  TipEdge edge;
  const InteractionMap& map;
  std::string component, of_blade, remark;
};
/// "The largest amplitude of all speeds is at contact node 9, the trailing edge."
std::string largest_place(const TipAmplitudes& amplitudes, const ContactLine& contact);

/// Paper, fig. 22a.
Figure interaction_map_figure(const SpeedFrame& frame, const MapFrame& axes, const EdgeMap& edge,
                              const std::vector<SpeedResponse>& speeds);
/// Paper, fig. 22b-g; `moving`: the nodal diameters that can.
Figure interaction_map_parts_figure(const SpeedFrame& frame, const MapFrame& axes, const WaveMaps& waves,
                                    const std::vector<int>& moving);
/// Paper, fig. 18a.
Figure waterfall_figure(const SpeedFrame& frame, const InteractionMap& map);

}  // namespace tiprub::postprocess
