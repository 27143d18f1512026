// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/curves/blade_surface.h"

#include <cmath>

namespace tiprub {

namespace {

// d theta / d fraction = length tan(beta) / r
double wrap_rate(const MeridionalCurve& curve, const SmoothTable& angle, double fraction) {
  return curve.length() * std::tan(angle.at(fraction)) / curve.at(fraction).r;
}

RunningIntegral wrap(const MeridionalCurve& curve, const SmoothTable& angle) {
  return RunningIntegral([curve, angle](double fraction) { return wrap_rate(curve, angle, fraction); });
}

}  // namespace

BladeSurface::BladeSurface(const MeridionalCurve& hub, const MeridionalCurve& tip, const BladeAngles& angles)
    : hub_(hub), tip_(tip), angles_(angles), wrap_hub_(wrap(hub, angles.hub)), wrap_tip_(wrap(tip, angles.tip)) {}

MeridionalPoint BladeSurface::point(double chord, double span) const {
  return (1.0 - span) * hub_.at(chord) + span * tip_.at(chord);
}

double BladeSurface::theta(double chord, double span) const {
  return (1.0 - span) * wrap_hub_.at(chord) + span * (wrap_tip_.at(chord) + angles_.tip_lean);
}

double BladeSurface::cos_angle(double chord, double span) const {
  const double theta_rate =
      (1.0 - span) * wrap_rate(hub_, angles_.hub, chord) + span * wrap_rate(tip_, angles_.tip, chord);
  const MeridionalPoint along =
      (1.0 - span) * hub_.length() * hub_.unit_tangent(chord) + span * tip_.length() * tip_.unit_tangent(chord);
  const double meridional_rate = std::hypot(along.z, along.r);
  return meridional_rate / std::hypot(meridional_rate, point(chord, span).r * theta_rate);
}

}  // namespace tiprub
