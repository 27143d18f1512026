// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/scene_needs_record.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "postprocess/effects/casing_wear.h"
#include "postprocess/effects/second_order_gap.h"
#include "postprocess/records/columns.h"
#include "postprocess/records/exactness_record.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

constexpr double clearance_share = 0.1;   // of the smallest running clearance, that the gap may be wrong by
constexpr double frequency_limit = 1e-3;  // of a critical speed, that it is located to
constexpr double chatter_limit = 0.01;    // of the mean square: a tenth of the amplitude
constexpr double hour = 3600;             // [s]

NeedVerdict judged(double size, double tolerance) {
  return size <= tolerance ? NeedVerdict::negligible : NeedVerdict::matters;
}

SceneNeed estimated(const std::string& effect, double size, double tolerance, const std::string& how) {
  return {effect, size, tolerance, judged(size, tolerance), how};
}

SceneNeed not_estimated(const std::string& effect, const std::string& how) {
  return {.effect = effect, .how = how};
}

/// What simulate, or reduce, measured already. `otherwise`: how to, where it didn't.
SceneNeed measured(const std::vector<Check>& checks, const std::string& subject, const std::string& effect,
                   const std::string& otherwise) {
  const auto check = std::find_if(checks.begin(), checks.end(), [&](const Check& c) { return c.subject == subject; });
  if (check == checks.end() || check->verdict == CheckVerdict::not_looked_at) return not_estimated(effect, otherwise);
  const NeedVerdict verdict = check->verdict == CheckVerdict::passed   ? NeedVerdict::negligible
                              : check->verdict == CheckVerdict::failed ? NeedVerdict::matters
                                                                       : NeedVerdict::undecided;
  return {effect, check->worst, check->limit, verdict,
          "the largest at " + std::to_string(check->looked_at) + " of " + std::to_string(check->speeds) +
              " speeds; " + std::to_string(check->beyond) + " beyond"};
}

/// [mm] a tenth of the smallest running clearance at the judged speed.
double gap_tolerance(const Study& study) {
  return clearance_share * study.judged_response().clearance.minCoeff() * mm_per_m;
}

std::vector<SceneNeed> gap_needs(const Study& study, const FieldEffects& fields) {
  const SpeedResponse& response = study.judged_response();
  const SecondOrderGap gap = second_order_gap(response, study.response.scene, study.model.contact, fields.tip_span);
  const double tolerance = gap_tolerance(study);
  const std::string where = ", at " + rpm_text(response.speed);
  std::vector<SceneNeed> needs = {
      estimated("gap: a round casing is nearer to a tip that moves along the tangent [mm]", gap.curvature * mm_per_m,
                tolerance, "n_r u_theta^2/(2 r)" + where),
      estimated("gap: the casing's shape is read where the tip is at rest [mm]", gap.distortion * mm_per_m, tolerance,
                "steepest slope of the distortion, times u_theta/r" + where)};
  const std::string bending = "gap: a bent blade draws its tip back [mm]";
  needs.push_back(gap.foreshortening
                      ? estimated(bending, *gap.foreshortening * mm_per_m, tolerance,
                                  "(6/5) w^2/(2 L), w the motion across the normal, L from tip to disc" + where)
                      : not_estimated(bending, "give --fields with the part disc: it takes the blade's span"));
  return needs;
}

SceneNeed prestress_need(const ReducedModel& model) {
  const std::string effect = "stiffness under spin: " + model.stiffness_under_spin() + " prestress [1]";
  const Eigen::MatrixXd& misfit = model.verification.polynomial_misfit;
  if (model.prestress == Prestress::nonlinear && misfit.size() > 0)
    return estimated(effect, misfit.maxCoeff(), frequency_limit,
                     "frequencies by eq. 7 between the speeds that it goes through");
  return not_estimated(effect,
                       "compare /verification with that of tiprub-reduce --set 'reduce.prestress=\"nonlinear\"'");
}

SceneNeed coriolis_need(const FieldEffects& fields) {
  const std::string effect = "Coriolis terms: relative change of a frequency [1]";
  if (!fields.coriolis) return not_estimated(effect, "give --fields: it takes the modes of the critical speeds");
  const CoriolisShift& shift = *fields.coriolis;
  return estimated(effect, shift.change, frequency_limit,
                   "of the modes that make the critical speeds, largest at " + rpm_text(shift.speed) +
                       " (nodal diameter " + std::to_string(shift.nodal_diameter) + ", family " +
                       std::to_string(shift.family + 1) + ")");
}

SceneNeed diameters_need(const Study& study, const std::vector<Check>& checks) {
  const std::string effect = "nodal diameters left out: their growth a revolution [1]";
  const auto count = [&](SymmetryVerdict verdict) {
    const auto& speeds = study.response.speeds;
    return std::count_if(speeds.begin(), speeds.end(),
                         [&](const SpeedResponse& speed) { return speed.audit.symmetry == verdict; });
  };
  if (count(SymmetryVerdict::all_held) == static_cast<std::ptrdiff_t>(study.response.speeds.size()))
    return {.effect = effect, .verdict = NeedVerdict::negligible, .how = "none is left out"};
  SceneNeed need =
      measured(checks, "symmetry", effect, "compare with tiprub-simulate --set 'simulate.nodal_diameters=\"all\"'");
  if (need.verdict == NeedVerdict::not_estimated) return need;
  const auto unchecked = count(SymmetryVerdict::unchecked);
  if (unchecked > 0 && need.verdict == NeedVerdict::negligible) need.verdict = NeedVerdict::undecided;
  need.how += ", " + std::to_string(count(SymmetryVerdict::undecided)) + " undecided, " + std::to_string(unchecked) +
              " unchecked";
  return need;
}

std::vector<SceneNeed> model_needs(const Study& study, const FieldEffects& fields, const std::vector<Check>& checks) {
  const std::string nodes = std::to_string(study.model.contact.size());
  return {prestress_need(study.model),
          coriolis_need(fields),
          diameters_need(study, checks),
          measured(checks, "massless and truncated modes", "modes without mass: share of the elastic energy [1]", ""),
          measured(checks, "model", "modes left out of the model: error of the wheel's first frequencies [1]",
                   "reduce with verification_speeds"),
          not_estimated(name_of(study.model.contact.kind) + ("s: " + nodes),
                        "compare with tiprub-reduce --set reduce.contact_nodes=" +
                            std::to_string(2 * study.model.contact.size())),
          not_estimated("mesh", "compare two: make -C cases/convergence does so for its wheel")};
}

/// Of the motion: how it is marched and when it is left.
std::vector<SceneNeed> march_needs(const Study& study, const std::vector<Check>& checks) {
  double chatter = 0;
  int unsettled = 0;
  for (const SpeedResponse& speed : study.response.speeds) {
    chatter = std::max(chatter, speed.chatter);
    unsettled += speed.motion == MotionClass::not_settled;
  }
  const std::string speeds = "of " + std::to_string(study.response.speeds.size()) + " speeds";
  return {measured(checks, "time step", "time step: change by its last halving [1]",
                   "leave simulate.steps_per_revolution out"),
          measured(checks, "settling", "settling: change over the last period [1]",
                   "no motion settled; raise simulate.max_revolutions"),
          estimated("motions left before they have settled", unsettled, 0, speeds),
          estimated("chatter above the resolved frequencies: share of the mean square [1]", chatter, chatter_limit,
                    "the largest " + speeds)};
}

SceneNeed wear_need(const Study& study) {
  const double coefficient = study.parameters.wear_coefficient;
  const std::string effect = "wear: depth in the casing after an hour, order of magnitude [mm]";
  if (!(coefficient > 0)) return not_estimated(effect, "set postprocess.wear_coefficient");
  const SpeedResponse& response = study.judged_response();
  const CasingWear wear = casing_wear(response, study.response.scene, study.model.contact, coefficient, hour);
  const double allowed = gap_tolerance(study);
  if (!(wear.depth > 0)) return estimated(effect, 0, allowed, "no contact at " + rpm_text(response.speed));
  return estimated(effect, wear.depth * mm_per_m, allowed,
                   "Archard at " + rpm_text(response.speed) + ": k/H = " + significant(coefficient, 2) + " m^2/N, " +
                       fixed(wear.force, 0) + " N on average at contact node " + std::to_string(wear.node) +
                       "; the tolerance is reached after " +
                       significant(hour * allowed / (wear.depth * mm_per_m), 2) + " s");
}

}  // namespace

std::vector<SceneNeed> scene_needs(const Study& study, const FieldEffects& fields) {
  const std::vector<Check> checks = exactness_checks(study);
  std::vector<SceneNeed> needs = gap_needs(study, fields);
  for (std::vector<SceneNeed> more : {model_needs(study, fields, checks), march_needs(study, checks)})
    std::move(more.begin(), more.end(), std::back_inserter(needs));
  needs.push_back(wear_need(study));
  needs.push_back(not_estimated("friction at the tips, differences between the blades, heat, gas",
                                "no program of this chain models them"));
  return needs;
}

std::string name_of(NeedVerdict verdict) {
  switch (verdict) {
    case NeedVerdict::negligible:
      return "negligible";
    case NeedVerdict::matters:
      return "matters";
    case NeedVerdict::undecided:
      return "undecided";
    case NeedVerdict::not_estimated:
      return "not estimated";
  }
  return "";
}

Table scene_needs_record(const std::vector<SceneNeed>& needs) {
  return table_of<SceneNeed>({{"left out or simplified", [](const SceneNeed& need) { return need.effect; }},
                              {"size", [](const SceneNeed& need) { return optional_cell(need.size); }},
                              {"tolerance", [](const SceneNeed& need) { return optional_cell(need.tolerance); }},
                              {"verdict", [](const SceneNeed& need) { return name_of(need.verdict); }},
                              {"estimated by, or how to", [](const SceneNeed& need) { return need.how; }}},
                             needs);
}

}  // namespace tiprub
