// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <filesystem>
#include <memory>
#include <mutex>

#include "cases/program/errors.h"
#include "reduce/operators/scratch_files.h"
#include "reduce/sector/rotating_elasticity.h"

namespace tiprub::reduce {

/// The library that factorizes, and where its factor is.
enum class FactorMethod {
  cholmod,        ///< in memory, the fastest
  mumps,          ///< in memory
  mumps_on_disk,  ///< out of core, with S: the memory holds what the factorization is at work on
};

struct FactorChoice {
  FactorMethod method = FactorMethod::cholmod;
  std::filesystem::path scratch_folder;  ///< for files of a factor on disk; empty: the working folder
};

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

/// A library that factorizes a sector's stiffness.
class FactorEngine {
 public:
  FactorEngine() = default;
  FactorEngine(const FactorEngine&) = delete;
  FactorEngine& operator=(const FactorEngine&) = delete;
  virtual ~FactorEngine() = default;

  /// S, in the order of SectorDofs; both triangles. It is where the factor is. Called once, right after the
  /// factorization.
  virtual StoredMatrix take_schur_complement() = 0;
  /// First half of a solve: from a load on the interior (rows 0 .. interior-1 of `interior_load`), the load that
  /// reaches the interface, -K_FI K_II^-1 b_I, and what back_substitute() needs of it. With MUMPS other threads wait
  /// from here on until the second half is done.
  virtual Eliminated eliminate(const Eigen::MatrixXd& interior_load) const = 0;
  /// The same without a load.
  virtual Eliminated unloaded(Eigen::Index columns) const = 0;
  /// Second half: the displacement of the sector when its interface moves by `interface` (interface x columns);
  /// sector x columns, in the order of SectorDofs.
  virtual Eigen::MatrixXd back_substitute(Eliminated&& eliminated, const Eigen::MatrixXd& interface) const = 0;
};

/// P K P' = L L' in memory, a supernodal Cholesky factorization (CHOLMOD; Chen, Davis, Hager, Rajamanickam 2008) in
/// which the interface comes last. Then L_FF L_FF' is the Schur complement.
///
/// The K of a sector with free cut faces may be indefinite at speed: a multiple of the identity is therefore added
/// to K_FF before the factorization, and subtracted from S afterwards. Raises RunError.
std::unique_ptr<FactorEngine> factorize_by_cholmod(const SymmetricMatrix& stiffness, const SectorDofs& dofs);

/// K_II = L D L' and the Schur complement of the interface by the multifrontal method (MUMPS; Amestoy, Duff, Koster,
/// L'Excellent 2001). The interface itself is not factorized, so that K_FF needs no shift. A factor on disk is
/// written to files in the scratch folder as it is made, and each pass of a solve reads them.
///
/// MUMPS and its files hold the state of one solve in variables of the process: eliminate() therefore locks all
/// factors of MUMPS until back_substitute(). Passes cost about 1.5 times CHOLMOD's, as the library sorts and copies
/// right sides; that is why CHOLMOD is taken where its factors fit. Starts MPI if nothing has started it yet.
///
/// Raises RunError if K_II is not positive definite, or if memory or disk don't suffice.
std::unique_ptr<FactorEngine> factorize_by_mumps(const SymmetricMatrix& stiffness, const SectorDofs& dofs,
                                                 const FactorChoice& choice);

/// Raises RunError if CHOLMOD ended with this status without a factor: for lack of memory, or because numbers of
/// entries exceed what it or the BLAS can count.
void require_factor(int status, Eigen::Index dofs);
/// Raises RunError for a return value INFOG(1) of MUMPS, with INFOG(2), that isn't zero or a warning.
void require_mumps(int error, int detail, Eigen::Index dofs);

}  // namespace tiprub::reduce
