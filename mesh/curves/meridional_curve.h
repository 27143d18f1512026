// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace tiprub::mesh {

/// F(x), the integral of a smooth f from 0 to x in [0, 1], by five-point Gauss quadrature on 64 equal panels: exact
/// to round-off for the curves of a blade. Whole panels are summed once, so that a call costs one panel.
class RunningIntegral {
 public:
  explicit RunningIntegral(std::function<double(double)> integrand);

  double at(double x) const;
  double total() const { return sums_.back(); }
  /// The x with F(x) = value, for a positive f.
  double inverse(double value) const;

 private:
  double piece(double from, double to) const;

  std::function<double(double)> integrand_;
  std::vector<double> sums_;  ///< F at the ends of the panels
};

/// A point of the meridional plane, or a vector in it.
struct MeridionalPoint {
  double z;  ///< along the axis of rotation [m]
  double r;  ///< distance from it [m]
};

MeridionalPoint operator+(MeridionalPoint a, MeridionalPoint b);
MeridionalPoint operator-(MeridionalPoint a, MeridionalPoint b);
MeridionalPoint operator*(double factor, MeridionalPoint a);
double length_of(MeridionalPoint a);                    ///< [m] of a vector
double distance(MeridionalPoint a, MeridionalPoint b);  ///< [m]

/// A flow line from inlet to exit of a centrifugal wheel: a cubic Bezier curve that leaves the inlet along the axis
/// and reaches the exit along the radius, measured by the fraction of its own length.
class MeridionalCurve {
 public:
  /// The arms are the lengths of the curve's two handles, at the inlet as a fraction of the axial length, at the exit
  /// as a fraction of the radial height; two arms of 0.5523 make a quarter of an ellipse to 3e-4.
  MeridionalCurve(MeridionalPoint inlet, MeridionalPoint exit, std::array<double, 2> arms);

  double length() const { return arc_.total(); }        ///< [m]
  MeridionalPoint at(double fraction) const;            ///< fraction of the length, 0 at the inlet
  MeridionalPoint unit_tangent(double fraction) const;  ///< towards the exit

 private:
  std::array<MeridionalPoint, 4> control_;
  RunningIntegral arc_;
};

}  // namespace tiprub::mesh
