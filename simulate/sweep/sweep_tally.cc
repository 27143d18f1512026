// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/sweep_tally.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "cases/program/units.h"

namespace tiprub::simulate {

namespace {

constexpr double same_motion = 1e-2;        // relative difference to the motion from rest
constexpr double grazing = 1e-9;            // [m] rounding of an overlap
constexpr double tolerated_tension = 1e-2;  // of the contact force

std::string audit_text(const SpeedResponse& response) {
  std::ostringstream text;
  const SpeedAudit& audit = response.audit;
  const OrbitReport& orbit = audit.orbit;
  if (orbit.outcome == OrbitReport::Outcome::found)
    text << ", an orbit (residual " << orbit.residual << ", " << orbit.revolutions << " revolutions of maps), ";
  if (orbit.outcome == OrbitReport::Outcome::marched)
    text << ", no orbit after " << orbit.revolutions << " revolutions of maps, ";
  if (orbit.outcome != OrbitReport::Outcome::none) text << "multiplier " << orbit.multiplier << " a revolution";
  if (audit.halving_difference)
    text << ", the last halving of the step changed the "
         << name_of(audit.halving_measure.value_or(MotionMeasure::motion)) << " by " << *audit.halving_difference;
  else if (!audit.halving_failure.empty())
    text << ", half the step failed: " << audit.halving_failure;
  if (audit.step_reached.value_or(0) > 1)
    text << ", step_tolerance NOT REACHED: the estimated error is " << *audit.step_reached << " times that";
  if (audit.excluded_growth) text << ", excluded nodal diameters x " << *audit.excluded_growth << " a revolution";
  if (audit.symmetry == SymmetryVerdict::breaking) text << ": symmetry-breaking";
  if (audit.symmetry == SymmetryVerdict::undecided) text << ": undecided";
  if (audit.rest_difference) text << ", " << *audit.rest_difference << " from the motion from rest";
  if (response.left_out_energy > 0) text << ", modes left out hold " << response.left_out_energy << " of the energy";
  return text.str();
}

ClosestApproach approach(const SpeedResponse& response, const Eigen::VectorXd& crest) {
  ClosestApproach nearest;
  nearest.speed = response.speed;
  nearest.gap = (response.clearance - crest).minCoeff(&nearest.node);
  return nearest;
}

/// How to change the case to march the whole wheel at these speeds.
std::string breaking_text(const std::vector<double>& speeds, BrokenSymmetry broken) {
  std::ostringstream out;
  out << "\nsymmetry-breaking at " << speeds.size() << " speeds: a nodal diameter that was left out grows";
  if (broken == BrokenSymmetry::full_run) {
    out << "; these are run again with the whole wheel";
    return out.str();
  }
  out << ". For the whole wheel there, set [simulate] when_symmetry_breaks = \"full_run\", or run again into another "
         "file with "
         "nodal_diameters = \"all\", speeds = \"given\" and, in place of speed_min_rpm, speed_max_rpm and "
         "speed_count, "
         "speeds_rpm = [";
  out << std::setprecision(10);
  for (std::size_t i = 0; i < speeds.size(); ++i) out << (i > 0 ? ", " : "") << speeds[i] * rpm_per_rad_s;
  out << "]";
  return out.str();
}

}  // namespace

std::string speed_line(const SpeedResponse& response) {
  std::ostringstream text;
  text << response.speed * rpm_per_rad_s << " rev/min: ";
  if (!response.failure.empty()) {
    text << "failed: " << response.failure;
    return text.str();
  }
  text << motion_text(response.motion, response.period_beats);
  text << " after " << response.revolutions << " revolutions of " << response.steps_per_revolution
       << " steps, change " << response.change << " (x " << response.change_rate << " a revolution), "
       << response.contact_steps << " steps in contact, energy closing error " << response.energy.closing_error;
  if (response.tension_steps > 0)
    text << ", " << response.tension_steps << " steps with tensile contact forces (share " << response.tension_share
         << ")";
  if (response.leftover_steps > 0)
    text << ", " << response.leftover_steps << " steps leave up to " << response.largest_penetration
         << " m of penetration";
  if (response.solver_fallbacks > 0) text << ", " << response.solver_fallbacks << " solver fallbacks";
  if (response.friction.rub_power_mean)
    text << ", friction takes " << *response.friction.rub_power_mean << " W, at most "
         << *response.friction.rub_power_largest << " W";
  text << audit_text(response) << ", cond W " << response.audit.compliance_condition;
  return text.str();
}

void SweepTally::add(const SpeedResponse& response) {
  if (!response.failure.empty()) {
    if (failed++ == 0) first_failure = speed_line(response);
    return;
  }
  ++motions[response.motion];
  if (response.contact_steps > 0) ++touching;
  if (crest.size() > 0) closest = std::min(closest, approach(response, crest));
  if (response.tension_steps > 0) ++pulling;
  if (response.leftover_steps > 0) ++penetrating;
  if (response.audit.symmetry == SymmetryVerdict::breaking) breaking.push_back(response.speed);
  if (response.audit.orbit.outcome == OrbitReport::Outcome::marched) ++marched;
  if (response.audit.orbit.multiplier > 0 && response.contact_steps > 0) ++judged;
  if (response.audit.rest_difference.value_or(0) > same_motion) ++apart_from_rest;
  if (response.audit.step_reached.value_or(0) > 1) ++unreached;
  farthest = std::max(farthest, response.audit.step_reached.value_or(0));
  if (response.audit.halving_difference) ++halved;
  largest_halving = std::max(largest_halving, response.audit.halving_difference.value_or(0));
  tension_share = std::max(tension_share, response.tension_share);
  rub_power = std::max(rub_power, response.friction.rub_power_mean.value_or(0));
}

std::string SweepTally::text() const {
  std::ostringstream out;
  if (unreached > 0) out << "step_tolerance not reached at " << unreached << " (by up to " << farthest << " times); ";
  for (const auto& [motion, count] : motions) out << count << " " << name_of(motion) << ", ";
  out << failed << " failed";
  if (marched > 0) out << "; marched, for want of a stable orbit, at " << marched;
  if (halved > 0)
    out << "; the last halving of the step, at " << halved << " of them, changed at most " << largest_halving;
  if (rub_power > 0) out << "; friction takes up to " << rub_power << " W";
  return out.str();
}

std::string SweepTally::untouched(const ContactLine& contact) const {
  if (touching > 0 || failed > 0 || motions.empty()) return "";
  std::ostringstream out;
  if (closest.gap <= -grazing) {
    out << "\nno step met the casing, although its crests overlap the tips by up to " << std::setprecision(4)
        << -closest.gap << " m: the crests are narrower than a step; give more steps_per_revolution";
    return out.str();
  }
  if (closest.gap <= 0) return "";
  out << "\nno tip touches the casing at any speed";
  if (std::isfinite(closest.gap)) {
    const std::string place = contact.place_of(closest.node);
    out << std::setprecision(4) << ": the gap closes to " << closest.gap << " m at the least, at "
        << std::lround(closest.speed * rpm_per_rad_s) << " rev/min at the "
        << (place.empty() ? "contact node " + std::to_string(closest.node) : place);
  }
  out << "; for contact, give [casing] less clearance or more distortion, in metres";
  return out.str();
}

std::string SweepTally::warnings(const SimulateParameters& parameters) const {
  std::ostringstream out;
  if (cut_short)
    out << "\nspeed_count_max = " << parameters.speed_count_max
        << " ended the search for peaks: some may be missing or not located";
  if (pulling > 0)
    out << "\nat " << pulling << " speeds contact forces are tensile in some steps, with a share of up to "
        << tension_share;
  if (tension_share > tolerated_tension)
    out << ": more than " << tolerated_tension << ", these results are not reliable";
  if (penetrating > 0) out << "\nat " << penetrating << " speeds steps leave a node in the casing";
  if (judged > 0 && !finds_impacts(parameters.scheme, parameters.contact))
    out << "\nat " << judged << " speeds the Floquet multiplier lacks how the instants of impacts move: it does not "
        << "hold where a node leaves at once; take scheme = \"" << name_in(scheme_names, Scheme::trigonometric)
        << "\"";
  if (!breaking.empty()) out << breaking_text(breaking, parameters.when_symmetry_breaks);
  if (failed > 0) out << "\nfirst failure: " << first_failure;
  if (apart_from_rest > 0) out << "\nat " << apart_from_rest << " speeds the motion differs from the one from rest";
  return out.str();
}

}  // namespace tiprub::simulate
