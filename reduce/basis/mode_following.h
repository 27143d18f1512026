// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "reduce/basis/craig_bampton.h"
#include "reduce/operators/cyclic_solver.h"

namespace tiprub {

/// A speed at which modes are wanted.
struct SpeedToFollow {
  std::string where;                           ///< for messages, as "at 9000 rpm"
  std::function<SymmetricMatrix()> stiffness;  ///< makes the sector's K when it is needed; it isn't kept
  Eigen::MatrixXcd reduced;                    ///< the basis' T^H K T
  const CyclicSolver* nearby;                  ///< the solver of the nearest speed that is factorized
};

/// Modes at one speed.
struct FollowedModes {
  Eigen::VectorXd eigenvalue;  ///< [rad^2/s^2] omega^2, ascending; from above
  Eigen::VectorXd error;       ///< [1] estimated relative error of each omega^2 that is left

  /// [Hz]
  Eigen::VectorXd frequencies() const;
};

/// Follows the modes of a basis to the modes of the unreduced sector at several speeds, by the generalized Davidson
/// method (Morgan and Scott 1986) without restart. The factor of a nearby speed is the preconditioner. With r = K x -
/// omega^2 M x, a mode's omega^2 is too high by about r^H K^-1 r, and K^-1 r is what the basis lacks. What a mode
/// lacks at one speed it lacks, nearly unchanged, at all speeds, so the speeds are treated one after the other and
/// share the shapes found. The passes through the factor take most of the time, so only residuals that matter are
/// taken through it: for the others, r^H K^-1 r is at most about r^H r times the largest compliance, r^H K^-1 r / r^H
/// r, of any residual so far. A mode that is orthogonal to the basis can't be found. The basis must hold the
/// constraint modes of rest and of the factors' speeds, so that contact nodes may be held in what is added. All raise
/// RunError if a stiffness is not positive definite on the basis.
///
/// The block Davidson method of Trilinos' Anasazi isn't used because its space belongs to one operator, so that
/// speeds could share nothing, and because it has no complex adapter here (see cyclic_modes.h).
class ModeFollowing {
 public:
  /// The lowest `count` modes; everything must outlive this object.
  ModeFollowing(const CraigBamptonBasis& basis, const SymmetricMatrix& mass, std::vector<SpeedToFollow> speeds,
                int count);

  /// Estimates the error of each mode that may err by more than `tolerance` at a speed. Returns the shapes that those
  /// lack that do; independent x any number, contact rows of zero.
  Eigen::MatrixXcd missing(std::size_t speed, double tolerance);
  /// Adds, one speed after the other, the shapes that are missing there, for all speeds. Returns whether any was
  /// missing.
  bool correct(double tolerance);
  /// Repeats this until no mode errs by more than `tolerance`. Raises RunError if it doesn't converge.
  void converge(double tolerance);

  /// All that was added; independent x any number.
  const Eigen::MatrixXcd& corrections() const { return corrections_; }
  /// By speed, in the given order.
  const std::vector<FollowedModes>& modes() const { return modes_; }

 private:
  void solve(std::size_t speed);
  Eigen::MatrixXcd shapes(std::size_t speed, const std::vector<Eigen::Index>& which) const;
  Eigen::MatrixXcd products(const Eigen::MatrixXcd& loads) const;
  void add(const Eigen::MatrixXcd& block);

  const CraigBamptonBasis& basis_;
  const SymmetricMatrix& mass_;
  std::vector<SpeedToFollow> speeds_;
  int count_;
  double compliance_ = std::numeric_limits<double>::infinity();  ///< [m/N] the largest that a residual has had
  Eigen::MatrixXcd corrections_;                                 ///< independent x any number
  // Small matrices: the basis, then corrections.
  Eigen::MatrixXcd reduced_mass_;
  std::vector<Eigen::MatrixXcd> reduced_stiffness_;  ///< by speed
  std::vector<Eigen::MatrixXcd> weights_;            ///< of the modes, by speed; size x count
  std::vector<FollowedModes> modes_;
};

}  // namespace tiprub
