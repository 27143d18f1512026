// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/cyclic_symmetry.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <complex>
#include <numbers>
#include <string>

#include "cases/errors.h"

namespace tiprub {

namespace {

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

constexpr int strip_width = 16;

/// One strip of right sides, row by row, `strip_width` of them: each entry of Y is read once, and the inner loops
/// have a fixed length. Compiled for what the processor has: the sum over a row is then the same on the same machine.
__attribute__((target_clones("avx512f", "avx2,fma", "default"))) void multiply_strip(
    int columns, const int* starts, const int* rows, const double* values, const double* right, double* product) {
  for (int column = 0; column < columns; ++column) {
    const double* x = right + static_cast<std::ptrdiff_t>(column) * strip_width;
    double sum[strip_width];
    const double diagonal = values[starts[column]];  // comes first
    for (int k = 0; k < strip_width; ++k) sum[k] = diagonal * x[k];
    for (int at = starts[column] + 1; at < starts[column + 1]; ++at) {
      const double value = values[at];
      const double* other = right + static_cast<std::ptrdiff_t>(rows[at]) * strip_width;
      double* into = product + static_cast<std::ptrdiff_t>(rows[at]) * strip_width;
      for (int k = 0; k < strip_width; ++k) {
        sum[k] += value * other[k];
        into[k] += value * x[k];
      }
    }
    double* into = product + static_cast<std::ptrdiff_t>(column) * strip_width;
    for (int k = 0; k < strip_width; ++k) into[k] += sum[k];
  }
}

/// Y X for a symmetric matrix of which the lower triangle is stored.
Eigen::MatrixXd multiply(const SymmetricMatrix& lower, const Eigen::MatrixXd& right) {
  using Strip = Eigen::Matrix<double, Eigen::Dynamic, strip_width, Eigen::RowMajor>;
  Eigen::MatrixXd product(right.rows(), right.cols());
  for (Eigen::Index first = 0; first < right.cols(); first += strip_width) {
    const Eigen::Index count = std::min<Eigen::Index>(strip_width, right.cols() - first);
    Strip x = Strip::Zero(right.rows(), strip_width), y = Strip::Zero(right.rows(), strip_width);
    x.leftCols(count) = right.middleCols(first, count);
    multiply_strip(static_cast<int>(lower.cols()), lower.outerIndexPtr(), lower.innerIndexPtr(), lower.valuePtr(),
                   x.data(), y.data());
    product.middleCols(first, count) = y.leftCols(count);
  }
  return product;
}

}  // namespace

TravellingWave::TravellingWave(const SectorDofs& dofs, int sector_count, int nodal_diameter) : dofs_(dofs) {
  // e^{i n alpha} is exactly real for n = 0 and n = N/2, and so are their matrices.
  const double angle = 2 * std::numbers::pi * nodal_diameter / sector_count;
  phase_ = nodal_diameter == 0 ? 1.0 : 2 * nodal_diameter == sector_count ? -1.0 : std::polar(1.0, angle);
}

Eigen::MatrixXcd TravellingWave::expand_interface(const Eigen::MatrixXcd& independent) const {
  Eigen::MatrixXcd sector(dofs_.interface(), independent.cols());
  sector << independent.topRows(dofs_.face), phase_ * independent.topRows(dofs_.face),
      independent.bottomRows(dofs_.boundary());
  return sector;
}

Eigen::MatrixXcd TravellingWave::gather_interface(const Eigen::MatrixXcd& sector) const {
  Eigen::MatrixXcd independent(dofs_.face + dofs_.boundary(), sector.cols());
  independent << sector.topRows(dofs_.face) + std::conj(phase_) * sector.middleRows(dofs_.face, dofs_.face),
      sector.bottomRows(dofs_.boundary());
  return independent;
}

Eigen::MatrixXcd TravellingWave::expand(const Eigen::MatrixXcd& independent) const {
  Eigen::MatrixXcd sector(dofs_.sector(), independent.cols());
  sector << independent.topRows(dofs_.interior),
      expand_interface(independent.bottomRows(dofs_.face + dofs_.boundary()));
  return sector;
}

Eigen::MatrixXcd TravellingWave::gather(const Eigen::MatrixXcd& sector) const {
  Eigen::MatrixXcd independent(dofs_.independent(), sector.cols());
  independent << sector.topRows(dofs_.interior), gather_interface(sector.bottomRows(dofs_.interface()));
  return independent;
}

Eigen::MatrixXcd TravellingWave::apply(const SymmetricMatrix& matrix, const Eigen::MatrixXcd& independent) const {
  const Eigen::MatrixXd moved = split(expand(independent), standing());
  return gather(join(multiply(matrix, moved), standing()));
}

CyclicStiffness::CyclicStiffness(const SectorFactor& factor, const TravellingWave& wave)
    : factor_(factor), wave_(wave) {
  const Eigen::MatrixXcd half = wave_.gather_interface(factor_.schur_complement().cast<std::complex<double>>());
  cholesky_ = wave_.gather_interface(half.adjoint());  // T^H S T, Hermitian
  Eigen::LLT<Eigen::Ref<Eigen::MatrixXcd>> factorized(cholesky_);
  if (factorized.info() != Eigen::Success)
    throw RunError("the stiffness of a nodal diameter is not positive definite: the rotor is unstable");
}

Eigen::MatrixXcd CyclicStiffness::solve(const Eigen::MatrixXcd& load, ContactNodes contact) const {
  const SectorDofs& dofs = wave_.dofs();
  const Eigen::Index kept = dofs.face + (contact == ContactNodes::free ? dofs.boundary() : 0);
  SectorFactor::Eliminated eliminated = factor_.eliminate(split(load.topRows(dofs.interior), wave_.standing()));
  Eigen::MatrixXcd interface = load.bottomRows(dofs.face + dofs.boundary()) +
                               wave_.gather_interface(join(eliminated.interface_load, wave_.standing()));
  const auto lower = cholesky_.topLeftCorner(kept, kept).triangularView<Eigen::Lower>();
  interface.bottomRows(interface.rows() - kept).setZero();
  auto solved = interface.topRows(kept);
  lower.solveInPlace(solved);
  lower.adjoint().solveInPlace(solved);
  Eigen::MatrixXcd result(dofs.independent(), load.cols());
  const Eigen::MatrixXd moved =
      factor_.back_substitute(std::move(eliminated), split(wave_.expand_interface(interface), wave_.standing()));
  result << join(moved.topRows(dofs.interior), wave_.standing()), interface;
  return result;
}

Eigen::MatrixXcd CyclicStiffness::constraint_modes() const {
  const SectorDofs& dofs = wave_.dofs();
  const Eigen::Index face = dofs.face, boundary = dofs.boundary();
  Eigen::MatrixXcd interface = Eigen::MatrixXcd::Zero(face + boundary, boundary);
  interface.bottomRows(boundary).setIdentity();
  // L = [L_c 0; L_bc L_b]: S_cb = L_c L_bc^H, so x_c = -S_cc^-1 S_cb = -L_c^-H L_bc^H.
  interface.topRows(face) = -cholesky_.block(face, 0, boundary, face).adjoint();
  auto solved = interface.topRows(face);
  cholesky_.topLeftCorner(face, face).triangularView<Eigen::Lower>().adjoint().solveInPlace(solved);
  SectorFactor::Eliminated nothing;
  nothing.state = Eigen::MatrixXd::Zero(dofs.sector(), (wave_.standing() ? 1 : 2) * boundary);
  const Eigen::MatrixXd moved =
      factor_.back_substitute(std::move(nothing), split(wave_.expand_interface(interface), wave_.standing()));
  Eigen::MatrixXcd result(dofs.independent(), boundary);
  result << join(moved.topRows(dofs.interior), wave_.standing()), interface;
  return result;
}

}  // namespace tiprub
