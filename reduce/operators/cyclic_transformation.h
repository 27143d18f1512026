// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <complex>

#include "reduce/sector/rotating_elasticity.h"

namespace tiprub::reduce {

/// The cyclic transformation T of one nodal diameter n of a wheel of N sectors, u_j = Re(u e^{i n j alpha}) with
/// alpha = 2 pi/N.
///
/// eq. 3: a wheel's K and M are block-circulant. A sector's high cut face is its neighbour's low one, so the dofs of
/// one sector are interior | low face | contact; Y_0 couples them with themselves, Y_1 with those of the sector
/// before. eq. 4: the Fourier matrix makes them block-diagonal, with one block for each nodal diameter, so that
/// neither the wheel's matrices nor the Fourier matrix are ever formed. eq. 6: in cylindrical components the high
/// face moves as the low one times e^{i n alpha}, and
///     T^H Y_s T = Y_0 + e^{-i n alpha} Y_1 + e^{i n alpha} Y_1^T
/// of the sector's own Y_s (both cut faces free) is the block of n. It takes the place of the paper's real block in
/// half its size: the real and imaginary part of u are its cosine and (negative) sine halves.
///
/// Independent dofs are interior | low | contact, sector dofs interior | low | high | contact (eq. 5, SectorDofs).
/// Costs a pass through the sector's matrix for 8 complex columns, or 16 real ones.
class CyclicTransformation {
 public:
  CyclicTransformation(const SectorDofs& dofs, int sector_count, int nodal_diameter);
  /// The sector alone: both cut faces are held, so that T is zero on them.
  static CyclicTransformation of_held_faces(const SectorDofs& dofs);
  /// The same nodal diameter for other dofs.
  CyclicTransformation with(const SectorDofs& dofs) const;

  const SectorDofs& dofs() const { return dofs_; }
  /// e^{i n alpha}; 0 where the faces are held
  std::complex<double> phase() const { return phase_; }
  bool holds_faces() const { return low_ == 0.0; }
  /// n = 0 or n = N/2: all matrices are real.
  bool is_real() const { return phase_.imag() == 0.0; }
  /// T x: sector x columns from independent x columns.
  Eigen::MatrixXcd expand(const Eigen::MatrixXcd& independent) const;
  /// T^H f: independent x columns from sector x columns.
  Eigen::MatrixXcd gather(const Eigen::MatrixXcd& sector) const;
  /// T^H Y T x for a symmetric sector matrix Y (K or M). For a standing wave x must be real.
  Eigen::MatrixXcd apply(const SymmetricMatrix& matrix, const Eigen::MatrixXcd& independent) const;
  /// The same two maps on the interface part: low | high | contact <-> low | contact.
  Eigen::MatrixXcd expand_interface(const Eigen::MatrixXcd& independent) const;
  Eigen::MatrixXcd gather_interface(const Eigen::MatrixXcd& sector) const;

 private:
  SectorDofs dofs_;
  double low_ = 1.0;  ///< T on the low face; 0 where it is held
  std::complex<double> phase_;
};

}  // namespace tiprub::reduce
