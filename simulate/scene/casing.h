// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "cases/program/case_file.h"
#include "reduce/model/reduced_model.h"
#include "simulate/scene/periodic_table.h"

namespace tiprub {

enum class CasingShape {
  cosine,  ///< amplitude * cos(lobes (theta - crest))
  bumps,   ///< `lobes` raised cosines of a given width, round between them
  table,   ///< points over one lobe
};

enum class ClearanceState {
  cold,      ///< at standstill: the static shift under spin closes it
  running,   ///< what remains, at whatever speed
  at_speed,  ///< what remains at one speed: the static shift opens or closes it at others, as it would one casing's
};

/// A rigid casing that stands still around the wheel. Its distortion is the same along the chord, counts inward, and
/// repeats every 2 pi / lobes: in the rotor's frame its fundamental frequency is N_l Omega (eq. 16). The gap of node
/// k of sector j is, positive when open,
///   g = clearance_k - ramp(t) distortion(theta_k + j alpha + Omega t) - n_k . u_jk,
/// and the casing pushes along -n_k.
struct Casing {
  CasingShape shape = CasingShape::cosine;
  int lobes = 1;                  ///< N_l: the casing repeats every 2 pi / N_l
  double amplitude = 0.0;         ///< [m] inward, at the crest; of a table, its largest absolute value
  double crest_angle = 0.0;       ///< [rad] where the first crest (or the table's angle 0) sits
  double bump_width = 0.0;        ///< [rad] from foot to foot
  PeriodicTable table;            ///< [rad] -> [m], over one lobe
  double ramp_revolutions = 1.0;  ///< the distortion grows from zero over so many revolutions
  ClearanceState clearance_state = ClearanceState::running;
  double clearance_speed = 0;                    ///< [rad/s] at which a clearance of the state at_speed is given
  std::vector<std::array<double, 2>> clearance;  ///< [fraction of the arc length, m]; linear between, level outside

  /// [m] inward, fully grown, at an absolute angle in rad.
  double distortion(double angle) const;
  /// Factor of the distortion after so many revolutions: 0 .. 1, twice continuously differentiable.
  double ramp(double revolutions) const;
  /// [m] as the case gives it, at the contact nodes.
  Eigen::VectorXd given_clearance(const ContactLine& contact) const;
  /// [m] what is left at a speed in rad/s: the given one, unless it is a running one, less what normal . static shift
  /// has grown by since the speed at which it was given: standstill if cold.
  Eigen::VectorXd running_clearance(const ContactLine& contact, double speed) const;
};

/// Reads [casing]. Raises InputError.
Casing read_casing(CaseTable& table);

/// Refuses an amplitude or a clearance of more than a tenth of the tip's radius: no casing has that, and millimetres
/// that are taken for metres have. Raises InputError at the key.
void require_lengths_in_metres(const CaseTable& table, const Casing& casing, const ContactLine& contact);

}  // namespace tiprub
