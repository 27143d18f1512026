// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/waves/wave_label.h"

#include <cstdlib>

#include "postprocess/tables/table.h"
#include "postprocess/tables/units.h"

namespace tiprub {

WaveLabel label_wave(const FrequencyCurves& curves, int sector_count, double speed, double engine_order,
                     int signed_nodal_diameter, double amplitude) {
  WaveLabel label;
  label.engine_order = engine_order;
  label.signed_nodal_diameter = signed_nodal_diameter;
  label.amplitude = amplitude;
  label.direction = wave_direction(signed_nodal_diameter, sector_count);
  const int nodal_diameter = std::abs(signed_nodal_diameter);
  const double frequency = engine_order * speed * hz_per_rad_s;
  label.family = curves.nearest_family(nodal_diameter, frequency, speed);
  label.natural_frequency = curves.frequency(nodal_diameter, label.family, speed);
  label.detuning = (frequency - label.natural_frequency) / label.natural_frequency;
  return label;
}

std::string engine_order_text(double engine_order) {
  constexpr int digits = 4;
  return significant(engine_order, digits);
}

std::string engine_order_name(double engine_order) {
  return "EO " + engine_order_text(engine_order);
}

std::string wave_name(double engine_order, int signed_nodal_diameter) {
  return engine_order_name(engine_order) + " ND " + (signed_nodal_diameter > 0 ? "+" : "") +
         std::to_string(signed_nodal_diameter);
}

std::string wave_name(const WaveLabel& wave) {
  return wave_name(wave.engine_order, wave.signed_nodal_diameter);
}

}  // namespace tiprub
