// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "cases/program/case_file.h"
#include "reduce/model/reduced_model.h"
#include "simulate/motion/scene_choices.h"
#include "simulate/scene/casing_profile.h"
#include "simulate/scene/periodic_table.h"

namespace tiprub {

struct SimulateParameters;

enum class CasingShape {
  cosine,   ///< amplitude * cos(lobes (theta - crest))
  bumps,    ///< `lobes` raised cosines of a given width, round between them
  table,    ///< points over one lobe
  profile,  ///< points over one lobe and over the chord
};

/// A rigid casing that stands still around the wheel. Its distortion counts inward, is the same along the chord
/// unless it is a profile, and repeats every 2 pi / lobes: in the rotor's frame its fundamental frequency is N_l
/// Omega (eq. 16). The gap of node k of sector j is, positive when open,
///   g = clearance_k - ramp(t) distortion(theta_k + j alpha + Omega t, s_k) - n_k . u_jk,
/// with the node's fraction s_k of the arc length, and the casing pushes along -n_k.
struct Casing {
  CasingShape shape = CasingShape::cosine;
  int lobes = 1;                  ///< N_l: the casing repeats every 2 pi / N_l
  double amplitude = 0.0;         ///< [m] inward, at the crest; of points, their largest absolute value
  double crest_angle = 0.0;       ///< [rad] where the first crest (or the table's angle 0) sits
  double bump_width = 0.0;        ///< [rad] from foot to foot
  PeriodicTable table;            ///< [rad] -> [m], over one lobe
  CasingProfile profile;          ///< the same over the chord
  double ramp_revolutions = 1.0;  ///< the distortion grows from zero over so many revolutions
  ClearanceState clearance_state = ClearanceState::running;
  double clearance_speed = 0;  ///< [rad/s] at which a clearance of the state at_speed is given
  /// [fraction of the arc length, m] of the tightest blade; linear between, level outside.
  std::vector<std::array<double, 2>> clearance;
  std::vector<double> blade_clearance;  ///< [m] more than that, at least 0, of each sector's blade; empty: alike

  /// [m] inward, fully grown, at an absolute angle in rad and a fraction of the contact line's arc length.
  double distortion(double angle, double fraction) const;
  /// Factor of the distortion after so many revolutions: 0 .. 1, twice continuously differentiable.
  double ramp(double revolutions) const;
  /// [m] more clearance than the tightest blade's, of sector j's.
  double extra_clearance(int sector) const { return blade_clearance.empty() ? 0.0 : blade_clearance[sector]; }
  /// [m] as the case gives it, at the contact nodes of the tightest blade.
  Eigen::VectorXd given_clearance(const ContactLine& contact) const;
  /// [m] what is left at a speed in rad/s: the given one, unless it is a running one, less what normal . static shift
  /// has grown by since the speed at which it was given: standstill if cold.
  Eigen::VectorXd running_clearance(const ContactLine& contact, double speed) const;
};

/// [1] where the contact nodes stand on the contact line: 0 at the main blade's leading edge, 1 at its trailing edge,
/// by arc length; a splitter's likewise, for it turns below the same casing.
Eigen::VectorXd arc_fractions(const ContactLine& contact);

/// Reads [casing]. Raises InputError.
Casing read_casing(CaseTable& table);

/// Blades that differ leave no symmetry: there must be one clearance for each of the wheel's, all nodal diameters
/// must be marched, and orbits that travel with the casing aren't there. Raises InputError at the key.
void require_blades_of_wheel(const CaseTable& table, const Casing& casing, const SimulateParameters& parameters,
                             int sector_count);

/// Refuses an amplitude or a clearance of more than a tenth of the tip's radius: no casing has that, and millimetres
/// that are taken for metres have. Raises InputError at the key.
void require_lengths_in_metres(const CaseTable& table, const Casing& casing, const ContactLine& contact);

}  // namespace tiprub
