// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/report/report.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "postprocess/records/error_budget_record.h"
#include "postprocess/records/exactness_record.h"
#include "postprocess/records/study_records.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

bool blades_differ(const SimulatedScene& scene) {
  const ModelledEffect* const clearance = find(scene.effects, Effect::blade_clearance);
  return clearance != nullptr && clearance->treatment == Treatment::modelled;
}

/// "0.265 mm, 2.2 times the running clearance there", or "0.187 mm": half of the peak-to-peak at a speed.
std::string amplitude_text(const Study& study, Eigen::Index speed) {
  const double amplitude = study.amplitudes.largest[speed];
  if (study.parameters.component != Component::normal) return mm_text(amplitude);
  const double clearance = study.speed_at(speed).clearance[study.amplitudes.node[speed]];
  return mm_text(amplitude) +
         (clearance > 0
              ? ", " + fixed(amplitude / clearance, 1) + " times the running clearance there (" + mm_text(clearance) +
                    (blades_differ(study.response.scene) ? ", that of the longest blade)" : ")")
              : "");
}

/// ", and towards the casing by ", "; the axial displacement is "
std::string before_amplitude(Component component) {
  if (component == Component::normal) return ", and towards the casing by ";
  return std::string("; the ") + name_of(component) + " is ";
}

std::string stress_text(const Study& study, const std::optional<FieldPeak>& peak) {
  if (!peak) return "";
  const auto& cycle = peak->cycle;
  std::string text = std::string(" The vibration stress is ") + (cycle ? "" : "at least ") +
                     mpa_text(peak->body.vibration) + ", and " + mpa_text(peak->body.both) + " with spin";
  if (!cycle) return text + ", at the one instant of this motion that the response holds.";
  if (!cycle->goodman) return text + ".";
  if (cycle->strength->yield) text += " (yield strength " + mpa_text(*cycle->strength->yield) + ")";
  return text + "; Goodman's utilisation is " + fixed(*cycle->goodman, 2) +
         (*cycle->goodman > 1 ? ", above the limit of 1" : "") + " (" + mpa_text(cycle->alternating) +
         " alternating, endurance limit " + mpa_text(cycle->strength->endurance) + "; " + mpa_text(cycle->mean) +
         " mean, ultimate strength " + mpa_text(cycle->strength->ultimate) + ")" + speeds_caveat(study) + ".";
}

/// " Friction takes 380 kW of the wheel's power, at most 700 kW."; empty without friction.
std::string friction_text(const FrictionLoad& friction) {
  constexpr double kw_per_w = 1e-3;
  if (!friction.rub_power_mean) return "";
  return " Friction takes " + fixed(*friction.rub_power_mean * kw_per_w, 0) +
         " kW of the wheel's power on average, and at most " + fixed(*friction.rub_power_largest * kw_per_w, 0) +
         " kW.";
}

std::string still_rising(const Study& study) {
  const std::vector<Eigen::Index> ends = rising_ends(study.amplitudes.largest, study.parameters.prominence);
  const std::string text = listed(ends, " and ", [&](Eigen::Index end) {
    return rpm_text(study.speed_at(end).speed) + " (" + mm_text(study.amplitudes.largest[end]) + ")";
  });
  return text.empty()
             ? text
             : " The amplitude still rises towards " + text + ": a peak may lie outside the simulated speeds.";
}

/// Peaks that are no critical speeds, because the response doesn't fall clearly on both sides.
std::string not_located(const Study& study) {
  const std::string text = listed(study.not_located, "; ", [](const CriticalSpeed& peak) {
    return mm_text(peak.amplitude) + " at " + rpm_text(peak.speed) + ", a top that may lie anywhere between " +
           fixed(peak.speed_low * rpm_per_rad_s, 0) + " and " + rpm_text(peak.speed_high);
  });
  return text.empty() ? text : " Not located, and no critical speeds: " + text + ".";
}

std::string how_bad(const Study& study, const FieldResults& fields) {
  if (study.no_tip_touches())
    return "No tip touches the casing at any speed, so that nothing excites the wheel: a tip that does not vibrate "
           "stays at least " +
           mm_text(-study.interference().high) + " away from it.";
  const std::optional<std::size_t> worst = worst_critical(study, fields);
  const std::string largest =
      rpm_text(study.worst_response().speed) + ", " + amplitude_text(study, study.amplitudes.worst()) + ".";
  if (!worst)
    return "No critical speed: the amplitude has no peak that stands out and is located. It is largest at " +
           largest + stress_text(study, fields.of_no_critical) + not_located(study) + still_rising(study);
  const CriticalSpeed& peak = study.critical[*worst];
  const bool more_elsewhere = study.amplitudes.largest.maxCoeff() > peak.amplitude;
  return counted(study.critical.size(), "critical speed") + ". The worst, at " + rpm_text(peak.speed) +
         ", moves the tip by " + fixed(study.excursion_at(peak.index) * mm_per_m, 2) + " mm in all" +
         before_amplitude(study.parameters.component) + amplitude_text(study, peak.index) + "." +
         stress_text(study, fields.peaks[*worst]) +
         friction_text(study.response.speeds[static_cast<std::size_t>(peak.index)].friction) +
         (more_elsewhere ? " The amplitude is largest at " + largest : "") + not_located(study) + still_rising(study);
}

/// "contact node 9 of 0 .. 9 (trailing edge)", or "contact segment ...".
std::string node_text(const Study& study, int node) {
  const ContactLine& contact = study.model.contact;
  const std::string place = contact.place_of(node);
  return name_of(contact.kind) + (" " + std::to_string(node)) + " of 0 .. " + std::to_string(contact.size() - 1) +
         (place.empty() ? "" : " (" + place + ")");
}

std::string where(const Study& study, const FieldResults& fields) {
  if (study.no_tip_touches()) return "";
  const std::optional<std::size_t> worst = worst_critical(study, fields);
  std::string text =
      "The tip at " +
      node_text(study, study.amplitudes.node[worst ? study.critical[*worst].index : study.amplitudes.worst()]);
  if (worst && fields.peaks[*worst] && !fields.peaks[*worst]->where.empty())
    text += "; stressed most: " + fields.peaks[*worst]->where;
  return text + ".";
}

/// " Engine order 6 is harmonic 3 of the 2 lobes of the casing; 10 sectors see it as 4 nodal diameters, since
/// 6 = 10 - 4."
std::string origin_text(const WaveLabel& wave, const SimulatedScene& scene) {
  const auto order = static_cast<int>(std::lround(wave.engine_order));
  if (order != wave.engine_order) return "";  // of a subharmonic motion
  const int turns = order - wave.signed_nodal_diameter;
  std::string text;
  if (order > 0 && scene.lobes > 0 && order % scene.lobes == 0)
    text = " Engine order " + std::to_string(order) + " is harmonic " + std::to_string(order / scene.lobes) +
           " of the " + counted(static_cast<std::size_t>(scene.lobes), "lobe") + " of the casing";
  if (text.empty() || turns <= 0 || turns % scene.sector_count != 0) return text.empty() ? text : text + ".";
  const int count = turns / scene.sector_count, n = wave.signed_nodal_diameter;
  return text + "; " + std::to_string(scene.sector_count) + " sectors see it as " +
         counted(static_cast<std::size_t>(std::abs(n)), "nodal diameter") + ", since " + std::to_string(order) +
         " = " + (count > 1 ? std::to_string(count) + " x " : "") + std::to_string(scene.sector_count) +
         (n == 0 ? "" : (n < 0 ? " - " : " + ") + std::to_string(std::abs(n))) + ".";
}

std::string why(const Study& study, const FieldResults& fields) {
  const std::optional<std::size_t> worst = worst_critical(study, fields);
  if (!worst) return "";
  const CriticalSpeed& peak = study.critical[*worst];
  const WaveLabel& wave = peak.naming_wave();
  std::string text = engine_order_name(wave.engine_order) + " drives family " + std::to_string(wave.family + 1) +
                     " on nodal diameter " + std::to_string(std::abs(wave.signed_nodal_diameter)) + " as a " +
                     name_of(wave.direction) + " wave (" + wave_name(wave) + "): " + mm_text(wave.amplitude) + ", " +
                     fixed(percent * wave.amplitude / peak.amplitude, 0) + " % of the amplitude, " +
                     fixed(percent * std::abs(wave.detuning), 1) + (wave.detuning < 0 ? " % below" : " % above") +
                     " that mode's frequency." + origin_text(wave, study.response.scene);
  if (peak.has_larger_wave())
    text += wave_name(wave) == wave_name(peak.largest)
                ? " The wave that rises most is " + wave_name(peak.rising) + " with " +
                      mm_text(peak.rising.amplitude) + "."
                : " That wave rises most; the largest is " + wave_name(peak.largest) + " with " +
                      mm_text(peak.largest.amplitude) + ".";
  const std::size_t named = peak.has_larger_wave() ? 1 : 0;  // the largest of the others is named already
  for (std::size_t i = named; i < std::min(named + 2, peak.others.size()); ++i)
    text += (i == named ? " Beside it: " : ", ") + wave_name(peak.others[i]) + " with " +
            mm_text(peak.others[i].amplitude);
  return text + (peak.others.size() <= named ? "" : ".");
}

/// "symmetry (1.52 at 22000 rpm, limit 1; 1 speed of 93)"; without the number if the limit is zero.
std::string failed_text(const Check& check) {
  constexpr int digits = 3;
  const std::string worst = check.limit > 0 && check.worst
                                ? significant(*check.worst, digits) + " at " + rpm_text(check.speed) + ", limit " +
                                      significant(check.limit, digits) + "; "
                                : "";
  return check.subject + " (" + worst + counted(static_cast<std::size_t>(check.beyond), "speed") + " of " +
         std::to_string(check.looked_at) + ")";
}

/// A line below the answer about trust, and by how many times it exceeds what is allowed, or the part of its quantity
/// that it leaves open.
struct TrustLine {
  double size = 0;
  std::string text;
};

/// The error budget of the worst critical speed or, if it has none, of the largest one that has; nullptr without
/// budgets.
const ErrorBudget* judged_budget(const std::vector<ErrorBudget>& budgets, const CriticalSpeed* worst) {
  if (budgets.empty()) return nullptr;
  const auto found = std::ranges::find(budgets, worst, &ErrorBudget::critical);
  return found == budgets.end() ? &largest_budget(budgets) : &*found;
}

std::string way_to_a_budget(const Study& study) {
  return study.parameters.component == Component::normal
             ? "simulate.budget = \"critical_speeds\""
             : "error budgets are of the motion along the normal: postprocess.component = \"normal\"";
}

/// " The largest motion is outside validity: ..."; empty if it is inside.
std::string largest_outside(const Study& study, const FieldResults& fields) {
  const std::string outside = outside_validity(study, study.amplitudes.worst(), fields.of_no_critical);
  return outside.empty() ? "" : " The largest motion is outside validity: " + outside + ".";
}

/// "The worst peak is not certain: outside validity (stress 1.09 of yield), 3 checks fail."
std::string trust_sentence(const Study& study, const FieldResults& fields, std::optional<std::size_t> worst,
                           const ErrorBudget* budget) {
  const std::vector<Check> checks = exactness_checks(study);
  const auto failed = static_cast<std::size_t>(std::ranges::count(checks, CheckVerdict::failed, &Check::verdict));
  const std::string checked =
      failed == 0 ? "no check fails" : counted(failed, "check") + (failed == 1 ? " fails" : " fail");
  if (!worst)
    return std::string(failed == 0 && study.failed.empty() ? "No" : "Some") +
           " doubt about the computation: " + checked +
           (study.failed.empty() ? "" : ", " + counted(study.failed.size(), "speed") + " failed") + "." +
           largest_outside(study, fields);
  const CriticalSpeed& peak = study.critical[*worst];
  const bool budgeted = budget != nullptr && budget->critical == &peak;
  const std::string outside = outside_validity(study, peak.index, fields.peaks[*worst]);
  const std::string missing = budgeted ? not_in_sum(*budget, BudgetRows::data_and_physics) : "";
  const BudgetSum open = budgeted ? sum_of(*budget, BudgetRows::data_and_physics) : BudgetSum{};
  std::string text = "The worst peak is computed within " + significant(percent * peak.amplitude_slack(), 2) +
                     " % of its amplitude and -" + fixed((peak.speed - peak.speed_low) * rpm_per_rad_s, 0) + " +" +
                     fixed((peak.speed_high - peak.speed) * rpm_per_rad_s, 0) + " rpm, ";
  text += budgeted
              ? "but data and physics leave " + significant(percent * open.amplitude, 2) +
                    " % of the amplitude and " + significant(percent * open.shift, 2) + " % of the speed uncertain" +
                    (missing.empty() ? "" : ", and find no such peak with " + missing)
              : "but what friction, damping and clearance change is not known (" + way_to_a_budget(study) + ")";
  if (!outside.empty()) text += "; it is outside validity: " + outside;
  return text + "; " + checked + ".";
}

/// "Budget: |u| uncertain by 32 %, most by damping 0.002 (+29 %)"
void add_budget(const ErrorBudget& budget, const CriticalSpeed* worst, std::vector<TrustLine>& lines) {
  const std::string place = budget.critical == worst ? "" : " at " + rpm_text(budget.critical->speed);
  for (const OpenQuantity& open : open_quantities(budget))
    lines.push_back({open.together, "Budget" + place + ": " + open.what + " uncertain by " +
                                        significant(percent * open.together, 2) + " %, most by " + open.most});
}

/// What makes the worst critical speed less certain beside its budget.
void add_motion(const Study& study, const std::vector<SceneNeed>& needs, const CriticalSpeed* worst,
                std::vector<TrustLine>& lines) {
  constexpr double hour = 3600;  // [s]
  for (const SceneNeed& need : needs)
    if (need.effect.effect == Effect::casing_wear && need.over_tolerance() > 1 &&
        std::isfinite(need.over_tolerance()))
      lines.push_back({need.over_tolerance(), "Wear reaches a tenth of the clearance in " +
                                                  significant(hour / need.over_tolerance(), 2) + " s"});
  if (worst == nullptr) return;
  const SpeedResponse& response = study.speed_at(worst->index);
  const std::string seen = whole_wheel_text(response);
  if (!seen.empty())
    lines.push_back({std::abs(whole_wheel(response)->blades->largest / study.excursion_at(worst->index) - 1),
                     "Motion: " + motion_text(response) + "; seen on the whole wheel: " + seen +
                         " mm (least, median, largest of the blades)"});
}

void add_checks(const Study& study, std::vector<TrustLine>& lines) {
  for (const Check& check : exactness_checks(study))
    if (check.verdict == CheckVerdict::failed)
      lines.push_back({check.limit > 0 ? check.worst.value_or(0) / check.limit : check.beyond,
                       "Check failed: " + failed_text(check)});
}

/// A sentence, then a line for each doubt, the largest first.
std::string trust(const Study& study, const FieldResults& fields, const std::vector<SceneNeed>& needs) {
  const std::vector<ErrorBudget> budgets = error_budgets(study, fields);
  const std::optional<std::size_t> place = worst_critical(study, fields);
  const CriticalSpeed* const worst = place ? &study.critical[*place] : nullptr;
  const ErrorBudget* const budget = judged_budget(budgets, worst);
  std::vector<TrustLine> lines;
  if (budget != nullptr) add_budget(*budget, worst, lines);
  add_motion(study, needs, worst, lines);
  add_checks(study, lines);
  std::ranges::stable_sort(lines, std::greater(), &TrustLine::size);
  std::string text = trust_sentence(study, fields, place, budget);
  for (const TrustLine& line : lines) text += "\n" + line.text + ".";
  for (const auto& [verdict, words] : {std::pair(CheckVerdict::undecided, "Undecided: "),
                                       std::pair(CheckVerdict::not_looked_at, "Not looked at: ")}) {
    const std::string subjects = listed(exactness_checks(study), ", ", [of = verdict](const Check& check) {
      return check.verdict == of ? check.subject : "";
    });
    if (!subjects.empty()) text += "\n" + std::string(words) + subjects + ".";
  }
  return study.failed.empty() ? text : text + "\n" + counted(study.failed.size(), "speed") + " failed.";
}

/// "trigonometric scheme, contact by complementarity"; empty if the response does not say.
std::string march_text(const SimulatedScene& scene) {
  if (!scene.scheme || !scene.contact) return "";
  std::string text =
      std::string(name_in(scheme_names, *scene.scheme)) + " scheme, contact by " +
      (*scene.contact == ContactRule::paper ? "the paper's rule" : name_in(contact_rule_names, *scene.contact));
  std::ranges::replace(text, '_', ' ');
  return text;
}

std::string interference_text(const Study& study) {
  const auto [low, high] = study.interference();
  return fixed(low * mm_per_m, 3) + " .. " + mm_text(high) + " (crest minus clearance, along the tip" +
         (low <= 0 && high <= 0 ? "; a tip that doesn't vibrate never touches)" : ")");
}

/// The effects that a better model of this scene would have to include, the largest over its tolerance first.
std::string what_matters(std::vector<SceneNeed> needs) {
  std::ranges::stable_sort(needs, std::greater(), &SceneNeed::over_tolerance);
  const std::string text = listed(needs, "; ", [](const SceneNeed& need) {
    const bool shown = need.verdict == NeedVerdict::matters && need.effect.treatment == Treatment::left_out;
    return shown ? meaning_of(need.effect.effect).words : "";
  });
  return text.empty() ? "" : "What is left out and matters in this scene: " + text + ".";
}

std::vector<Answer> without_empty(std::vector<Answer> answers) {
  std::erase_if(answers, [](const Answer& answer) { return answer.text.empty(); });
  return answers;
}

std::string given_words(ClearanceState state) {
  if (state == ClearanceState::cold) return "cold";
  return state == ClearanceState::at_speed ? "at one speed" : "for all speeds";
}

}  // namespace

std::string speeds_warning(const Study& study) {
  const std::string text = listed(speeds_checks(study), ", ", [](const Check& check) {
    return check.verdict == CheckVerdict::failed ? failed_text(check) : "";
  });
  return text.empty()
             ? text
             : "The speeds are too far apart: " + text +
                   ". Peaks may be missing, lie elsewhere and be higher than the tables say. Simulate " +
                   (study.parameters.component == Component::normal
                        ? "with speeds = \"adaptive\"."
                        : "more speeds: speeds = \"adaptive\" locates peaks along the casing's normal only.");
}

std::string printed_critical_speeds(const Study& study, const FieldResults& fields) {
  const std::string warning = speeds_warning(study), rising = still_rising(study);
  return (warning.empty() ? "" : "Not trustworthy. " + warning + "\n") +
         aligned_text(critical_speed_overview(study, fields)) + (rising.empty() ? "" : rising.substr(1) + "\n");
}

std::string running_clearances(const Response& response) {
  const LengthRange range = response.clearances();
  return "running clearances " + fixed(range.low * mm_per_m, 3) + " .. " + fixed(range.high * mm_per_m, 3) +
         " mm, given " + given_words(response.scene.clearance_state);
}

std::vector<Answer> verdict(const Study& study, const FieldResults& fields, const std::vector<SceneNeed>& needs) {
  const std::vector<AvoidedBand> bands = speeds_to_avoid(study, fields);
  std::vector<Answer> answers = {
      {"Not trustworthy", speeds_warning(study)},
      {"How bad", how_bad(study, fields)},
      {"Avoid", study.no_tip_touches() ? "" : bands_in_words(bands, fields) + unknown_speeds(study)},
      {"Margin", margin_text(study, fields, bands)},
      {"Where", where(study, fields)},
      {"Why", why(study, fields)},
      {"Trust", trust(study, fields, needs)},
      {"Left out", what_matters(needs)}};
  return without_empty(std::move(answers));
}

std::vector<Answer> scene_in_brief(const Study& study) {
  const SimulatedScene& scene = study.response.scene;
  const double crest = scene.crest();
  return without_empty(
      {{"Wheel",
        counted(static_cast<std::size_t>(scene.sector_count), "sector") + ", " +
            counted(static_cast<std::size_t>(study.model.contact.size()), name_of(study.model.contact.kind)) +
            (study.model.contact.splitter_nodes > 0 ? " on a main blade and its splitter" : " on each tip")},
       {"Casing",
        counted(static_cast<std::size_t>(scene.lobes), "lobe") + ", " + mm_text(crest) + " inward at the crest"},
       {"Clearance", running_clearances(study.response)},
       {"Interference", interference_text(study)},
       {"Damping", damping_text(scene)},
       {"March", march_text(scene)},
       {"Speeds",
        std::to_string(study.response.speeds.size()) + " from " + fixed(study.range.low * rpm_per_rad_s, 0) + " to " +
            rpm_text(study.range.high) +
            (study.failed.empty() ? "" : ", and " + std::to_string(study.failed.size()) + " that failed")}});
}

}  // namespace tiprub::postprocess
