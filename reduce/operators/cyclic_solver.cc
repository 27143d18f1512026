// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/cyclic_solver.h"

#include <algorithm>
#include <cassert>
#include <complex>
#include <utility>

#include "cases/program/errors.h"

/// LAPACK's Cholesky factorization, part of OpenBLAS: Eigen's own takes three times as long for complex numbers.
extern "C" void zpotrf_(const char* uplo, const int* size, std::complex<double>* matrix, const int* rows, int* info);

namespace tiprub::reduce {

namespace {

// Columns of one solve: enough to share the cost of a pass through the factor, and few enough to take little memory.
constexpr Eigen::Index columns_at_once = 16;

/// Real and imaginary parts side by side: real operators then work on one real matrix. A standing wave has no
/// imaginary part, and half the work.
Eigen::MatrixXd split(const Eigen::MatrixXcd& matrix, bool standing) {
  if (standing) {
    assert(matrix.imag().isZero(0.0));
    return matrix.real();
  }
  Eigen::MatrixXd parts(matrix.rows(), 2 * matrix.cols());
  parts << matrix.real(), matrix.imag();
  return parts;
}

Eigen::MatrixXcd join(const Eigen::MatrixXd& parts, bool standing) {
  if (standing) return parts.cast<std::complex<double>>();
  const Eigen::Index columns = parts.cols() / 2;
  Eigen::MatrixXcd matrix(parts.rows(), columns);
  matrix.real() = parts.leftCols(columns);
  matrix.imag() = parts.rightCols(columns);
  return matrix;
}

}  // namespace

CyclicSolver::CyclicSolver(const SectorFactor& factor, const CyclicTransformation& transform)
    : factor_(factor), transform_(transform) {
  const auto& S = factor.schur_complement().values();
  const Eigen::Index face = transform_.dofs().face, boundary = transform_.dofs().boundary(), moving = moving_face();
  const std::complex<double> phase = transform_.phase();
  // eq. 6 on the interface: the lower triangle of T^H S T, Hermitian. Both faces on themselves, then one on the
  // other.
  cholesky_.resize(moving + boundary, moving + boundary);
  for (Eigen::Index column = 0; column < moving; ++column) {
    const Eigen::Index below = face - column;
    const auto low = S.col(column), high = S.col(face + column);
    cholesky_.col(column).segment(column, below) = (low.segment(column, below) + high.segment(face + column, below)) +
                                                   phase * high.segment(column, below) +
                                                   std::conj(phase) * low.segment(face + column, below);
    cholesky_.col(column).tail(boundary) = low.tail(boundary) + phase * high.tail(boundary);
  }
  for (Eigen::Index k = 0; k < boundary; ++k)
    cholesky_.col(moving + k).tail(boundary) = S.col(2 * face + k).tail(boundary).cast<std::complex<double>>();
  const int size = static_cast<int>(cholesky_.rows());
  int info = 0;
  if (size > 0) zpotrf_("L", &size, cholesky_.data(), &size, &info);
  if (info != 0) throw RunError("the stiffness of a nodal diameter is not positive definite: the rotor is unstable");
  if (transform_.dofs().contact_dofs() > boundary) find_segment_modes();
}

void CyclicSolver::find_segment_modes() {
  const SectorDofs& dofs = transform_.dofs();
  // B is on interior dofs only, which come first among the sector's and the independent ones.
  const Eigen::MatrixXd loads = dofs.contact_loads.topRows(dofs.independent());
  segment_modes_ = solve(loads.cast<std::complex<double>>(), ContactNodes::free);
  const Eigen::MatrixXcd flexibility = segment_displacements(segment_modes_);
  const Eigen::MatrixXcd stiffness = flexibility.llt().solve(Eigen::MatrixXcd::Identity(loads.cols(), loads.cols()));
  segment_modes_ *= stiffness;
}

/// B' x
Eigen::MatrixXcd CyclicSolver::segment_displacements(const Eigen::MatrixXcd& shapes) const {
  return transform_.dofs().contact_loads.topRows(shapes.rows()).transpose() * shapes;
}

Eigen::MatrixXcd CyclicSolver::solve(const Eigen::MatrixXcd& load, ContactNodes contact) const {
  Eigen::MatrixXcd result(load.rows(), load.cols());
  for (Eigen::Index first = 0; first < load.cols(); first += columns_at_once) {
    const Eigen::Index count = std::min(columns_at_once, load.cols() - first);
    result.middleCols(first, count) = solve_block(load.middleCols(first, count), contact);
  }
  if (contact == ContactNodes::fixed && segment_modes_.cols() > 0)
    result -= segment_modes_ * segment_displacements(result);
  return result;
}

Eigen::MatrixXcd CyclicSolver::solve_block(const Eigen::MatrixXcd& load, ContactNodes contact) const {
  const SectorDofs& dofs = transform_.dofs();
  const Eigen::Index held = dofs.face - moving_face();
  const Eigen::Index kept = moving_face() + (contact == ContactNodes::free ? dofs.boundary() : 0);
  Eliminated eliminated = factor_.engine().eliminate(split(load.topRows(dofs.interior), transform_.is_real()));
  Eigen::MatrixXcd interface = load.bottomRows(dofs.face + dofs.boundary()) +
                               transform_.gather_interface(join(eliminated.interface_load, transform_.is_real()));
  const auto lower = cholesky_.topLeftCorner(kept, kept).triangularView<Eigen::Lower>();
  interface.topRows(held).setZero();
  interface.bottomRows(interface.rows() - held - kept).setZero();
  auto solved = interface.middleRows(held, kept);
  if (kept > 0) lower.solveInPlace(solved);
  if (kept > 0) lower.adjoint().solveInPlace(solved);
  Eigen::MatrixXcd result(dofs.independent(), load.cols());
  const Eigen::MatrixXd moved = factor_.engine().back_substitute(
      std::move(eliminated), split(transform_.expand_interface(interface), transform_.is_real()));
  result << join(moved.topRows(dofs.interior), transform_.is_real()), interface;
  return result;
}

// eq. 8: Psi_s = -K_ii^-1 K_ib with i all but the contact dofs.
Eigen::MatrixXcd CyclicSolver::constraint_modes() const {
  if (segment_modes_.cols() > 0) return segment_modes_;
  const SectorDofs& dofs = transform_.dofs();
  const Eigen::Index face = dofs.face, boundary = dofs.boundary();
  Eigen::MatrixXcd interface = Eigen::MatrixXcd::Zero(face + boundary, boundary);
  interface.bottomRows(boundary).setIdentity();
  // L = [L_c 0; L_bc L_b]: S_cb = L_c L_bc^H, so x_c = -S_cc^-1 S_cb = -L_c^-H L_bc^H.
  interface.topRows(face) = -cholesky_.block(face, 0, boundary, face).adjoint();
  auto solved = interface.topRows(face);
  cholesky_.topLeftCorner(face, face).triangularView<Eigen::Lower>().adjoint().solveInPlace(solved);
  const Eigen::MatrixXd imposed = split(transform_.expand_interface(interface), transform_.is_real());
  const Eigen::MatrixXd moved = factor_.engine().back_substitute(factor_.engine().unloaded(imposed.cols()), imposed);
  Eigen::MatrixXcd result(dofs.independent(), boundary);
  result << join(moved.topRows(dofs.interior), transform_.is_real()), interface;
  return result;
}

}  // namespace tiprub::reduce
