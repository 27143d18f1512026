// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/scene_effects.h"

#include <algorithm>
#include <sstream>
#include <string>

namespace tiprub {

namespace {

std::string text_of(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

ModelledEffect normal_contact(const SimulateParameters& parameters) {
  const std::string scheme = std::string("scheme ") + name_in(scheme_names, parameters.scheme);
  if (parameters.scheme == Scheme::penalty)
    return {
        Effect::normal_contact, Treatment::simplified,
        "a spring of " + text_of(parameters.penalty_stiffness) + " tip stiffnesses pushes a node that penetrates"};
  if (parameters.contact == ContactRule::paper)
    return {Effect::normal_contact, Treatment::simplified,
            "nodes that penetrate are closed once, and may be pulled (eq. 14, eq. 15), " + scheme};
  return {Effect::normal_contact, Treatment::modelled, "complementarity in every step, " + scheme};
}

ModelledEffect blade_clearance(const Casing& casing) {
  if (casing.blade_clearance.empty())
    return {Effect::blade_clearance, Treatment::left_out, "all blades have the same clearance"};
  return {Effect::blade_clearance, Treatment::modelled, "each blade has its own clearance",
          *std::max_element(casing.blade_clearance.begin(), casing.blade_clearance.end())};
}

ModelledEffect nodal_diameters(const Scene& scene) {
  const std::vector<int>& moving = scene.scope.nodal_diameters;
  if (static_cast<int>(moving.size()) == scene.model.nodal_diameter_max() + 1)
    return {Effect::nodal_diameters, Treatment::modelled, "all are marched"};
  return {Effect::nodal_diameters, Treatment::left_out,
          "of 0 .. " + std::to_string(scene.model.nodal_diameter_max()) + " the multiples of " +
              std::to_string(scene.scope.symmetry) + " are marched: from rest no other one moves"};
}

ModelledEffect massless_modes(const SimulateParameters& parameters) {
  if (parameters.modes == 0) return {Effect::massless_modes, Treatment::modelled, "all modes of the model have mass"};
  const std::string kept = "a nodal diameter keeps the mass of its lowest " + std::to_string(parameters.modes);
  if (parameters.scheme == Scheme::residual_flexibility)
    return {Effect::massless_modes, Treatment::simplified, kept + ", the others follow their forces at once"};
  return {Effect::massless_modes, Treatment::left_out, kept + ", the others are dropped"};
}

ModelledEffect time_step(const SimulateParameters& parameters) {
  return {Effect::time_step, Treatment::simplified,
          parameters.steps_per_revolution > 0
              ? "at least " + std::to_string(parameters.steps_per_revolution) + " steps a revolution, as asked for"
              : "halved until that changes the motion by less than " + text_of(parameters.step_tolerance)};
}

}  // namespace

std::vector<ModelledEffect> effects_of(const Scene& scene) {
  const SimulateParameters& parameters = scene.parameters;
  const char* const linear = "the gap is linear in the displacement";
  return {normal_contact(parameters),
          {Effect::friction, Treatment::left_out, "the contact force acts along the normal alone"},
          {Effect::round_casing, Treatment::left_out, linear},
          {Effect::casing_slope, Treatment::left_out, linear},
          {Effect::blade_foreshortening, Treatment::left_out, linear},
          {Effect::casing_compliance, Treatment::left_out, "the casing is rigid"},
          {Effect::casing_wear, Treatment::left_out, "the casing keeps its shape"},
          blade_clearance(scene.casing),
          {Effect::damping, Treatment::modelled, "a ratio of critical for each mode"},
          nodal_diameters(scene),
          massless_modes(parameters),
          time_step(parameters),
          {Effect::settling, Treatment::simplified,
           "a motion is left within " + text_of(parameters.settle_tolerance) + " of where it settles"},
          {Effect::unsettled_motions, Treatment::simplified,
           "a speed is left after " + std::to_string(parameters.max_revolutions) + " revolutions"},
          {Effect::chatter, Treatment::simplified, "motion above the resolved frequency is the mesh's"},
          {Effect::heat, Treatment::left_out, "temperatures are not computed"},
          {Effect::gas, Treatment::left_out, "the gas exerts no forces"}};
}

}  // namespace tiprub
