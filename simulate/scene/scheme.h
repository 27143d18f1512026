// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tiprub {

/// The schemes; one file each in march/integrators. All are two-step recurrences of modal coordinates and share one
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

}  // namespace tiprub
