// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/model/reduced_model.h"
#include "reduce/operators/sector_factor.h"
#include "reduce/sector/contact_unknowns.h"
#include "reduce/sector/reduction_parameters.h"
#include "reduce/sector/rotating_elasticity.h"

namespace tiprub::reduce {

/// Shapes in which a body moves, with all that the second order of their motion needs; sector dofs.
struct BendingShapes {
  Eigen::MatrixXd shapes;     ///< phi, of the coordinates y; sector x p
  Eigen::MatrixXd responses;  ///< [m/N] psi, to a unit force along the normal of each contact unknown; sector x n_c
};

/// [1/m] Q_k with y' Q_k y the displacement along the normal of contact unknown k that follows from the motion
/// phi y. With large displacements the internal force of this motion has the second-order part K'[phi y] phi y / 2,
/// and the body answers it statically. By reciprocity, and because K' is symmetric in all directions,
///     Q_k,ab = -1/2 phi_a' K'[psi_k] phi_b
/// (static modal derivatives; Idelsohn and Cardona 1985).
std::vector<Eigen::MatrixXd> second_order_displacement(const RotatingElasticity& elasticity, const SectorMesh& mesh,
                                                       const SectorDofs& dofs, const BendingShapes& bending);

/// The second order of the gaps of a sector with finite elements, with both cut faces held: a wave of the wheel moves
/// each blade by its own coordinates, whatever the nodal diameter.
///
/// The shapes phi are the modes at rest that move the contact unknowns most, four a blade with contact, as far as
/// their motions t = B' phi of the contact unknowns differ; V = t (t't)^-1 finds them in the motion u. psi is the
/// static response of all other modes: the quadratic forces on the modes phi themselves are those that linear
/// dynamics leave out, and they would answer them by their own resonance, not statically.
///
/// Costs a factorization of the sector's K and some twenty modes.
SecondOrderGap second_order_gap(const SectorMesh& mesh, const ContactUnknowns& contact,
                                const ReductionParameters& parameters, const FactorChoice& choice = {});

}  // namespace tiprub::reduce
