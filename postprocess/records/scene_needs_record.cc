// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/scene_needs_record.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "postprocess/analysis/gap_terms.h"
#include "postprocess/records/exactness_record.h"

namespace tiprub::postprocess {

namespace {

constexpr double clearance_share = 0.1;   // allowed wear, of the smallest running clearance
constexpr double frequency_limit = 1e-3;  // allowed error of a critical speed, relative
constexpr double usual_friction = 0.1;    // of metal on metal or on a coating, as an example
constexpr double drag_limit = 0.05;       // allowed work of friction, of the normal force's
constexpr double chatter_limit = 0.01;    // of the mean square: a tenth of the amplitude
constexpr double hour = 3600;             // [s]

NeedVerdict judged(double size, double tolerance) {
  return size <= tolerance ? NeedVerdict::negligible : NeedVerdict::matters;
}

SceneNeed estimated(Effect effect, double size, double tolerance, const std::string& how) {
  return {{.effect = effect, .size = size, .tolerance = tolerance}, judged(size, tolerance), how};
}

SceneNeed not_estimated(Effect effect, const std::string& how) {
  return {{.effect = effect}, NeedVerdict::not_estimated, how};
}

/// An effect that simulate or reduce may have measured. `otherwise`: how to measure it, if they did not.
SceneNeed measured(const std::vector<Check>& checks, const std::string& subject, Effect effect,
                   const std::string& otherwise) {
  const auto check = std::ranges::find(checks, subject, &Check::subject);
  if (check == checks.end() || check->verdict == CheckVerdict::not_looked_at) return not_estimated(effect, otherwise);
  const NeedVerdict verdict = check->verdict == CheckVerdict::passed   ? NeedVerdict::negligible
                              : check->verdict == CheckVerdict::failed ? NeedVerdict::matters
                                                                       : NeedVerdict::undecided;
  return {{.effect = effect, .size = check->worst, .tolerance = check->limit},
          verdict,
          "the largest at " + std::to_string(check->looked_at) + " of " + std::to_string(check->speeds) +
              " speeds; " + std::to_string(check->beyond) + " beyond"};
}

/// [m] A tenth of the smallest running clearance at the judged speed.
double wear_tolerance(const Study& study) {
  return clearance_share * std::max(0.0, study.judged_response().clearance.minCoeff());
}

std::vector<SceneNeed> gap_needs(const Study& study, const FieldEffects& fields) {
  const SpeedResponse& response = study.judged_response();
  const GapTerms gap = gap_terms(response, study.response.scene, study.model.contact, fields.tip_span);
  const bool by_model = study.model.contact.second_order.has_value();
  const double tolerance = gap.allowed();
  const std::string where =
      ", at " + rpm_text(response.speed) + "; the tolerance is a tenth of the interference there";
  std::vector<SceneNeed> needs = {
      estimated(
          Effect::round_casing, gap.curvature, tolerance,
          (by_model ? "(c_1 u_theta^2 + c_2 u_m^2)/2 with the casing's curvatures" : "n_r u_theta^2/(2 r)") + where),
      estimated(Effect::casing_slope, gap.distortion, tolerance,
                "steepest slope of the distortion, times u_theta/r" + where)};
  needs.push_back(gap.foreshortening
                      ? estimated(Effect::blade_foreshortening, *gap.foreshortening, tolerance,
                                  (by_model ? "y' Q y of model.h5"
                                            : "(6/5) w^2/(2 L), w the motion across the normal, L from tip to disc") +
                                      where)
                      : not_estimated(Effect::blade_foreshortening,
                                      "give --fields with the part disc: it takes the blade's span"));
  return needs;
}

SceneNeed friction_need(const Study& study) {
  constexpr Effect effect = Effect::friction;
  const ModelledEffect* const known = find(study.response.scene.effects, effect);
  if (known != nullptr && known->treatment == Treatment::modelled) return {*known, NeedVerdict::none};
  const SpeedResponse& response = study.judged_response();
  const auto share = sliding_share(response, study.response.scene, study.model.contact);
  if (!share) return not_estimated(effect, "no contact at " + rpm_text(response.speed));
  return estimated(effect, usual_friction * std::abs(share->ratio), drag_limit,
                   "the tip moves " + significant(share->ratio, 2) +
                       " along theta for each 1 along its normal at contact node " + std::to_string(share->node) +
                       ", at " + rpm_text(response.speed) + "; set casing.friction_coefficient");
}

SceneNeed prestress_need(const ReducedModel& model) {
  const ModelledEffect* const known = find(model.effects, Effect::spin_stiffness);
  if (known != nullptr && known->size)
    return estimated(Effect::spin_stiffness, *known->size, frequency_limit,
                     "frequencies by eq. 7 between the speeds that it goes through");
  return not_estimated(Effect::spin_stiffness,
                       "compare /verification with that of tiprub-reduce --set 'reduce.prestress=\"nonlinear\"'");
}

SceneNeed coriolis_need(const FieldEffects& fields) {
  if (!fields.coriolis)
    return not_estimated(Effect::coriolis, "give --fields: it takes the modes of the critical speeds");
  const CoriolisShift& shift = *fields.coriolis;
  return estimated(Effect::coriolis, shift.change, frequency_limit,
                   "of the modes that make the critical speeds, largest at " + rpm_text(shift.speed) +
                       " (nodal diameter " + std::to_string(shift.nodal_diameter) + ", family " +
                       std::to_string(shift.family + 1) + ")");
}

SceneNeed diameters_need(const Study& study, const std::vector<Check>& checks) {
  if (speeds_with(SymmetryVerdict::all_held, study) == static_cast<int>(study.response.speeds.size()))
    return {{.effect = Effect::nodal_diameters}, NeedVerdict::negligible, "none is left out"};
  SceneNeed need = measured(checks, "symmetry", Effect::nodal_diameters,
                            "compare with tiprub-simulate --set 'simulate.nodal_diameters=\"all\"'");
  if (need.verdict == NeedVerdict::not_estimated) return need;
  const int unchecked = speeds_with(SymmetryVerdict::unchecked, study);
  if (unchecked > 0 && need.verdict == NeedVerdict::negligible) need.verdict = NeedVerdict::undecided;
  need.how += ", " + std::to_string(speeds_with(SymmetryVerdict::undecided, study)) + " undecided, " +
              std::to_string(unchecked) + " unchecked";
  return need;
}

SceneNeed mesh_need(const Study& study) {
  const std::optional<std::size_t> largest = largest_critical(study.critical);
  const std::optional<double> shift =
      largest ? mesh_shift(study.model, study.critical[*largest].naming_wave()) : std::nullopt;
  if (!shift)
    return not_estimated(Effect::mesh,
                         study.model.mesh_error
                             ? "reduce with more verification_modes: it takes the mode of the largest peak"
                             : "compare with tiprub-reduce --set reduce.refine=1");
  return estimated(Effect::mesh, *shift, frequency_limit,
                   "of the mode that makes the critical speed at " + rpm_text(study.critical[*largest].speed) +
                       ", from functions that the mesh lacks; the compliance of the tip is up to " +
                       significant(100 * study.model.mesh_error->compliance.maxCoeff(), 2) + " % too small");
}

std::vector<SceneNeed> model_needs(const Study& study, const FieldEffects& fields, const std::vector<Check>& checks) {
  return {prestress_need(study.model),
          coriolis_need(fields),
          diameters_need(study, checks),
          measured(checks, "massless and truncated modes", Effect::massless_modes, ""),
          measured(checks, "model", Effect::reduced_modes, "reduce with verification_speeds"),
          not_estimated(Effect::contact_resolution, "compare with tiprub-reduce --set reduce.contact_nodes=" +
                                                        std::to_string(2 * study.model.contact.size())),
          mesh_need(study)};
}

/// Effects of how the motion is computed.
std::vector<SceneNeed> march_needs(const Study& study, const std::vector<Check>& checks) {
  double chatter = 0;
  int unsettled = 0;
  for (const SpeedResponse& speed : study.response.speeds) {
    chatter = std::max(chatter, speed.chatter);
    unsettled += !speed.settled();
  }
  const std::string speeds = "of " + std::to_string(study.response.speeds.size()) + " speeds";
  return {measured(checks, "time step", Effect::time_step, "leave simulate.steps_per_revolution out"),
          measured(checks, "settling", Effect::settling, "no motion settled; raise simulate.max_revolutions"),
          estimated(Effect::unsettled_motions, unsettled, 0, speeds),
          estimated(Effect::chatter, chatter, chatter_limit, "the largest " + speeds)};
}

SceneNeed wear_need(const Study& study) {
  const double coefficient = study.parameters.wear_coefficient;
  constexpr Effect effect = Effect::casing_wear;
  if (!(coefficient > 0)) return not_estimated(effect, "set postprocess.wear_coefficient");
  if (study.model.contact.size() == 1) return not_estimated(effect, "raise reduce.contact_nodes");
  const SpeedResponse& response = study.judged_response();
  const CasingWear wear = casing_wear(response, study.response.scene, study.model.contact, coefficient, hour);
  const double allowed = wear_tolerance(study);
  if (!(wear.depth > 0)) return estimated(effect, 0, allowed, "no contact at " + rpm_text(response.speed));
  return estimated(
      effect, wear.depth, allowed,
      "Archard at " + rpm_text(response.speed) + ": k/H = " + significant(coefficient, 2) + " m^2/N, " +
          fixed(wear.force, 0) + " N on average at contact node " + std::to_string(wear.node) +
          (allowed > 0 ? "; the tolerance is reached after " + significant(hour * allowed / wear.depth, 2) + " s"
                       : "; the clearance is closed at this speed"));
}

/// The effects that the files describe: the model those of the wheel, the response all others.
std::vector<ModelledEffect> known_effects(const Study& study) {
  std::vector<ModelledEffect> effects = study.model.effects;
  for (const ModelledEffect& effect : study.response.scene.effects)
    if (find(effects, effect.effect) == nullptr) effects.push_back(effect);
  return effects;
}

/// What to set or to compare, so that an effect is known or modelled; empty if nothing here does that.
std::string settled_by(Effect effect) {
  static const std::map<Effect, const char*> keys = {
      {Effect::friction, "simulate.budget = \"critical_speeds\", or casing.friction_coefficient"},
      {Effect::round_casing, "simulate.gap = \"second_order\""},
      {Effect::casing_slope, "simulate.gap = \"second_order\""},
      {Effect::blade_foreshortening, "simulate.gap = \"second_order\""},
      {Effect::damping, "simulate.budget_damping"},
      {Effect::blade_clearance, "casing.blade_clearance"},
      {Effect::nodal_diameters, "simulate.nodal_diameters = \"all\", or when_symmetry_breaks = \"full_run\""},
      {Effect::contact_resolution, "reduce.contact = \"segments\", reduce.contact_nodes"},
      {Effect::mesh, "reduce.refine, or element_order = 3"},
      {Effect::spin_stiffness, "reduce.prestress"},
      {Effect::time_step, "simulate.step_tolerance"},
      {Effect::settling, "simulate.max_revolutions"},
      {Effect::unsettled_motions, "simulate.max_revolutions"},
      {Effect::casing_wear, "postprocess.wear_coefficient of the lining"}};
  const auto known = keys.find(effect);
  return known == keys.end() ? "" : known->second;
}

/// How to estimate an effect that has no estimate.
std::string way_to_estimate(const ModelledEffect& known) {
  const std::string keys = settled_by(known.effect);
  if (!keys.empty()) return "compare with another value of " + keys;
  return known.treatment == Treatment::left_out ? "no program of this chain models it"
                                                : "compare with settings that model it";
}

void add_known(std::vector<SceneNeed>& needs, const ModelledEffect& known) {
  const auto need = std::ranges::find(needs, known.effect, [](const SceneNeed& n) { return n.effect.effect; });
  if (need != needs.end()) {
    need->effect.treatment = known.treatment;
    need->effect.reason = known.reason;
    if (known.treatment == Treatment::modelled) *need = {known, NeedVerdict::none, need->how};
  } else if (known.treatment == Treatment::modelled) {
    needs.push_back({known, NeedVerdict::none});
  } else {
    needs.push_back({known, NeedVerdict::not_estimated, way_to_estimate(known)});
  }
}

/// A size in millimetres if the file has it in metres.
Cell size_cell(Effect effect, const std::optional<double>& size) {
  if (!size) return std::string();
  return *size * (std::string_view(meaning_of(effect).unit) == "m" ? mm_per_m : 1.0);
}

/// What matters first, then what nobody knows; within each the largest size over its tolerance first.
bool comes_first(const SceneNeed& a, const SceneNeed& b) {
  constexpr std::array rank = {4, 3, 0, 1, 2};  // of NeedVerdict's values
  const int of_a = rank[static_cast<std::size_t>(a.verdict)], of_b = rank[static_cast<std::size_t>(b.verdict)];
  return of_a != of_b ? of_a < of_b : a.over_tolerance() > b.over_tolerance();
}

}  // namespace

std::vector<SceneNeed> scene_needs(const Study& study, const FieldEffects& fields) {
  const std::vector<Check> checks = exactness_checks(study);
  std::vector<SceneNeed> needs = joined<SceneNeed>({gap_needs(study, fields),
                                                    model_needs(study, fields, checks),
                                                    march_needs(study, checks),
                                                    {wear_need(study), friction_need(study)}});
  for (SceneNeed& need : needs) need.effect.treatment = Treatment::simplified;  // where no file tells
  needs.push_back({{Effect::damping, Treatment::modelled}, NeedVerdict::none, damping_text(study.response.scene)});
  for (const ModelledEffect& known : known_effects(study)) add_known(needs, known);
  std::ranges::sort(needs, {}, [](const SceneNeed& need) { return need.effect.effect; });
  return needs;
}

std::string damping_text(const SimulatedScene& scene) {
  constexpr int digits = 4;
  const DampingRatios& damping = scene.damping;
  std::string text = listed(damping.by_family, ", ", [](double ratio) { return significant(ratio, digits); });
  if (text.empty())
    text = listed(damping.by_frequency, ", ", [](const auto& point) {
      return significant(point[1], digits) + " at " + fixed(point[0], 0) + " Hz";
    });
  if (text.empty()) return "not told by the response";
  text = (damping.by_family.size() == 1 ? "ratio " : "ratios ") + text + " of critical";
  if (damping.by_family.size() > 1) text += ", the first family's, the second's, ...";
  for (const ModeDamping& mode : damping.by_mode)
    text += "; " + significant(mode.ratio, digits) + " for family " + std::to_string(mode.family + 1) +
            " on nodal diameter " + std::to_string(mode.nodal_diameter);
  if (!std::isfinite(scene.resolved_frequency)) return text;
  return text + "; " + significant(damping.beyond, digits) + " above " + fixed(scene.resolved_frequency, 0) + " Hz";
}

std::string effects_in_words(const std::vector<SceneNeed>& needs, Treatment treatment) {
  const std::string text = listed(needs, ", ", [&](const SceneNeed& need) {
    return need.effect.treatment == treatment ? meaning_of(need.effect.effect).words : "";
  });
  return text.empty() ? text : std::string(name_of(treatment)) + ": " + text;
}

std::string name_with_unit(Effect effect) {
  const EffectMeaning& meaning = meaning_of(effect);
  const std::string unit = meaning.unit == std::string_view("m") ? "mm" : meaning.unit;
  return std::string(meaning.words) +
         (*meaning.measure == '\0' ? "" : std::string(": ") + meaning.measure + " [" + unit + "]");
}

double SceneNeed::over_tolerance() const {
  if (!effect.size || !effect.tolerance || *effect.size == 0) return 0;
  return *effect.size / *effect.tolerance;
}

std::string name_of(NeedVerdict verdict) {
  constexpr std::array names = {"", "negligible", "matters", "undecided", "not estimated"};
  return names[static_cast<std::size_t>(verdict)];
}

Table scene_needs_record(std::vector<SceneNeed> needs) {
  std::ranges::stable_sort(needs, comes_first);
  return table_of<SceneNeed>(
      {{"effect", [](const SceneNeed& need) { return name_with_unit(need.effect.effect); }},
       {"size over tolerance [1]",
        [](const SceneNeed& need) {
          const double ratio = need.over_tolerance();
          return need.effect.size && std::isfinite(ratio) ? Cell(ratio) : Cell(std::string());
        }},
       {"verdict", [](const SceneNeed& need) { return name_of(need.verdict); }},
       {"settled by",
        [](const SceneNeed& need) {
          return need.verdict == NeedVerdict::none ? std::string() : settled_by(need.effect.effect);
        }},
       {"treatment", [](const SceneNeed& need) { return name_of(need.effect.treatment); }},
       {"size", [](const SceneNeed& need) { return size_cell(need.effect.effect, need.effect.size); }},
       {"tolerance", [](const SceneNeed& need) { return size_cell(need.effect.effect, need.effect.tolerance); }},
       {"reason", [](const SceneNeed& need) { return need.effect.reason; }},
       {"estimated by, or how to", [](const SceneNeed& need) { return need.how; }}},
      needs);
}

}  // namespace tiprub::postprocess
