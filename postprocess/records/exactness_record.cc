// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/exactness_record.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>
#include <utility>

#include "reduce/model/reduced_model.h"

namespace tiprub::postprocess {

namespace {

constexpr double frequency_share = 0.05;    // of the accuracy asked for, since a peak lies where its mode does
constexpr double energy_limit = 1e-6;       // the balance closes to rounding
constexpr double penetration_limit = 0.01;  // of the smallest running clearance, or of the crest
constexpr double left_out_limit = 0.01;     // of the elastic energy
constexpr double stable_growth = 1.0;       // per revolution
constexpr double sweep_limit = 0.01;        // above it a sweep reached another motion (other_motions.h)

/// A number of a speed; nothing where simulate did not compute it.
using Number = std::function<std::optional<double>(const SpeedResponse&)>;

CheckVerdict verdict_of(const Check& check) {
  if (check.looked_at == 0) return CheckVerdict::not_looked_at;
  return check.beyond > 0 ? CheckVerdict::failed : CheckVerdict::passed;
}

void add(Check& check, double value, double speed) {
  ++check.looked_at;
  if (!(value <= check.limit)) ++check.beyond;
  if (check.worst && value <= *check.worst) return;
  check.worst = value;
  check.speed = speed;
}

Check check_speeds(const Study& study, const std::string& subject, const std::string& what, double limit,
                   const Number& number) {
  Check check{
      .subject = subject, .what = what, .limit = limit, .speeds = static_cast<int>(study.response.speeds.size())};
  for (const SpeedResponse& speed : study.response.speeds) {
    if (const std::optional<double> here = number(speed)) add(check, std::abs(*here), speed.speed);
  }
  check.verdict = verdict_of(check);
  return check;
}

/// A check of the model at its few verification speeds: `beyond` only says whether the worst is above the limit.
Check check_model(const std::string& what, double limit, const Eigen::VectorXd& speeds, double worst, double speed) {
  const auto count = static_cast<int>(speeds.size());
  return {.subject = "model",
          .what = what,
          .limit = limit,
          .worst = worst,
          .speed = speed,
          .looked_at = count,
          .speeds = count,
          .beyond = worst <= limit ? 0 : 1,
          .verdict = worst <= limit ? CheckVerdict::passed : CheckVerdict::failed};
}

std::vector<Check> model_checks(const ReducedModel& model, double limit) {
  const ModelError error = model_error(model);
  const Verification& verification = model.verification;
  if (error.frequencies == 0)
    return {{.subject = "model", .what = "frequencies against the unreduced sector [1]", .limit = limit}};
  std::vector<Check> checks = {check_model(
      "the wheel's first " + std::to_string(error.frequencies) + " frequencies against the unreduced sector [1]",
      limit, verification.speeds, error.error, error.speed)};
  if (!polynomial_misfit(model)) return checks;
  const Eigen::Index held = (verification.speeds.array() <= model.speed_max).count();
  Eigen::Index row = 0, column = 0;
  const double largest = verification.polynomial_misfit.topRows(held).maxCoeff(&row, &column);
  checks.push_back(check_model("frequencies by the polynomial stiffness (eq. 7) alone, between its speeds [1]", limit,
                               verification.speeds, largest, verification.speeds[row]));
  return checks;
}

/// [1] The relative uncertainty of a peak's amplitude due to step, settling and the distance of the speeds.
double left_open(const CriticalSpeed& critical, const SpeedResponse& response) {
  const double range =
      std::max(critical.amplitude_high - critical.amplitude, critical.amplitude - critical.amplitude_low);
  return range / critical.amplitude + (response.settled() ? response.change : 0.0);
}

/// Of the peaks, located or not.
Check check_peaks(const Study& study, const std::string& subject, const std::string& what, double limit,
                  const std::function<std::optional<double>(const CriticalSpeed&)>& number) {
  Check check{.subject = subject,
              .what = what,
              .limit = limit,
              .speeds = static_cast<int>(study.critical.size() + study.not_located.size())};
  for (const auto* peaks : {&study.critical, &study.not_located})
    for (const CriticalSpeed& peak : *peaks)
      if (const std::optional<double> here = number(peak)) add(check, *here, peak.speed);
  check.verdict = verdict_of(check);
  return check;
}

Check accuracy_check(const Study& study) {
  return check_peaks(study, "accuracy", "of the peaks' amplitudes, what step, settling and speeds leave open [1]",
                     study.response.scene.asked.critical_speeds,
                     [&](const CriticalSpeed& peak) { return left_open(peak, study.speed_at(peak.index)); });
}

std::vector<Check> march_checks(const Study& study) {
  const AskedAccuracy& asked = study.response.scene.asked;
  return {
      check_speeds(study, "time step", "estimated relative error, or change by the last halving [1]", asked.step,
                   [&](const SpeedResponse& speed) { return step_error(speed, asked); }),
      check_speeds(study, "settling", "relative change over the last period, of settled motions [1]", asked.settling,
                   [](const SpeedResponse& speed) -> std::optional<double> {
                     if (!speed.settled()) return {};
                     return speed.change;
                   }),
      check_speeds(study, "unsettled motion", "1 where the motion repeats itself within no whole revolutions", 0,
                   [](const SpeedResponse& speed) { return speed.settled() ? 0.0 : 1.0; }),
      check_speeds(study, "energy", "closing error of the balance [1]", energy_limit,
                   [](const SpeedResponse& speed) { return speed.energy.closing_error; }),
      check_speeds(study, "massless and truncated modes", "share of the elastic energy [1]", left_out_limit,
                   [](const SpeedResponse& speed) { return speed.left_out_energy; })};
}

std::vector<Check> contact_checks(const Study& study) {
  const double clearance = std::abs(study.response.clearances().low);
  const double scale = clearance > 0 ? clearance : study.response.scene.crest();
  return {check_speeds(study, "penetration", "of a node into the casing [mm]", penetration_limit * scale * mm_per_m,
                       [](const SpeedResponse& speed) { return speed.largest_penetration * mm_per_m; }),
          check_speeds(study, "steps left in penetration", "recorded steps that end with a node in the casing", 0,
                       [](const SpeedResponse& speed) { return static_cast<double>(speed.leftover_steps); }),
          check_speeds(study, "tension", "tensile share of the contact force [1]", 0,
                       [](const SpeedResponse& speed) { return speed.tension_share; })};
}

/// The verdicts are those of simulate, which knows how certain its growth is.
Check symmetry_check(const Study& study) {
  Check check = check_speeds(study, "symmetry",
                             "growth per revolution of a small disturbance by the nodal diameters left out [1]",
                             stable_growth, [](const SpeedResponse& speed) { return speed.audit.excluded_growth; });
  if (check.looked_at == 0) return check;
  check.beyond = speeds_with(SymmetryVerdict::breaking, study);
  check.verdict = check.beyond > 0                                     ? CheckVerdict::failed
                  : speeds_with(SymmetryVerdict::undecided, study) > 0 ? CheckVerdict::undecided
                                                                       : CheckVerdict::passed;
  return check;
}

/// Between the speeds that were simulated or scanned without failure: a resonance with the smallest damping of all
/// modes may hide there, unless nothing excites the wheel.
Check range_check(const Study& study) {
  std::set<double> speeds;
  for (Eigen::Index k = 0; k < study.response.scanned_speeds.size(); ++k)
    if (study.response.scanned_amplitudes[k] >= 0) speeds.insert(study.response.scanned_speeds[k]);
  for (const SpeedResponse& speed : study.response.speeds) speeds.insert(speed.speed);
  Check check{
      .subject = "speeds over the range",
      .what = "distance of neighbours, scanned ones too, over the half-width of the least damped resonance [1]",
      .limit = finding_spacing,
      .speeds = std::max(static_cast<int>(speeds.size()) - 1, 0)};
  const std::optional<double> damping = study.curves.smallest_damping_ratio();
  const bool excited = damping && !study.no_tip_touches() && !speeds.empty();
  if (excited && *damping == 0)  // no distance is small enough for a resonance without width
    check.looked_at = check.beyond = check.speeds;
  if (excited && *damping > 0)
    for (auto low = speeds.begin(), high = std::next(low); high != speeds.end(); ++low, ++high)
      add(check, (*high - *low) / (*damping * *low), *low);
  check.verdict = verdict_of(check);
  return check;
}

/// Of the motions at the simulated speeds.
std::vector<Check> response_checks(const Study& study) {
  std::vector<Check> checks = joined<Check>({{accuracy_check(study)}, march_checks(study), contact_checks(study)});
  if (speeds_with(SymmetryVerdict::all_held, study) < static_cast<int>(study.response.speeds.size()))
    checks.push_back(symmetry_check(study));
  Check sweep = check_speeds(study, "sweep", "relative difference from the response from rest [1]", sweep_limit,
                             [](const SpeedResponse& speed) { return speed.audit.rest_difference; });
  if (sweep.looked_at > 0) checks.push_back(std::move(sweep));  // of a response that is a sweep
  return checks;
}

}  // namespace

int speeds_with(SymmetryVerdict verdict, const Study& study) {
  return static_cast<int>(std::ranges::count(study.response.speeds, verdict,
                                             [](const SpeedResponse& speed) { return speed.audit.symmetry; }));
}

std::string name_of(CheckVerdict verdict) {
  constexpr std::array names = {"yes", "no", "undecided", "not looked at"};
  return names[static_cast<std::size_t>(verdict)];
}

std::optional<double> step_error(const SpeedResponse& speed, const AskedAccuracy& asked) {
  if (speed.audit.step_reached) return *speed.audit.step_reached * asked.step;
  return speed.audit.halving_difference;
}

std::vector<Check> speeds_checks(const Study& study) {
  return {check_peaks(study, "speeds beside each peak", "their distance over the half-width of its resonance [1]",
                      resolving_spacing, [](const CriticalSpeed& peak) { return peak.spacing_over_half_width(); }),
          range_check(study)};
}

bool speeds_too_far_apart(const Study& study) {
  return std::ranges::count(speeds_checks(study), CheckVerdict::failed, &Check::verdict) > 0;
}

std::string speeds_caveat(const Study& study) {
  return speeds_too_far_apart(study) ? " (not trustworthy: speeds too far apart)" : "";
}

std::vector<Check> exactness_checks(const Study& study) {
  std::vector<Check> of_response = response_checks(study);
  if (speeds_too_far_apart(study))
    for (Check& check : of_response)
      if (check.verdict == CheckVerdict::passed) check.verdict = CheckVerdict::undecided;
  return joined<Check>({speeds_checks(study),
                        model_checks(study.model, frequency_share * study.response.scene.asked.critical_speeds),
                        std::move(of_response)});
}

Table exactness_record(const Study& study) {
  Table table{{"check", "limit", "worst of those looked at", "at [rpm]", "passed", "speeds looked at", "speeds",
               "speeds beyond the limit"},
              {}};
  for (const Check& check : exactness_checks(study)) {
    const Cell none = std::string();
    table.rows.push_back({check.subject + ": " + check.what, check.limit, check.worst ? Cell(*check.worst) : none,
                          check.worst && *check.worst > 0 ? Cell(check.speed * rpm_per_rad_s) : none,
                          name_of(check.verdict), check.looked_at, check.speeds, check.beyond});
  }
  return table;
}

}  // namespace tiprub::postprocess
