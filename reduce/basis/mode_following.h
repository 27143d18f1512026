// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reduce/basis/craig_bampton.h"
#include "reduce/operators/cyclic_solver.h"

namespace tiprub {

/// A speed at which modes are wanted.
struct SpeedToFollow {
  std::string where;                           ///< for messages, as "at 9000 rpm"
  std::function<SymmetricMatrix()> stiffness;  ///< the sector's K; asked for when it is needed, and not kept
  Eigen::MatrixXcd reduced;                    ///< the basis' T^H K T
  const CyclicSolver* nearby;                  ///< of the nearest speed that is factorized
};

/// Modes at one speed.
struct FollowedModes {
  Eigen::VectorXd eigenvalue;  ///< [rad^2/s^2] omega^2, ascending; from above
  Eigen::VectorXd error;       ///< [1] estimated relative error of each omega^2 that is left

  /// [Hz]
  Eigen::VectorXd frequencies() const;
};

/// From the modes of a basis to the modes of the unreduced sector at several speeds, with the factor of a speed
/// nearby as preconditioner: generalized Davidson (Morgan and Scott 1986), without restart and on all speeds at once,
/// because it is the passes through the factor that cost. With r = K x - omega^2 M x, a mode's omega^2 is too high by
/// about r^H K^-1 r, and K^-1 r is what the basis lacks. What the basis doesn't contain at all can't be found. The
/// basis must hold the constraint modes of rest and of the factors' speeds, so that contact nodes may be held in what
/// is added. All raise RunError if a stiffness is not positive definite on the basis.
///
/// Why not Trilinos' Anasazi (it has a block Davidson): its space belongs to one operator, so that each speed would
/// pass through the factor by itself, and it has no complex adapter here (see cyclic_modes.h).
class ModeFollowing {
 public:
  /// The lowest `count` modes; everything must outlive this object.
  ModeFollowing(const CraigBamptonBasis& basis, const SymmetricMatrix& mass, std::vector<SpeedToFollow> speeds,
                int count);

  /// Shapes that the basis misses, for each mode whose omega^2 errs by more than `tolerance`; one block a speed,
  /// independent x any number, contact rows of zero.
  std::vector<Eigen::MatrixXcd> missing(double tolerance);
  /// Repeats until no mode errs by more. Raises RunError if it doesn't converge.
  void converge(double tolerance);

  /// By speed, in the given order.
  const std::vector<FollowedModes>& modes() const { return modes_; }

 private:
  /// What is known of the basis and its corrections at one speed.
  struct Space {
    Eigen::MatrixXcd K, M;         ///< small matrices: the basis, then corrections
    Eigen::MatrixXcd corrections;  ///< independent x any number
    Eigen::MatrixXcd weights;      ///< of the modes; size of K x count
  };
  void solve(std::size_t speed);
  Eigen::MatrixXcd shapes(std::size_t speed, const std::vector<Eigen::Index>& which) const;
  Eigen::MatrixXcd precondition(const std::vector<Eigen::MatrixXcd>& blocks, const Eigen::MatrixXcd& residual) const;
  void add(const std::vector<Eigen::MatrixXcd>& blocks);

  const CraigBamptonBasis& basis_;
  const SymmetricMatrix& mass_;
  std::vector<SpeedToFollow> speeds_;
  int count_;
  std::vector<Space> spaces_;
  std::vector<FollowedModes> modes_;
};

}  // namespace tiprub
