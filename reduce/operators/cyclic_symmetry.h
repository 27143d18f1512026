// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <memory>

#include "reduce/operators/sector_factor.h"

namespace tiprub {

/// eq. 3: a wheel's K and M are block-circulant, for a sector's high cut face is its neighbour's low one. eq. 4: the
/// Fourier matrix makes them block-diagonal, a block a nodal diameter; neither is ever formed.
///
/// One nodal diameter n of a wheel of N sectors: a travelling wave u_j = Re(u e^{i n j alpha}), alpha = 2 pi/N. In
/// cylindrical components the high cut face moves as the low one times e^{i n alpha}; this takes the place of eq. 6
/// of the paper in half its size (one complex matrix instead of a real one of twice the order). Independent dofs are
/// interior | low face | contact, sector dofs interior | low | high | contact.
class TravellingWave {
 public:
  TravellingWave(const SectorDofs& dofs, int sector_count, int nodal_diameter);

  const SectorDofs& dofs() const { return dofs_; }
  /// e^{i n alpha}
  std::complex<double> phase() const { return phase_; }
  /// n = 0 or n = N/2: all matrices are real.
  bool standing() const { return phase_.imag() == 0.0; }
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
  std::complex<double> phase_;
};

/// What holds the contact nodes.
enum class ContactNodes { free, fixed };

/// (T^H K T)^-1 of one nodal diameter, from the one factor of the sector's K.
class CyclicStiffness {
 public:
  /// Raises RunError if K of this nodal diameter is not positive definite.
  CyclicStiffness(const SectorFactor& factor, const TravellingWave& wave);

  /// x with K x = b; independent x columns; b must be real for a standing wave. With fixed contact nodes their rows
  /// of b are ignored, of x zero.
  Eigen::MatrixXcd solve(const Eigen::MatrixXcd& load, ContactNodes contact) const;
  /// The constraint modes, Psi_s of eq. 8 with its unit rows: static shapes of a unit displacement of each contact
  /// dof, all else free of load; independent x contact dofs.
  Eigen::MatrixXcd constraint_modes() const;
  const TravellingWave& wave() const { return wave_; }

 private:
  Eigen::MatrixXcd solve_block(const Eigen::MatrixXcd& load, ContactNodes contact) const;

  const SectorFactor& factor_;
  TravellingWave wave_;
  Eigen::MatrixXcd
      cholesky_;  ///< L of S_n = T^H S T, low | contact; its leading block is that of fixed contact nodes
};

}  // namespace tiprub
