// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/curves/meridional_curve.h"
#include "mesh/curves/smooth_table.h"

namespace tiprub {

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

}  // namespace tiprub
