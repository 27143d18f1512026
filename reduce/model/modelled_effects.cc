// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/modelled_effects.h"

#include <algorithm>
#include <iterator>

#include "cases/program/named_values.h"
#include "reduce/model/hdf5_file.h"

namespace tiprub {

namespace {

constexpr EffectMeaning meanings[] = {
    {Effect::normal_contact, "normal_contact", "contact along the normal of the tip", "", ""},
    {Effect::friction, "friction", "friction at the tips", "work of a coefficient of 0.1, of the normal force's",
     "1"},
    {Effect::round_casing, "round_casing", "gap: a round casing is nearer to a tip that moves along the tangent",
     "change of the gap", "m"},
    {Effect::casing_slope, "casing_slope", "gap: the casing's shape is read where the tip is at rest",
     "change of the gap", "m"},
    {Effect::blade_foreshortening, "blade_foreshortening", "gap: a bent blade draws its tip back",
     "change of the gap", "m"},
    {Effect::casing_compliance, "casing_compliance", "a casing that yields", "", ""},
    {Effect::casing_wear, "casing_wear", "wear of the casing", "depth after an hour, order of magnitude", "m"},
    {Effect::blade_clearance, "blade_clearance", "differences of the clearance between the blades", "largest of them",
     "m"},
    {Effect::blade_mistuning, "blade_mistuning", "differences of mass and stiffness between the blades", "", ""},
    {Effect::spin_stiffness, "spin_stiffness", "stiffness under spin", "relative error of a frequency", "1"},
    {Effect::coriolis, "coriolis", "Coriolis terms", "relative change of a frequency", "1"},
    {Effect::damping, "damping", "damping of the modes", "", ""},
    {Effect::nodal_diameters, "nodal_diameters", "nodal diameters", "growth a revolution of those left out", "1"},
    {Effect::reduced_modes, "reduced_modes", "modes of the reduced model", "error of the wheel's first frequencies",
     "1"},
    {Effect::massless_modes, "massless_modes", "modes without mass", "share of the elastic energy", "1"},
    {Effect::contact_resolution, "contact_resolution", "contact unknowns along the tip", "", ""},
    {Effect::mesh, "mesh", "mesh", "relative error of a critical speed", "1"},
    {Effect::time_step, "time_step", "time step", "change by its last halving", "1"},
    {Effect::impact_instants, "impact_instants", "instants of impacts within a time step", "", ""},
    {Effect::settling, "settling", "settling", "change over the last period", "1"},
    {Effect::unsettled_motions, "unsettled_motions", "motions left before they have settled", "number of speeds",
     "1"},
    {Effect::chatter, "chatter", "chatter above the resolved frequencies", "share of the mean square", "1"},
    {Effect::heat, "heat", "heat", "", ""},
    {Effect::gas, "gas", "forces of the gas", "", ""},
};

constexpr bool in_order() {
  for (std::size_t i = 0; i < std::size(meanings); ++i)
    if (meanings[i].effect != static_cast<Effect>(i)) return false;
  return true;
}
static_assert(in_order(), "meaning_of() counts on it");

constexpr NamedValues<Treatment, 3> treatment_names = {
    {{Treatment::modelled, "modelled"}, {Treatment::simplified, "simplified"}, {Treatment::left_out, "left out"}}};

const std::string effects_group = "/effects";

const EffectMeaning& meaning_named(const Hdf5File& file, const std::string& name) {
  const auto* const meaning = std::ranges::find(meanings, name, &EffectMeaning::name);
  if (meaning == std::end(meanings)) file.refuse(effects_group, "/", name, " is not known");
  return *meaning;
}

/// A size or a tolerance, if it is there.
std::optional<double> read_size(const Hdf5File& file, const std::string& group, const std::string& attribute) {
  if (!file.has_attribute(group, attribute)) return {};
  const double size = file.number_attribute(group, attribute);
  if (!(size >= 0)) file.refuse(group, ": attribute ", attribute, " must be at least 0");
  return size;
}

}  // namespace

const EffectMeaning& meaning_of(Effect effect) {
  return meanings[static_cast<std::size_t>(effect)];
}

const char* name_of(Treatment treatment) {
  return name_in(treatment_names, treatment);
}

const ModelledEffect* find(const std::vector<ModelledEffect>& effects, Effect effect) {
  const auto found = std::ranges::find(effects, effect, &ModelledEffect::effect);
  return found == effects.end() ? nullptr : &*found;
}

void write_effects(Hdf5File& file, const std::vector<ModelledEffect>& effects) {
  for (const ModelledEffect& effect : effects) {
    const EffectMeaning& meaning = meaning_of(effect.effect);
    const std::string group = effects_group + "/" + meaning.name;
    file.set_attribute(group, "treatment", std::string(name_of(effect.treatment)));
    file.set_attribute(group, "reason", effect.reason);
    if (effect.size) file.set_attribute(group, "size", *effect.size);
    if (effect.tolerance) file.set_attribute(group, "tolerance", *effect.tolerance);
    if (effect.size || effect.tolerance) file.set_attribute(group, "unit", std::string(meaning.unit));
  }
}

std::vector<ModelledEffect> read_effects(const Hdf5File& file) {
  std::vector<ModelledEffect> effects;
  if (!file.exists(effects_group)) return effects;
  for (const std::string& name : file.members(effects_group)) {
    const EffectMeaning& meaning = meaning_named(file, name);
    const std::string group = effects_group + "/" + name;
    const Treatment treatment = file.named_attribute(group, "treatment", treatment_names);
    effects.push_back({meaning.effect, treatment, file.text_attribute(group, "reason"),
                       read_size(file, group, "size"), read_size(file, group, "tolerance")});
    if (file.has_attribute(group, "unit") && file.text_attribute(group, "unit") != meaning.unit)
      file.refuse(group, ": attribute unit is \"", file.text_attribute(group, "unit"), "\", must be \"", meaning.unit,
                  "\"");
  }
  std::ranges::sort(effects, {}, &ModelledEffect::effect);
  return effects;
}

}  // namespace tiprub
