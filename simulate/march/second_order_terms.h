// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "reduce/model/reduced_model.h"
#include "simulate/scene/casing.h"

namespace tiprub::simulate {

/// The terms s by which gaps are narrower than with the displacement along the normal alone, to second order in the
/// coordinates y = V^T u of the blades of a sector. For contact node k at the radius r_k,
///   s_k = y^T Q_k y + (c_1 u_theta^2 + c_2 u_m^2)/2 + d' beta + d'' beta^2/2,   beta = u_theta/r_k,
/// with the shortening of the bent blade (Q_k) and the curvatures of the casing (c_1, c_2), both from SecondOrderGap,
/// and with the distortion d of the casing, which is read where the tip is. The displacements follow from y as u = V
/// (V^T V)^-1 y.
///
/// The contact force acts along the gradient of the gap, -lambda (nu + ds/du), so that contact does no work but that
/// of the gap. Terms of third order are left out, and so are products of the slope of the distortion and u_r u_theta.
class SecondOrderTerms {
 public:
  /// Requires tips with SecondOrderGap. `width` is the number of values per sector in vectors over contact nodes, a
  /// multiple of four.
  SecondOrderTerms(const ContactLine& tips, const Obstacle& obstacle, int steps_per_revolution, std::size_t width);

  /// The number p of coordinates in a sector.
  std::size_t coordinates() const { return coordinates_; }
  /// The part of the casing that faces a sector: the step within a lobe, and the factor 0 .. 1 by which the
  /// distortion has grown.
  struct Place {
    std::int64_t phase;
    double grown;
  };
  /// Subtracts s [m] from the gaps of a sector whose coordinates are y [m]. Returns whether any gap is negative
  /// afterwards.
  bool narrow(const double* y, const Place& place, double* gap) const;
  /// [1] The slopes ds/dy: for each coordinate a column over the nodes of the sector; columns are `stride` values
  /// apart.
  void slopes(const double* y, const Place& place, double* columns, std::size_t stride) const;

 private:
  std::size_t coordinates_, width_;
  std::vector<double> doubled_;  ///< [1/m] d^2 s/dy_a dy_b without the terms of d; for each pair a, b, over the nodes
  std::vector<double> turns_;    ///< [1/m] d beta/dy_a; for each coordinate, over the nodes
  std::vector<double> tilt_;     ///< [m] for each phase d' over the nodes, then d''
};

}  // namespace tiprub::simulate
