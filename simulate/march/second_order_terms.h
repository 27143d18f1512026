// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "reduce/model/reduced_model.h"
#include "simulate/scene/obstacle.h"

namespace tiprub::simulate {

/// What narrows the gaps beside n.u, to second order in the coordinates y = V'u of a sector's blades. For node k,
///   s_k = y' Q_k y + (c_1 u_theta^2 + c_2 u_m^2)/2 + d' delta + d'' delta^2/2,   delta = u_theta/r,
/// with the bending of the blade and the curvatures of the casing (SecondOrderGap), and with the distortion d of the
/// casing read where the tip is. The displacements u are those that y tells, V (V'V)^-1 y.
///
/// A gap that is a function of the modes gives the force its direction, -lambda (n + ds/du), so that contact does no
/// work but that of its gap.
class SecondOrderTerms {
 public:
  /// The tips must hold SecondOrderGap. `width`: values a sector in vectors of contact nodes, whole vectors of four.
  SecondOrderTerms(const ContactLine& tips, const Obstacle& obstacle, int steps_per_revolution, std::size_t width);

  /// p, the coordinates of a sector.
  std::size_t coordinates() const { return coordinates_; }
  /// The place of the casing over a sector: the step within a lobe, and the factor by which the distortion has grown.
  struct Place {
    std::int64_t phase;
    double grown;
  };
  /// Takes s [m] of a sector with the coordinates y [m] from its gaps. Returns whether any gap is negative then.
  bool narrow(const double* y, const Place& place, double* gap) const;
  /// [1] ds/dy: for each coordinate a column over the nodes of the sector, the next one `stride` values later.
  void slopes(const double* y, const Place& place, double* columns, std::size_t stride) const;

 private:
  std::size_t coordinates_, width_;
  std::vector<double> doubled_;  ///< [1/m] d2s/dy2 without the casing's: for each pair a, b over the nodes
  std::vector<double> turns_;    ///< [1/m] delta over y, for each coordinate over the nodes
  std::vector<double> tilt_;     ///< [m] d' of each phase over the nodes, then d''
};

}  // namespace tiprub::simulate
