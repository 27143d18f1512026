// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "postprocess/waves/aliasing.h"
#include "postprocess/waves/frequency_curves.h"

namespace tiprub {

/// A travelling wave of the response, and the natural mode next to it.
struct WaveLabel {
  double engine_order = 0;        ///< a fraction for a subharmonic
  int signed_nodal_diameter = 0;  ///< see aliasing.h
  double amplitude = 0;           ///< [m]
  WaveDirection direction = WaveDirection::standing;
  int family = 0;                ///< whose frequency at this nodal diameter and speed is nearest; 0 is the lowest
  double natural_frequency = 0;  ///< [Hz] of that family
  double detuning = 0;           ///< [1] (engine order Omega/(2 pi) - natural frequency) / natural frequency
};

/// Fills in direction, family and detuning of a wave at a speed [rad/s].
WaveLabel label_wave(const FrequencyCurves& curves, int sector_count, double speed, double engine_order,
                     int signed_nodal_diameter, double amplitude);

/// "6", "5.5": an engine order of a subharmonic is no whole number.
std::string engine_order_text(double engine_order);
/// "EO 6", "EO 5.5".
std::string engine_order_name(double engine_order);
/// "EO 6 ND -4", "EO 4 ND +4".
std::string wave_name(double engine_order, int signed_nodal_diameter);
std::string wave_name(const WaveLabel& wave);

}  // namespace tiprub
