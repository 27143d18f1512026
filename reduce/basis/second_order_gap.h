// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/model/reduced_model.h"
#include "reduce/operators/sector_factor.h"
#include "reduce/operators/spinning_sector.h"
#include "reduce/sector/contact_unknowns.h"

namespace tiprub::reduce {

/// The shapes in which a body moves, and those that the second order of this motion needs; sector dofs.
struct BendingShapes {
  Eigen::MatrixXd shapes;     ///< phi of the coordinates y; sector x p
  Eigen::MatrixXd responses;  ///< [m/N] psi: response to a unit force along each normal; sector x n_c
};

/// [1/m] The symmetric matrices Q_k, p x p: y' Q_k y is the displacement of contact unknown k along its normal that
/// follows from the motion phi y in second order (reduce/theory.md, section 6; static modal derivatives, Idelsohn and
/// Cardona 1985). With the derivative K'[psi] of the tangent stiffness along psi,
///     Q_k,ab = -1/2 phi_a' K'[psi_k] phi_b.
std::vector<Eigen::MatrixXd> second_order_displacement(const RotatingElasticity& elasticity, const SectorMesh& mesh,
                                                       const SectorDofs& dofs, const BendingShapes& bending);

/// The second order of the gaps of a sector of finite elements whose two cut faces are held, with the modes at rest
/// and the static responses psi that section 6 of reduce/theory.md chooses: each blade has its own coordinates,
/// whatever the nodal diameter. Costs some twenty modes, by the factor of K at rest. The sector must still have its
/// elasticity.
SecondOrderGap second_order_gap(const SpinningSector& sector, const SectorFactor& at_rest,
                                const ContactUnknowns& contact);

}  // namespace tiprub::reduce
