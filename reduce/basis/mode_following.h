// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "reduce/basis/craig_bampton.h"
#include "reduce/operators/cyclic_solver.h"

namespace tiprub::reduce {

/// A speed at which modes are wanted.
struct SpeedToFollow {
  std::string where;           ///< for messages, as "at 9000 rpm"
  Eigen::VectorXd weights;     ///< of the sampled stiffness matrices, whose sum is K
  Eigen::MatrixXcd reduced;    ///< the basis' T^H K T
  const CyclicSolver* nearby;  ///< the solver of the nearest speed that is factorized
};

/// Modes at one speed.
struct FollowedModes {
  Eigen::VectorXd eigenvalue;  ///< [rad^2/s^2] omega^2, ascending; from above
  Eigen::VectorXd error;       ///< [1] estimated relative error that each omega^2 still has

  /// [Hz]
  Eigen::VectorXd frequencies() const;
};

/// Follows the modes of a basis to the modes of the unreduced sector at several speeds, by the generalized
/// Davidson method (Morgan and Scott 1986) without restart. The factor of a nearby speed is the preconditioner.
/// A mode's omega^2 is too high by about r^H K^-1 r, and the basis lacks K^-1 r (reduce/theory.md, section 3), which
/// is nearly the same at all speeds: they are treated one after the other and share the shapes. Most of the time is
/// spent in solves with the factor. They are made only for residuals that may matter: for any other residual, r^H
/// K^-1 r is estimated as r^H r times the largest compliance, r^H K^-1 r / r^H r, of all residuals so far. A mode
/// that is orthogonal to the basis can't be found. The basis must contain the constraint modes at rest and at the
/// speeds of the factors, so that the added shapes may hold the contact nodes. All functions raise RunError if a
/// stiffness is not positive definite on the basis.
///
/// The block Davidson method of Trilinos' Anasazi isn't used because its space belongs to one operator, so that
/// speeds could share nothing, and because it has no complex adapter here (see cyclic_modes.h).
class ModeFollowing {
 public:
  /// The lowest `count` modes, with the sector's K at some speeds; everything must outlive this object.
  ModeFollowing(const CraigBamptonBasis& basis, const SymmetricMatrix& mass,
                const std::vector<SymmetricMatrix>& sampled_stiffness, std::vector<SpeedToFollow> speeds, int count);

  /// Estimates the error of each mode that may exceed `tolerance` at a speed. Returns the missing shapes of the
  /// modes that do exceed it; independent x any number, contact rows of zero.
  Eigen::MatrixXcd missing(std::size_t speed, double tolerance);
  /// Takes one speed after the other and adds the shapes that are missing there, for all speeds. Returns whether
  /// any was missing.
  bool correct(double tolerance);
  /// Repeats this until the error of every mode is at most `tolerance`. Raises RunError if it doesn't converge.
  void converge(double tolerance);

  /// All that was added; independent x any number.
  const Eigen::MatrixXcd& corrections() const { return corrections_; }
  /// By speed, in the given order.
  const std::vector<FollowedModes>& modes() const { return modes_; }

 private:
  void solve(std::size_t speed);
  Eigen::MatrixXcd shapes(std::size_t speed, const std::vector<Eigen::Index>& which) const;
  Eigen::MatrixXcd stiffness_times(const Eigen::MatrixXcd& shapes, std::size_t speed) const;
  Eigen::MatrixXcd products(const Eigen::MatrixXcd& loads) const;
  void add(const Eigen::MatrixXcd& block);

  const CraigBamptonBasis& basis_;
  const SymmetricMatrix& mass_;
  const std::vector<SymmetricMatrix>& sampled_stiffness_;
  std::vector<SpeedToFollow> speeds_;
  int count_;
  double compliance_ = std::numeric_limits<double>::infinity();  ///< [m/N] the largest of all residuals so far
  Eigen::MatrixXcd corrections_;                                 ///< independent x any number
  // Small matrices: the basis, then corrections.
  Eigen::MatrixXcd reduced_mass_;
  std::vector<Eigen::MatrixXcd> reduced_stiffness_;  ///< by speed
  std::vector<Eigen::MatrixXcd> weights_;            ///< of the modes, by speed; size x count
  std::vector<FollowedModes> modes_;
};

}  // namespace tiprub::reduce
