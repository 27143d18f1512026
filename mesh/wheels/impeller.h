// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "cases/program/case_file.h"
#include "mesh/curves/meridional_curve.h"
#include "mesh/curves/smooth_table.h"
#include "mesh/wheels/sector_plan.h"

namespace tiprub::mesh {

/// The inner border of a radial wheel's disc: the bore from the front face to the back face, then the back face out
/// to the exit.
struct BackFace {
  double front_z;       ///< of the front face [m]
  double bore_radius;   ///< [m]
  double exit_radius;   ///< [m]
  SmoothTable profile;  ///< z of the back face over the radius [m]
  double bore_end;      ///< station of the corner between bore and back face

  static constexpr int fewest_stations = 2;  ///< one on the bore and one on the back face

  MeridionalPoint foot(double station) const;
};

/// Reads `back_profile`. Raises InputError.
SmoothTable read_back_profile(CaseTable& table);

/// Reads `elements_along_bore`; those along the chord must be known. Raises InputError.
void read_bore_elements(CaseTable& table, SectorPlan& plan);

/// The angles of a blade along hub and tip. The angle beta lies between the blade and the meridional plane, positive
/// where the blade turns towards +theta on its way to the trailing edge.
struct BladeAngles {
  SmoothTable hub;  ///< beta over the fraction of the hub's length [rad]
  SmoothTable tip;  ///< beta over the fraction of the tip's length [rad]
  double tip_lean;  ///< theta of the tip's leading edge minus the hub's [rad]
};

/// The mid-thickness surface of a blade between two flow lines: theta along either is the integral of tan(beta)/r
/// over the length; between hub and tip z, r and theta are linear in the span.
class BladeSurface {
 public:
  BladeSurface(const MeridionalCurve& hub, const MeridionalCurve& tip, const BladeAngles& angles);

  MeridionalPoint point(double chord, double span) const;  ///< both 0..1
  double theta(double chord, double span) const;           ///< [rad], 0 at the hub's leading edge
  /// cos(beta) of the flow line at this span: thickness over it is the width along the circumference.
  double cos_angle(double chord, double span) const;

 private:
  MeridionalCurve hub_;
  MeridionalCurve tip_;
  BladeAngles angles_;
  RunningIntegral wrap_hub_;
  RunningIntegral wrap_tip_;
};

}  // namespace tiprub::mesh
