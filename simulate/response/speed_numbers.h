// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "simulate/response/response.h"

namespace tiprub {

/// The allowed range of a number of a speed that did not fail; ends included.
struct Bounds {
  double low, high;
};
constexpr double beyond_counting = 9007199254740992.0;  // 2^53: up to here a double holds every whole number
constexpr Bounds any = {-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
constexpr Bounds not_negative = {0, any.high}, not_positive = {any.low, 0}, share = {0, 1};
constexpr Bounds whole = {0, beyond_counting}, at_least_one = {1, beyond_counting},
                 at_least_two = {2, beyond_counting};

/// How response.h5 describes a number of a speed.
struct NumberMeaning {
  const char* name;
  const char* units;
  const char* long_name;
  Bounds bounds;
};

template <class Speed, class Visit>
void visit_motion(Speed& speed, Visit visit) {
  visit({"steps_per_revolution", "1", "steps of the march in a revolution", at_least_one},
        speed.steps_per_revolution);
  visit({"samples_per_revolution", "1", "samples in a revolution", at_least_two}, speed.samples_per_revolution);
  visit({"recorded_revolutions", "1", "revolutions recorded", at_least_one}, speed.recorded_revolutions);
  visit({"revolutions", "1", "revolutions marched in all", whole}, speed.revolutions);
  visit({"amplitude", "m", "half of the peak-to-peak normal displacement, the largest", not_negative},
        speed.amplitude);
  visit({"period_revolutions", "1", "revolutions after which the motion repeats itself; 0: not settled", whole},
        speed.period_revolutions);
  visit({"period_beats", "1", "beats after which the motion repeats itself; 0: it does not", whole},
        speed.period_beats);
  visit({"off_beat_energy", "1", "share of the mean square at no multiple of the beat's frequency", any},
        speed.off_beat_energy);
  visit({"chatter", "1", "share of the mean square above the resolved frequency", any}, speed.chatter);
  visit({"chatter_node", "1", "contact node with most chatter, from 0", whole}, speed.chatter_node);
  visit({"change", "1", "relative change of the motion over its period", not_negative}, speed.change);
  visit({"change_rate", "1", "factor of that change in a revolution", any}, speed.change_rate);
  visit({"step_ratio", "1", "h omega_max / 2", not_negative}, speed.step_ratio);
}

template <class Speed, class Visit>
void visit_contact(Speed& speed, Visit visit) {
  visit({"contact_work", "J", "work of the casing on the wheel, as recorded", any}, speed.energy.contact_work);
  visit({"dissipated", "J", "energy taken by damping, as recorded", any}, speed.energy.dissipated);
  visit({"energy_change", "J", "change of kinetic and elastic energy, as recorded", any}, speed.energy.energy_change);
  visit({"energy_closing_error", "1", "what the three leave open, of the largest", any}, speed.energy.closing_error);
  visit({"largest_penetration", "m", "largest penetration of a contact node", not_negative},
        speed.largest_penetration);
  visit({"smallest_multiplier", "N", "smallest contact force; negative: tensile", not_positive},
        speed.smallest_multiplier);
  visit({"contact_steps", "1", "recorded steps with contact", whole}, speed.contact_steps);
  visit({"tension_steps", "1", "recorded steps with a tensile contact force", whole}, speed.tension_steps);
  visit({"solver_fallbacks", "1", "steps in which the contact solver fell back", whole}, speed.solver_fallbacks);
}

template <class Speed, class Visit>
void visit_friction(Speed& speed, Visit visit) {
  auto& load = speed.friction;
  visit({"drag_work", "J", "part of contact_work that friction does on the vibration", any}, load.drag_work);
  visit({"blade_drag_mean", "N", "friction on a blade, mean", not_negative}, load.blade_drag_mean);
  visit({"blade_drag_largest", "N", "friction on a blade, largest of a sample", not_negative},
        load.blade_drag_largest);
  visit({"rub_torque_mean", "N m", "torque of friction against the wheel, mean", any}, load.rub_torque_mean);
  visit({"rub_torque_largest", "N m", "torque of friction against the wheel, largest of a sample", any},
        load.rub_torque_largest);
  visit({"rub_power_mean", "W", "power of that torque, mean", any}, load.rub_power_mean);
  visit({"rub_power_largest", "W", "power of that torque, largest of a sample", any}, load.rub_power_largest);
  visit({"blade_rub_power_mean", "W", "power of the torque on one blade, mean", any}, load.blade_rub_power_mean);
  visit({"blade_rub_power_largest", "W", "power of the torque on one blade, largest of a sample", any},
        load.blade_rub_power_largest);
}

template <class Speed, class Visit>
void visit_audit(Speed& speed, Visit visit) {
  auto& audit = speed.audit;
  visit({"halving_difference", "1", "what the last halving of the step changed", not_negative},
        audit.halving_difference);
  visit({"step_reached", "1", "estimated error of the step over step_tolerance; above 1: not reached", not_negative},
        audit.step_reached);
  visit({"excluded_growth", "1", "growth in a revolution of nodal diameters left out", not_negative},
        audit.excluded_growth);
  visit({"excluded_growth_uncertainty", "1", "uncertainty of that growth", not_negative},
        audit.excluded_growth_uncertainty);
  visit({"rest_difference", "1", "relative difference to the motion from rest", not_negative}, audit.rest_difference);
  visit({"left_out_energy", "1", "elastic energy of modes left out, of all", any}, speed.left_out_energy);
  visit({"compliance_condition", "1", "condition number of W", not_negative}, audit.compliance_condition);
  visit({"leftover_steps", "1", "recorded steps that leave a node in the casing", whole}, speed.leftover_steps);
  visit({"tension_share", "1", "share of tensile contact force", share}, speed.tension_share);
}

/// Calls `visit(meaning, value)` with every number of a speed: one list for the writers and the reader. The value is
/// an int, a std::int64_t, a double, or, if it may be absent, a std::optional<double>.
template <class Speed, class Visit>
void visit_numbers(Speed& speed, Visit visit) {
  visit_motion(speed, visit);
  visit_contact(speed, visit);
  visit_friction(speed, visit);
  visit_audit(speed, visit);
}

/// The same for the search for an orbit; older files have no `orbit_maps`.
template <class Orbit, class Visit>
void visit_orbit_numbers(Orbit& orbit, Visit visit) {
  visit({"orbit_maps", "1", "maps after which the orbit repeats itself", at_least_one}, orbit.maps);
  visit({"orbit_revolutions", "1", "revolutions that all maps come to", not_negative}, orbit.revolutions);
  visit({"orbit_residual", "1", "relative change of the state by the map", not_negative}, orbit.residual);
  visit({"multiplier", "1", "magnitude in a revolution of the largest Floquet multiplier", not_negative},
        orbit.multiplier);
  visit({"multiplier_uncertainty", "1", "uncertainty of that magnitude", not_negative}, orbit.multiplier_uncertainty);
  visit({"multiplier_angle", "rad", "angle of that multiplier, a map", not_negative}, orbit.multiplier_angle);
}

/// A text of a speed in response.h5.
struct SpeedText {
  const char* name;
  const char* long_name;
  std::string value;
};

std::vector<SpeedText> texts_of(const SpeedResponse& speed);

/// What a speed shows along the axis of all speeds.
struct SpeedRow {
  struct Number {
    NumberMeaning meaning;
    double value;  ///< NaN where the speed has none
  };
  double speed;  ///< [rad/s]
  std::vector<Number> numbers;
  std::vector<SpeedText> texts;
};

}  // namespace tiprub
