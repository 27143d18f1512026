// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cases/program/case_file.h"
#include "postprocess/waves/travelling_spectrum.h"

namespace tiprub::postprocess {

/// An end of the tip line.
enum class TipEdge { leading, trailing };

/// The [postprocess] table of a case.
struct PostprocessParameters {
  Component component = Component::normal;  ///< of the tip motion, in every amplitude
  TipEdge edge = TipEdge::leading;          ///< whose map comes first, and whose spectra and trackings are drawn
  int families = 2;                         ///< modal families drawn
  int engine_order_max = 12;                ///< highest engine order drawn and listed
  double prominence = 0.25;           ///< [1] share of its amplitude by which a peak must stand above its valleys
  double prediction_tolerance = 0.1;  ///< [1] relative distance at which a rule's speed still counts as a hit
  double amplitude_decades = 2.5;     ///< colour range of the maps, below the largest amplitude
  double shown_speed_rpm = 0;  ///< [rpm] motion, force and bars are drawn at the nearest one; 0: see Study::shown
  std::string response_up, response_down;  ///< this case swept up and down, beside the response; empty: not compared
  double amplitude_max_mm = 0;             ///< [mm] upper colour limit of the maps; 0: the largest amplitude
  /// [rpm] the speeds at which the wheel is to run, for the margin; 0: not given
  double operating_min_rpm = 0, operating_max_rpm = 0;
  double operating_amplitude_mm = 0;  ///< [mm] critical speeds with less are left out of the margin
  double tip_patch_mm = 0;            ///< [mm] width of the zones with separate stress; 0: see stress_zones()
  double wear_coefficient = 1e-15;    ///< [m^2/N] Archard's k/H of casing against tip; 0: wear isn't estimated
};

/// Raises InputError at a key that is unknown or out of its range.
PostprocessParameters read_postprocess_parameters(CaseTable& table);

/// "displacement along the casing normal", for axes and captions.
const char* name_of(Component component);
/// "leading edge" or "trailing edge".
const char* name_of(TipEdge edge);
TipEdge other_than(TipEdge edge);

/// The [material] table of a case: the strengths of the wheel's material. They have no defaults, because they depend
/// on heat treatment, surface and size of a part.
struct MaterialStrength {
  double ultimate = 0;          ///< [Pa] in tension
  double endurance = 0;         ///< [Pa] amplitude, fully reversed, that it bears for the required number of cycles
  std::optional<double> yield;  ///< [Pa]
};

/// Raises InputError at a key that is unknown, missing or out of its range.
MaterialStrength read_strength(CaseTable& table);
/// Nothing without the table.
std::optional<MaterialStrength> read_material_strength(const CaseFile& file);

/// [1] Goodman: alternating / endurance + mean / ultimate; 1 is the limit. Of a node, or of many.
template <class Stress>
Stress goodman_utilisation(const MaterialStrength& strength, const Stress& alternating, const Stress& mean) {
  return alternating / strength.endurance + mean / strength.ultimate;
}

}  // namespace tiprub::postprocess
