// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "reduce/cyclic_symmetry.h"

namespace tiprub {

/// What one speed gives to the basis of one nodal diameter (eq. 8).
struct SpeedShapes {
  Eigen::MatrixXcd constraint_modes;       ///< Psi_s, unit rows at the contact dofs; independent x contact dofs
  Eigen::MatrixXcd fixed_interface_modes;  ///< contact nodes held; independent x modes
};

/// One basis for all speeds (eq. 9): the constraint modes at rest, kept as they are so that contact dofs stay
/// physical, and an M-orthonormal set made from everything else, the fixed-interface modes of every speed and the
/// changes of the constraint modes with speed. Without those changes a thin blade that has turned under load is far
/// off. Directions are dropped by their stiffness norm, never by mass: light directions are the stiff ones.
struct CraigBamptonBasis {
  Eigen::MatrixXcd
      shapes;       ///< independent dofs x (contact dofs, then generalized dofs by ascending frequency at rest)
  int dropped = 0;  ///< directions that the others already hold
};

/// `speeds.front()` is rest; `stiffness` and `mass` are the sector's at rest.
CraigBamptonBasis merge_speeds(const TravellingWave& wave, const std::vector<SpeedShapes>& speeds,
                               const SymmetricMatrix& stiffness, const SymmetricMatrix& mass);

/// T^H Y T for a sector matrix and a basis; Hermitian, and real for a standing wave.
Eigen::MatrixXcd project(const TravellingWave& wave, const SymmetricMatrix& matrix, const Eigen::MatrixXcd& basis);

}  // namespace tiprub
