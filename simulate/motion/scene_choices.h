// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "cases/program/named_values.h"

namespace tiprub {

/// The schemes. All are two-step recurrences of modal coordinates and share one
/// loop (TimeMarch): they differ in the coefficients of the step and in the law that gives the contact force.
enum class Scheme {
  trigonometric,        ///< exact in statics and, up to 2.4 rad a step, in free flight (Gautschi 1961); no step limit
  central_differences,  ///< the paper's eq. 13; holds for h omega_max < 2
  residual_flexibility,  ///< trigonometric for the lower modes; the others follow their forces at once, without mass
  moreau_jean,           ///< theta method, impulses on the velocities of closed nodes (Moreau 1988, Jean 1999)
  penalty,               ///< central differences; a penetrating node is pushed by a spring
};

enum class ContactRule {
  complementarity,  ///< 0 <= lambda perpendicular to g >= 0, in every step
  paper,            ///< eq. 14, eq. 15: every node that the free step pushes through is closed once, as an equality
};

/// What follows from a scheme, for all who needn't know which one it is.
struct SchemeTraits {
  bool has_memory;    ///< its law of contact keeps more than the modes at two instants: no map of states, no orbit
  bool limits_step;   ///< holds for h < 2/omega_max
  bool springs;       ///< a closed node stands on a spring, which raises omega_max; the others hold it still, by W
  bool quasi_static;  ///< keeps the modes beyond those with mass, which follow their forces at once
};

constexpr SchemeTraits traits_of(Scheme scheme) {
  switch (scheme) {
    case Scheme::trigonometric:
      return {false, false, false, false};
    case Scheme::central_differences:
      return {false, true, false, false};
    case Scheme::residual_flexibility:
      return {false, false, false, true};
    case Scheme::moreau_jean:
      return {true, false, false, false};
    case Scheme::penalty:
      return {true, true, true, false};
  }
  return {};
}

/// Whether the state of a march is that of its modes at two instants, so that it can be looked at as a map of such
/// states. By the paper's rule of contact the motion is no continuous function of them.
constexpr bool maps_states(Scheme scheme, ContactRule rule) {
  return rule == ContactRule::complementarity && !traits_of(scheme).has_memory;
}

/// The modal damping that was marched; ratios of critical, [1].
struct DampingRatios {
  /// The first family's, the second's, ...; the last one holds for all further ones.
  std::vector<double> by_family = {};
  /// [Hz, 1] ascending; linear between the points, level outside; for modes of all families. Empty: by family.
  std::vector<std::array<double, 2>> by_frequency = {};
  double beyond = 0;  ///< of modes above the resolved frequency
};

/// For which speed the case gives its clearance.
enum class ClearanceState {
  cold,      ///< at standstill: the static shift under spin closes it
  running,   ///< what remains, at whatever speed
  at_speed,  ///< what remains at one speed: the static shift opens or closes it at others, as it would one casing's
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
