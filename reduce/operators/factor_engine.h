// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <mutex>

#include "cases/program/errors.h"
#include "reduce/operators/stored_matrix.h"

namespace tiprub::reduce {

/// A load on the interior after the first half of a solve. Columns are load cases.
struct Eliminated {
  Eigen::MatrixXd state;           ///< what the second half needs; sector x columns, in the engine's order
  Eigen::MatrixXd interface_load;  ///< -K_FI K_II^-1 b_I; interface x columns
  std::unique_lock<std::mutex> until_substituted;  ///< of an engine that does one solve at a time
};

/// What an engine raises if K_II is not positive definite.
inline RunError unstable_interior() {
  return RunError("the stiffness is not positive definite: the rotor is unstable, or a part of it is not held");
}

/// A library that factorizes a sector's stiffness; see SectorFactor for what the functions do.
class FactorEngine {
 public:
  FactorEngine() = default;
  FactorEngine(const FactorEngine&) = delete;
  FactorEngine& operator=(const FactorEngine&) = delete;
  virtual ~FactorEngine() = default;

  /// S, in the order of SectorDofs; both triangles. It is where the factor is. Called once, right after the
  /// factorization.
  virtual StoredMatrix take_schur_complement() = 0;
  virtual Eliminated eliminate(const Eigen::MatrixXd& interior_load) const = 0;
  /// eliminate() without a load.
  virtual Eliminated unloaded(Eigen::Index columns) const = 0;
  virtual Eigen::MatrixXd back_substitute(Eliminated&& eliminated, const Eigen::MatrixXd& interface) const = 0;
};

}  // namespace tiprub::reduce
