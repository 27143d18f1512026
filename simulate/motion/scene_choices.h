// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "cases/program/named_values.h"

namespace tiprub {

/// The schemes are two-step recurrences of modal coordinates and share one loop (TimeMarch). They differ in the
/// coefficients of the step and in the contact law.
enum class Scheme {
  trigonometric,        ///< exact in statics and, up to 2.4 rad a step, in free flight (Gautschi 1961); no step limit
  central_differences,  ///< the paper's eq. 13; holds for h omega_max < 2
  residual_flexibility,  ///< trigonometric for the lower modes; the others have no mass and follow their forces
                         ///< without delay
  moreau_jean,           ///< theta method, impulses on the velocities of closed nodes (Moreau 1988, Jean 1999)
  penalty,               ///< central differences; a penetrating node is pushed by a spring
};

enum class ContactRule {
  complementarity,  ///< 0 <= lambda perpendicular to g >= 0, in every step
  paper,            ///< eq. 14, eq. 15: every node that penetrates in the step without forces is closed once
};

/// How far the gap follows the displacements.
enum class GapOrder {
  automatic,     ///< of second order if the model has its terms, otherwise linear
  linear,        ///< n.u
  second_order,  ///< and the curvatures of the casing, its slope, and the shortening of blades that bend
};

/// Properties of a scheme, so that other code need not ask for a scheme by name.
struct SchemeTraits {
  bool has_memory;     ///< its contact law remembers more than the modes at two instants, which rules out orbits
  bool limits_step;    ///< stable for h < 2/omega_max only
  bool springs;        ///< a closed node stands on a spring, which raises omega_max
  bool quasi_static;   ///< also keeps modes without mass, which follow their forces without delay
  bool inner_impacts;  ///< finds the instants of impacts within steps, with complementarity
  bool jitters;        ///< a pressed node moves about by a percent or two of the motion, never twice the same
};

constexpr SchemeTraits traits_of(Scheme scheme) {
  switch (scheme) {
    case Scheme::trigonometric:
      return {false, false, false, false, true, false};
    case Scheme::central_differences:
      return {false, true, false, false, false, false};
    case Scheme::residual_flexibility:
      return {false, false, false, true, false, false};
    case Scheme::moreau_jean:
      return {true, false, false, false, false, true};
    case Scheme::penalty:
      return {true, true, true, false, false, false};
  }
  return {};
}

/// Whether the modes at two instants are the whole state of a march, so that a march is a map of such states. With
/// the paper's contact rule that map is not continuous.
constexpr bool maps_states(Scheme scheme, ContactRule rule) {
  return rule == ContactRule::complementarity && !traits_of(scheme).has_memory;
}

/// Whether an impact acts at its instant within a step. Elsewhere it acts at the end of the step, whatever its
/// instant, and Floquet multipliers lack how this instant moves with the motion.
constexpr bool finds_impacts(Scheme scheme, ContactRule rule) {
  return rule == ContactRule::complementarity && traits_of(scheme).inner_impacts;
}

/// The damping of one mode of a travelling wave, as a test on the wheel measures it.
struct ModeDamping {
  int nodal_diameter = 0, family = 0;  ///< family from 0
  double ratio = 0;                    ///< [1] of critical

  bool operator==(const ModeDamping&) const = default;
};

/// The modal damping of the march, as ratios of critical [1].
struct DampingRatios {
  /// The ratio of the first family, of the second, and so on; the last one holds for all further families.
  std::vector<double> by_family = {};
  /// [Hz, 1] ascending in frequency, for all families; linear between the points, constant outside. Empty: by family.
  std::vector<std::array<double, 2>> by_frequency = {};
  std::vector<ModeDamping> by_mode = {};  ///< of single modes, instead of the above
  double beyond = 0;                      ///< ratio of modes above the resolved frequency

  bool operator==(const DampingRatios&) const = default;
};

/// The speed for which the case gives its clearance.
enum class ClearanceState {
  cold,      ///< at standstill; the static shift under spin closes it
  running,   ///< the clearance that remains, at every speed
  at_speed,  ///< the clearance that remains at one speed; at others the static shift opens or closes it
};

// Names as case files and response.h5 have them.
inline constexpr NamedValues<Scheme, 5> scheme_names = {{{Scheme::trigonometric, "trigonometric"},
                                                         {Scheme::central_differences, "central_differences"},
                                                         {Scheme::residual_flexibility, "residual_flexibility"},
                                                         {Scheme::moreau_jean, "moreau_jean"},
                                                         {Scheme::penalty, "penalty"}}};
inline constexpr NamedValues<ContactRule, 2> contact_rule_names = {
    {{ContactRule::complementarity, "complementarity"}, {ContactRule::paper, "paper"}}};
inline constexpr NamedValues<ClearanceState, 3> clearance_state_names = {
    {{ClearanceState::cold, "cold"}, {ClearanceState::running, "running"}, {ClearanceState::at_speed, "at_speed"}}};

}  // namespace tiprub
