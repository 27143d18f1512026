// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/simulated_scene.h"

#include <algorithm>
#include <numbers>
#include <string>

#include "cases/program/digest.h"
#include "cases/program/text.h"
#include "reduce/model/reduced_model.h"
#include "simulate/scene/friction_limit.h"

namespace tiprub::simulate {

namespace {

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

ModelledEffect friction(const Scene& scene) {
  const std::string limit = "; " + friction_limit(scene.model).text();
  if (!scene.casing.has_friction())
    return {Effect::friction, Treatment::left_out, "the contact force acts only along the normal" + limit};
  return {Effect::friction, Treatment::modelled,
          "coefficient " + scene.casing.friction_text() + ", against the sliding of the vibrating tip" + limit};
}

ModelledEffect gap_term(Effect effect, const SimulateParameters& parameters) {
  if (parameters.gap != GapOrder::second_order)
    return {effect, Treatment::left_out, "the gap is linear in the displacement"};
  return {effect, Treatment::modelled, "the gap is of second order in the displacement, and so is its force"};
}

ModelledEffect blade_clearance(const Casing& casing) {
  if (casing.blade_clearance.empty())
    return {Effect::blade_clearance, Treatment::left_out, "all blades have the same clearance"};
  return {Effect::blade_clearance, Treatment::modelled, "each blade has its own clearance",
          *std::ranges::max_element(casing.blade_clearance)};
}

ModelledEffect nodal_diameters(const Scene& scene) {
  const std::vector<int>& moving = scene.scope.nodal_diameters;
  if (static_cast<int>(moving.size()) == scene.model.nodal_diameter_max() + 1)
    return {Effect::nodal_diameters, Treatment::modelled, "all are marched"};
  return {Effect::nodal_diameters, Treatment::left_out,
          "of 0 .. " + std::to_string(scene.model.nodal_diameter_max()) + " the multiples of " +
              std::to_string(scene.scope.symmetry) + " are marched, because no others move from rest"};
}

ModelledEffect massless_modes(const SimulateParameters& parameters) {
  if (parameters.modes == 0) return {Effect::massless_modes, Treatment::modelled, "all modes of the model have mass"};
  const std::string kept = "a nodal diameter keeps the mass of its lowest " + std::to_string(parameters.modes);
  if (parameters.scheme == Scheme::residual_flexibility)
    return {Effect::massless_modes, Treatment::simplified, kept + ", the others follow their forces without inertia"};
  return {Effect::massless_modes, Treatment::left_out, kept + ", the others are dropped"};
}

ModelledEffect time_step(const SimulateParameters& parameters) {
  return {
      Effect::time_step, Treatment::simplified,
      parameters.steps_per_revolution > 0
          ? "at least " + std::to_string(parameters.steps_per_revolution) + " steps per revolution, as the case says"
          : "halved until this changes the motion by less than " + text_of(parameters.step_tolerance)};
}

ModelledEffect impact_instants(const SimulateParameters& parameters) {
  if (finds_impacts(parameters.scheme, parameters.contact))
    return {Effect::impact_instants, Treatment::modelled, "an impact acts at its instant within the step"};
  return {Effect::impact_instants, Treatment::simplified,
          maps_states(parameters.scheme, parameters.contact)
              ? "impacts act at the ends of steps; Floquet multipliers do not hold where a node leaves at once"
              : "impacts act at the ends of steps"};
}

constexpr int casing_points = 721;  // of the casing's shape in the response: every half degree

constexpr int content = 8;  // version of a speed's result: to be raised when its content or meaning changes

void add_settings(Digest& hash, const CaseSettings& settings) {
  for (const auto& [key, value] : settings) {
    if (std::ranges::any_of(exempt_keys(), [&, &key = key](const ExemptKey& exempt) { return key == exempt.key; }))
      continue;
    hash.add(key);
    hash.add(value);
  }
}

}  // namespace

std::vector<ModelledEffect> effects_of(const Scene& scene) {
  const SimulateParameters& parameters = scene.parameters;
  return {normal_contact(parameters),
          friction(scene),
          gap_term(Effect::round_casing, parameters),
          gap_term(Effect::casing_slope, parameters),
          gap_term(Effect::blade_foreshortening, parameters),
          {Effect::casing_compliance, Treatment::left_out, "the casing is rigid"},
          {Effect::casing_wear, Treatment::left_out, "the casing keeps its shape"},
          blade_clearance(scene.casing),
          {Effect::damping, Treatment::modelled, "a ratio of critical for each mode"},
          nodal_diameters(scene),
          massless_modes(parameters),
          time_step(parameters),
          impact_instants(parameters),
          {Effect::settling, Treatment::simplified,
           "marching ends within " + text_of(parameters.settle_tolerance) + " of the settled motion"},
          {Effect::unsettled_motions, Treatment::simplified,
           "marching ends after " + std::to_string(parameters.max_revolutions) +
               " revolutions, or earlier where the change from one to the next stands"},
          {Effect::chatter, Treatment::simplified, "motion above the resolved frequency is an artefact of the mesh"},
          {Effect::heat, Treatment::left_out, "temperatures are not computed"},
          {Effect::gas, Treatment::left_out, "the gas exerts no forces"}};
}

SimulatedScene simulated_scene(const Scene& scene, const SceneOrigin& origin) {
  SimulatedScene described;
  described.asked = {scene.parameters.accuracy, scene.parameters.step_tolerance, scene.parameters.settle_tolerance};
  described.sector_count = scene.model.sector_count;
  described.independent_sectors = scene.scope.independent_sectors;
  described.nodal_diameters = scene.scope.nodal_diameters;
  described.casing_angle = Eigen::VectorXd::LinSpaced(casing_points, 0.0, 2 * std::numbers::pi);
  const Eigen::VectorXd fractions = arc_fractions(scene.model.contact);
  Eigen::MatrixXd distortion(casing_points, fractions.size());
  for (Eigen::Index k = 0; k < fractions.size(); ++k)
    distortion.col(k) =
        described.casing_angle.unaryExpr([&](double angle) { return scene.casing.distortion(angle, fractions[k]); });
  described.casing_distortion = distortion.rowwise().maxCoeff();
  const Eigen::VectorXd crests = scene.casing.crests(scene.model.contact);
  if ((distortion.colwise() - distortion.col(0)).any()) {
    described.node_distortion = distortion;
    described.node_crest = crests;
  }
  described.largest_distortion = crests.maxCoeff();
  described.lobes = scene.casing.lobes;
  described.scheme = scene.parameters.scheme;
  described.contact = scene.parameters.contact;
  described.damping = scene.parameters.damping.ratios;
  described.resolved_frequency = scene.parameters.resolved_frequency;
  described.clearance = scene.casing.given_clearance(scene.model.contact);
  described.clearance_state = scene.casing.clearance_state;
  for (const std::string& reason : scene.scope.reasons) described.scope += reason + "\n";
  described.effects = effects_of(scene);
  described.model_digest = digest(scene.model);
  described.provenance = origin.provenance;
  described.casing = origin.casing;
  return described;
}

const std::vector<ExemptKey>& exempt_keys() {
  static const std::vector<ExemptKey> keys = {
      {"accuracy", "it sets defaults of keys that count themselves"},
      {"speed_min_rpm", "speeds are independent; a sweep that carries its state counts the speeds themselves"},
      {"speed_max_rpm", "as speed_min_rpm"},
      {"speed_count", "as speed_min_rpm"},
      {"speeds_rpm", "as speed_min_rpm"},
      {"speeds", "as speed_min_rpm"},
      {"scan_per_interval", "as speed_min_rpm"},
      {"speed_count_max", "as speed_min_rpm"},
      {"peak_prominence", "as speed_min_rpm"},
      {"physics", "it decides on keys that count themselves"},
      {"examine", "a finished speed tells how deep it was looked at, and is computed again if that is not enough"},
      {"when_symmetry_breaks", "what is done afterwards, into another file"},
      {"branches", "what is done afterwards, of no speed's result"},
      {"branch_range", "as branches"},
      {"branch_steps", "as branches"},
      {"unusual", "it lets values pass, and these count themselves"},
      {"threads", "results don't depend on them"},
  };
  return keys;
}

std::string run_key(const ReducedModel& model, const SweepSettings& settings, const SimulateParameters& parameters,
                    const std::string& generator, const ReducedModel* other_model) {
  Digest hash;
  hash.add(content);
  hash.add(generator);
  hash.add(digest(model));
  if (other_model != nullptr) hash.add(digest(*other_model));
  add_settings(hash, settings.casing);
  add_settings(hash, settings.simulate);
  if (parameters.sweep != SweepDirection::rest)  // a speed's result depends on those before it
    for (double speed : parameters.speeds) hash.add(speed);
  return hash.digits();
}

}  // namespace tiprub::simulate
