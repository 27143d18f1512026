// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cases/program/case_file.h"
#include "reduce/model/reduced_model.h"
#include "simulate/motion/scene_choices.h"
#include "simulate/scene/casing_profile.h"

namespace tiprub::simulate {

struct SimulateParameters;

enum class CasingShape {
  cosine,   ///< amplitude * cos(lobes (theta - crest))
  bumps,    ///< `lobes` raised cosines of a given width, with a circular casing between them
  table,    ///< points over one lobe
  profile,  ///< points over one lobe and over the chord
};

/// A rigid casing that stands still around the wheel. Its distortion is positive inward, is the same along the chord
/// unless it is a profile, and repeats every 2 pi / lobes: in the frame of the rotor its fundamental frequency is N_l
/// Omega (eq. 16). The gap of node k of sector j, positive when open, is
///   g = clearance_k - ramp(t) distortion(theta_k + j alpha + Omega t, s_k) - nu_k . u_jk,
/// where s_k is the fraction of the arc length at the node and nu_k the normal. The casing pushes along -nu_k.
struct Casing {
  CasingShape shape = CasingShape::cosine;
  int lobes = 1;                         ///< N_l: the casing repeats every 2 pi / N_l
  double amplitude = 0.0;                ///< [m] inward, at the crest; for points the largest absolute value
  std::optional<std::size_t> crest_row;  ///< of the table that has it
  double crest_angle = 0.0;              ///< [rad] absolute angle of the first crest, or of the table's angle 0
  double bump_width = 0.0;               ///< [rad] from foot to foot
  PeriodicTable table;                   ///< [rad] -> [m], over one lobe
  CasingProfile profile;                 ///< the same, over the chord as well
  std::string profile_file;              ///< that holds it
  double ramp_revolutions = 1.0;         ///< the distortion grows from zero over this many revolutions
  ClearanceState clearance_state = ClearanceState::running;
  double clearance_speed = 0;  ///< [rad/s] the speed of the state at_speed
  /// [fraction of the arc length, m] clearance of the tightest blade; linear between the points, constant outside.
  std::vector<std::array<double, 2>> clearance;
  bool unusual = false;                 ///< lengths and angles that are usual for no casing are meant
  std::vector<double> blade_clearance;  ///< [m] extra clearance of each blade, at least 0; empty: none
  /// [fraction of the arc length, 1] mu of Coulomb's law at the tips; linear between the points, constant outside.
  std::vector<std::array<double, 2>> friction = {{0.0, 0.0}};

  /// [m] inward, fully grown, at an absolute angle in rad and a fraction of the contact line's arc length.
  double distortion(double angle, double fraction) const;
  /// [m] The largest distortion inward that each contact node meets in a turn.
  Eigen::VectorXd crests(const ContactLine& contact) const;
  /// Factor of the distortion after so many revolutions: 0 .. 1, twice continuously differentiable.
  double ramp(double revolutions) const;
  /// Whole revolutions after which the distortion is fully grown.
  std::int64_t grown_after() const { return static_cast<std::int64_t>(std::ceil(ramp_revolutions)); }
  /// [m] clearance of the blade of a sector beyond that of the tightest blade.
  double extra_clearance(int sector) const { return blade_clearance.empty() ? 0.0 : blade_clearance[sector]; }
  /// [1] mu at the contact nodes of a blade.
  Eigen::VectorXd friction_at(const ContactLine& contact) const;
  /// Whether tips have friction anywhere.
  bool has_friction() const;
  /// "0.1", or "0.05 .. 0.15 over the chord".
  std::string friction_text() const;
  /// [m] clearance as the case gives it, at the contact nodes of the tightest blade.
  Eigen::VectorXd given_clearance(const ContactLine& contact) const;
  /// [m] clearance that is left at a speed in rad/s. A running clearance is the same at every speed. The others
  /// are given at one speed (standstill if cold) and are reduced by the growth of normal . static shift from there
  /// to this speed.
  Eigen::VectorXd running_clearance(const ContactLine& contact, double speed) const;
};

/// [1] The place of the contact nodes on the contact line by arc length: 0 at the leading edge of the main blade, 1
/// at its trailing edge. A splitter uses the same scale, because it turns under the same casing.
Eigen::VectorXd arc_fractions(const ContactLine& contact);

/// What the tips meet at one speed: the casing in the frame of the tips. It is rigid and stands still around the
/// wheel, so that its gap depends only on the place of a tip and on time. A flexible obstacle would add its
/// compliance to that of the tips.
class Obstacle {
 public:
  /// `clearance` [m] is that of the tightest blade at this speed, tip by tip.
  Obstacle(const Casing& casing, const ContactLine& tips, Eigen::VectorXd clearance)
      : casing_(casing),
        angle_(tips.position.col(1)),
        fraction_(arc_fractions(tips)),
        clearance_(std::move(clearance)) {}
  /// The same without lobes and clearance: gaps are then negative displacements.
  Obstacle touching() const {
    Obstacle level = *this;
    level.casing_.shape = CasingShape::cosine;
    level.casing_.amplitude = 0;
    level.clearance_.setZero();
    return level;
  }

  /// N_l; the obstacle repeats every 2 pi / N_l.
  int lobes() const { return casing_.lobes; }
  /// [m] The distance of the undistorted casing from the tips of the tightest blade, or from those of a sector.
  const Eigen::VectorXd& clearance() const { return clearance_; }
  Eigen::VectorXd clearance(int sector) const { return clearance_.array() + casing_.extra_clearance(sector); }
  /// [m] The full distortion inward over a tip of sector 0 after it has turned by an angle in rad.
  double distortion(int tip, double turn) const { return casing_.distortion(angle_[tip] + turn, fraction_[tip]); }
  /// The factor by which the distortion has grown after a number of revolutions.
  double grown(double revolutions) const { return casing_.ramp(revolutions); }

 private:
  Casing casing_;
  Eigen::VectorXd angle_;     ///< [rad] of the tips of sector 0
  Eigen::VectorXd fraction_;  ///< [1] of the tips' arc length
  Eigen::VectorXd clearance_;
};

/// Reads [casing]. Raises InputError.
Casing read_casing(CaseTable& table);

/// Blades that differ break the symmetry. The case must then give a clearance for each blade, march all nodal
/// diameters, and ask neither for orbits nor for branches, which require equal blades. Raises InputError at the
/// key otherwise.
void require_blades_of_wheel(const CaseTable& table, const Casing& casing, const SimulateParameters& parameters,
                             int sector_count);

/// Refuses a ramp that is longer than the march. Raises InputError at the key.
void require_ramp_within(const CaseTable& table, const Casing& casing, const SimulateParameters& parameters);

/// Refuses an amplitude or a clearance above a fiftieth of the tip radius, which is probably a length in millimetres,
/// or above a tenth where `unusual` says that it is meant. Raises InputError at the key.
void require_lengths_in_metres(const CaseTable& table, const Casing& casing, const ContactLine& contact);

}  // namespace tiprub::simulate
