// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "postprocess/analysis/postprocess_parameters.h"
#include "postprocess/waves/interaction_map.h"
#include "postprocess/waves/wave_label.h"

namespace tiprub {

/// A travelling wave's peak over speed, on one line of the interaction map.
struct Ridge {
  double speed = 0;  ///< [rad/s]
  WaveLabel wave;
};

/// Peaks over speed (see find_peaks()) of every wave on the whole engine orders 1 .. engine_order_max, as far as the
/// maps' colours reach down.
std::vector<Ridge> find_ridges(const InteractionMap& map, const FrequencyCurves& curves, int sector_count,
                               const PostprocessParameters& parameters);

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

}  // namespace tiprub
