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
/// follows from the motion phi y in second order. With large displacements the internal force of this motion has the
/// part K'[phi y] phi y/2 of second order, where K'[psi] is the derivative of the tangent stiffness along psi, and
/// the body responds to it statically. By reciprocity, and because K' is symmetric in its three directions,
///     Q_k,ab = -1/2 phi_a' K'[psi_k] phi_b
/// (static modal derivatives; Idelsohn and Cardona 1985).
std::vector<Eigen::MatrixXd> second_order_displacement(const RotatingElasticity& elasticity, const SectorMesh& mesh,
                                                       const SectorDofs& dofs, const BendingShapes& bending);

/// The second order of the gaps of a sector of finite elements whose two cut faces are held: a quadratic term of the
/// nodal diameters n_1 and n_2 acts at n_1 + n_2, so that each blade has its own coordinates, whatever the nodal
/// diameter.
///
/// The shapes phi are modes at rest, four for each blade with contact: those that contribute most to the compliance
/// of the contact unknowns, as long as their motions t = B' phi of the contact unknowns differ. V = t (t't)^-1 gives
/// their coordinates in a motion u. psi is the static response of all other modes. The modes phi are left out of it,
/// because they would respond to quadratic forces by their own resonance, not statically; linear dynamics leave these
/// forces out.
///
/// Terms of third order and the effect of spin on modes and Q are left out (see reduce/theory.md for their size).
/// Costs some twenty modes, by the factor of K at rest. The sector must still have its elasticity.
SecondOrderGap second_order_gap(const SpinningSector& sector, const SectorFactor& at_rest,
                                const ContactUnknowns& contact);

}  // namespace tiprub::reduce
