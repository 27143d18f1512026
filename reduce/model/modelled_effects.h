// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tiprub {

class Hdf5File;

/// An effect on the motion of a wheel that rubs, or on the accuracy with which it is computed.
enum class Effect {
  normal_contact,
  friction,
  round_casing,
  casing_slope,
  blade_foreshortening,
  casing_compliance,
  casing_wear,
  blade_clearance,
  blade_mistuning,
  spin_stiffness,
  coriolis,
  damping,
  nodal_diameters,
  reduced_modes,
  massless_modes,
  contact_resolution,
  mesh,
  time_step,
  impact_instants,
  settling,
  unsettled_motions,
  chatter,
  heat,
  gas,
};

enum class Treatment {
  modelled,
  simplified,  ///< modelled up to an error or an assumption that the reason names
  left_out,
};

/// How a model or a scene treats one effect. The program that knows it writes it: reduce in model.h5, simulate in
/// response.h5; postprocess adds the sizes that it can estimate.
struct ModelledEffect {
  Effect effect = Effect::normal_contact;
  Treatment treatment = Treatment::left_out;
  std::string reason = {};          ///< why, or how: for people
  std::optional<double> size = {};  ///< on this scene, in the unit of the effect
  std::optional<double> tolerance = {};

  bool operator==(const ModelledEffect&) const = default;
};

/// What an effect is called, and what its size measures.
struct EffectMeaning {
  Effect effect;
  const char* name;     ///< in files: "coriolis"
  const char* words;    ///< for people: "Coriolis terms"
  const char* measure;  ///< of its size: "relative change of a frequency"; empty: it has none
  const char* unit;     ///< SI, of its size
};
const EffectMeaning& meaning_of(Effect effect);

/// "modelled", "simplified", "left out": as files have it.
const char* name_of(Treatment treatment);

/// The entry of an effect, or nothing.
const ModelledEffect* find(const std::vector<ModelledEffect>& effects, Effect effect);

/// The group /effects of a file, one group with attributes for each effect.
void write_effects(Hdf5File& file, const std::vector<ModelledEffect>& effects);
/// In the order of Effect; empty if the file has none. Raises RunError at an effect or a treatment that is not known,
/// and at a size that is negative or has another unit.
std::vector<ModelledEffect> read_effects(const Hdf5File& file);

}  // namespace tiprub
