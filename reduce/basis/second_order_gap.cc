// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/basis/second_order_gap.h"

#include <algorithm>
#include <numeric>

#include "reduce/basis/cyclic_modes.h"
#include "reduce/sector/contact_line.h"

namespace tiprub::reduce {

namespace {

constexpr int coordinates_a_blade = 4;
constexpr int modes_a_blade = 12;         // of which these are chosen
constexpr double shape_tolerance = 1e-5;  // residual of 1/omega^2
constexpr double least_share = 1e-3;  // of a mode in the compliance of the contact unknowns, over the largest one's
constexpr double least_angle = 0.5;   // sine, between a motion of the contact unknowns and those chosen before

/// The numbers of the modes that move the contact unknowns most, those with the largest compliance first. A mode that
/// looks like others at the tip would make V singular.
std::vector<Eigen::Index> chosen_modes(const Eigen::MatrixXd& motions, const Eigen::VectorXd& eigenvalues, int most) {
  const Eigen::VectorXd share = motions.colwise().squaredNorm().transpose().cwiseQuotient(eigenvalues);
  std::vector<Eigen::Index> order(static_cast<std::size_t>(share.size())), chosen;
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](auto a, auto b) { return share[a] > share[b]; });
  Eigen::MatrixXd basis(motions.rows(), 0);
  for (const Eigen::Index mode : order) {
    if (static_cast<int>(chosen.size()) == most || share[mode] < least_share * share[order.front()]) break;
    const Eigen::VectorXd motion = motions.col(mode).normalized();
    const Eigen::VectorXd rest = motion - basis * (basis.transpose() * motion);
    if (rest.norm() < least_angle) continue;
    chosen.push_back(mode);
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols<1>() = rest.normalized();
  }
  return chosen;
}

/// [kg^-1/2] By which each motion is divided, so that its largest displacement, of any unknown in any
/// direction, is 1.
Eigen::RowVectorXd largest_displacements(const Eigen::MatrixXd& motions) {
  Eigen::RowVectorXd largest(motions.cols());
  for (Eigen::Index mode = 0; mode < motions.cols(); ++mode) {
    Eigen::Index at = 0;
    motions.col(mode).cwiseAbs().maxCoeff(&at);
    largest[mode] = motions(at, mode);
  }
  return largest;
}

Eigen::MatrixX2d casing_curvature(const SectorMesh& mesh, const ContactUnknowns& contact) {
  const ContactLine& line = contact.line;
  Eigen::MatrixX2d curvature(line.size(), 2);
  curvature << line.normal.col(0).cwiseQuotient(line.position.col(0)),
      meridional_curvature(mesh, contact.nodes, line.normal);
  return curvature;
}

std::vector<Eigen::Matrix3Xd> on_nodes(const SectorMesh& mesh, const SectorDofs& dofs,
                                       const Eigen::MatrixXd& sector_vectors) {
  std::vector<Eigen::Matrix3Xd> fields;
  for (const auto& column : sector_vectors.colwise()) fields.push_back(cartesian_displacement(mesh, dofs, column));
  return fields;
}

}  // namespace

std::vector<Eigen::MatrixXd> second_order_displacement(const RotatingElasticity& elasticity, const SectorMesh& mesh,
                                                       const SectorDofs& dofs, const BendingShapes& bending) {
  std::vector<Eigen::MatrixXd> Q =
      elasticity.stiffness_change(on_nodes(mesh, dofs, bending.responses), on_nodes(mesh, dofs, bending.shapes));
  for (Eigen::MatrixXd& of_unknown : Q) of_unknown = -0.25 * (of_unknown + of_unknown.transpose()).eval();
  return Q;
}

SecondOrderGap second_order_gap(const SpinningSector& sector, const SectorFactor& at_rest,
                                const ContactUnknowns& contact) {
  const SectorMesh& mesh = sector.mesh();
  const SectorDofs& dofs = sector.dofs();
  const CyclicTransformation alone = CyclicTransformation::of_held_faces(dofs);
  const CyclicSolver solver(at_rest, alone);
  const int blades = contact.line.splitter_nodes > 0 ? 2 : 1;
  const CyclicModes modes =
      lowest_modes(solver, sector.mass(), ContactNodes::free,
                   std::min(modes_a_blade * blades, dofs.interior + dofs.boundary()), shape_tolerance);
  const Eigen::MatrixXd shapes = alone.expand(modes.shape).real();
  const Eigen::MatrixXd motions = dofs.contact_loads.transpose() * shapes;
  const std::vector<Eigen::Index> chosen = chosen_modes(motions, modes.eigenvalue, coordinates_a_blade * blades);
  const Eigen::MatrixXd forces = normal_forces(contact.line);
  const Eigen::MatrixXd phi = shapes(Eigen::all, chosen), t = motions(Eigen::all, chosen);
  const Eigen::MatrixXcd loads = alone.gather((dofs.contact_loads * forces).cast<std::complex<double>>());
  // The static response without that of the chosen modes, phi phi' f / omega^2.
  const Eigen::MatrixXd psi = alone.expand(solver.solve(loads, ContactNodes::free)).real() -
                              phi * modes.eigenvalue(chosen).asDiagonal().inverse() * (t.transpose() * forces);
  const Eigen::RowVectorXd scale = largest_displacements(t).cwiseInverse();
  const Eigen::MatrixXd scaled = t * scale.asDiagonal();
  return {casing_curvature(mesh, contact), scaled * (scaled.transpose() * scaled).inverse(),
          second_order_displacement(*sector.elasticity(), mesh, dofs, {phi * scale.asDiagonal(), psi})};
}

}  // namespace tiprub::reduce
