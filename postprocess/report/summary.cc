// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/report/report.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "postprocess/analysis/other_motions.h"
#include "postprocess/records/exactness_record.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

std::string rule_sentence(const LinearRules& rules, double tolerance) {
  if (rules.equation_2_score.hits + rules.equation_2_score.misses == 0) return "";  // no critical speed
  const auto part = [](const RuleScore& score) {
    return "predicts " + std::to_string(score.hits) + " of " + std::to_string(score.hits + score.misses) + " (" +
           fixed(percent * score.predicted_share, 0) + " % of their summed amplitude) and raises " +
           counted(static_cast<std::size_t>(score.false_alarms), "false alarm") +
           (score.false_alarms > 0
                ? ", at which its wave reaches at most " + fixed(score.alarm_amplitude * mm_per_m, 3) + " mm"
                : std::string());
  };
  return "The linear rule (eq. 2) " + part(rules.equation_2_score) + "; with aliasing it " +
         part(rules.aliasing_score) + " (the same wave and family within " + fixed(percent * tolerance, 1) +
         " % of the speed; applied to the " + std::to_string(rules.moving.families.size()) + " families and " +
         std::to_string(rules.moving.engine_orders.size()) + " engine orders that move).";
}

/// "85 periodic, 6 subharmonic, 2 modulated"
std::string motion_counts(const std::vector<SpeedResponse>& speeds) {
  std::map<MotionClass, std::size_t> counts;
  for (const SpeedResponse& speed : speeds) ++counts[speed.motion];
  return listed(counts, ", ", [](const auto& of) { return text_of(of.second, " ", name_of(of.first)); });
}

std::string steadiness_sentence(const Study& study) {
  const std::vector<SpeedResponse>& speeds = study.response.speeds;
  std::size_t settled = 0, known = 0;
  double change = 0, closing = 0, by_step = 0;
  for (const SpeedResponse& speed : speeds) {
    settled += speed.settled();
    if (speed.settled()) change = std::max(change, speed.change);
    closing = std::max(closing, std::abs(speed.energy.closing_error));
    const std::optional<double> error = step_error(speed, study.response.scene.asked);
    known += error.has_value();
    by_step = std::max(by_step, error.value_or(0));
  }
  return counted(speeds.size(), "speed") + " computed: " + motion_counts(speeds) + ", " +
         std::to_string(study.failed.size()) + " failed. At " + counted(settled, "speed") +
         " the motion has settled, with a change of at most " + scientific(change, 1) +
         " per period; the energy balance closes to " + scientific(closing, 1) +
         (known > 0 ? "; at " + counted(known, "speed") + " the time step changes the motion by at most " +
                          significant(by_step, 3)
                    : "; half the time step was not tried") +
         ".";
}

/// "12000 to 12400, 13000 rpm": the speeds for which a property holds; neighbours are joined.
template <class Property>
std::string runs_of_speeds(const std::vector<SpeedResponse>& speeds, const Property& holds) {
  std::string text;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    if (!holds(speeds[i]) || (i > 0 && holds(speeds[i - 1]))) continue;
    std::size_t last = i;
    while (last + 1 < speeds.size() && holds(speeds[last + 1])) ++last;
    text += (text.empty() ? "" : ", ") + fixed(speeds[i].speed * rpm_per_rad_s, 0) +
            (last > i ? " to " + fixed(speeds[last].speed * rpm_per_rad_s, 0) : "");
  }
  return text.empty() ? text : text + " rpm";
}

std::string unusual_sentence(const std::vector<SpeedResponse>& speeds) {
  std::string text;
  const auto add = [&](const std::string& what, const std::string& where) {
    if (!where.empty()) text += (text.empty() ? "" : " ") + what + ": " + where + ".";
  };
  add("Not settled", runs_of_speeds(speeds, [](const SpeedResponse& speed) { return !speed.settled(); }));
  for (const MotionClass motion : {MotionClass::modulated, MotionClass::broadband})
    add("Motion " + std::string(name_of(motion)),
        runs_of_speeds(speeds, [&](const SpeedResponse& speed) { return speed.motion == motion; }));
  add("Subharmonic motion",
      runs_of_speeds(speeds, [](const SpeedResponse& speed) { return speed.motion == MotionClass::subharmonic; }));
  add("A nodal diameter that was left out is unstable (run these with nodal_diameters = \"all\")",
      runs_of_speeds(speeds,
                     [](const SpeedResponse& speed) { return speed.audit.symmetry == SymmetryVerdict::breaking; }));
  return text;
}

std::string sweep_sentence(const Study& study) {
  if (study.sweeps.empty()) return "";
  std::size_t apart = 0;
  const SweepComparison* largest = nullptr;
  const auto change = [&](const SweepComparison& compared) {
    double most = 0;
    for (const auto& swept : {compared.up, compared.down})
      if (swept && swept->differs)
        most = std::max(most, std::abs(swept->amplitude - study.amplitudes.largest[compared.index]));
    return most;
  };
  for (const SweepComparison& compared : study.sweeps) {
    if (!compared.differs()) continue;
    ++apart;
    if (largest == nullptr || change(compared) > change(*largest)) largest = &compared;
  }
  const auto shared = std::ranges::count_if(study.sweeps, [](const SweepComparison& at) { return at.up || at.down; });
  if (shared == 0) return "The sweeps share no speed with the response from rest.";
  if (largest == nullptr)
    return "At " + counted(static_cast<std::size_t>(shared), "speed") + " of " + std::to_string(study.sweeps.size()) +
           ", sweeps reach the same motions as marches from rest.";
  return "At " + counted(apart, "speed") +
         " more than one motion exists: sweeps differ from the response from rest, most at " +
         rpm_text(study.response.speeds[static_cast<std::size_t>(largest->index)].speed) + ", by " +
         fixed(change(*largest) * mm_per_m, 3) + " mm of amplitude.";
}

/// "From 33800.0 to 34800 rpm 3 orbits exist, 1 of them attracts. Stability changes at 33900 rpm (flip)."
std::string branch_sentence(const Response& response) {
  const std::vector<OrbitBranch>& branches = response.branches;
  const std::string text = listed(ranges_of_many_orbits(branches), " ", [](const OrbitRange& range) {
    return "From " + fixed(range.low * rpm_per_rad_s, 1) + " to " + rpm_text(range.high) + " " +
           std::to_string(range.orbits) + " orbits exist, " +
           (range.attracting == 0
                ? "none of them attracts."
                : std::to_string(range.attracting) + " of them attract" + (range.attracting == 1 ? "s." : "."));
  });
  std::string changes = listed(stability_changes(branches), ", ", [](const StabilityChange& change) {
    return rpm_text(change.speed) + " (" + name_of(change.kind) + ")";
  });
  if (!changes.empty()) changes = " Stability changes at " + changes + ".";
  const ModelledEffect* const impacts = find(response.scene.effects, Effect::impact_instants);
  if (!branches.empty() && impacts != nullptr && impacts->treatment == Treatment::simplified)
    changes += " About the stability of the branches: " + impacts->reason + ".";
  return text + changes;
}

std::string share_sentence(const InteractionMap& map) {
  constexpr double invisible = 5e-5;
  const Eigen::VectorXd shares = energy_shares(map);
  std::string text;
  for (Eigen::Index n = 0; n < shares.size(); ++n)
    text += (n > 0 ? ", " : "") + std::to_string(n) + ": " +
            (shares[n] < invisible ? std::string("0") : fixed(percent * shares[n], 2));
  return "Share of the motion by nodal diameter, over all speeds [%]: " + text + ".";
}

}  // namespace

std::vector<std::string> summary(const Study& study) {
  std::vector<std::string> lines;
  for (const std::string& line :
       {rule_sentence(study.rules, study.parameters.prediction_tolerance), steadiness_sentence(study),
        unusual_sentence(study.response.speeds), sweep_sentence(study), branch_sentence(study.response),
        share_sentence(study.waves.first())})
    if (!line.empty()) lines.push_back(line);
  return lines;
}

}  // namespace tiprub::postprocess
