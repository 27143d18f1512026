// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <vector>

#include "reduce/operators/cyclic_solver.h"
#include "reduce/sector/added_functions.h"
#include "reduce/sector/contact_unknowns.h"

namespace tiprub::reduce {

/// Estimates the error that a mesh of bricks causes in frequencies and compliances at rest, without a finer mesh.
///
/// If the space of a mesh is enlarged by cubic functions w (see AddedFunctions), a static displacement u of the load
/// f changes by e with
///     S e_w = r,   r = f_w - K_wu u,   S = K_ww - K_wu K_uu^-1 K_uw,
/// and the work f'u of the load grows by the energy e' K e = r' S^-1 r. The mesh's own factor gives K_uu^-1. A mode
/// (omega^2, u) with u' M u = 1 is the static displacement of its load of inertia omega^2 M u, whose work is omega^2:
/// a frequency is too high by sqrt(1 + r' S^-1 r / omega^2) - 1. To first order this is half the ratio of both
/// energies.
///
/// S is never formed. Some steps of the conjugate gradient method find r' S^-1 r from below. Their preconditioner
/// solves the problem of the functions, cubic ones and those of the nodes, that vanish outside the cells around a
/// corner, for each corner (additive Schwarz). In the frame of a patch on the cuts all factors e^{i n alpha} cancel,
/// so that its matrix is real and serves all nodal diameters. A problem for each cell alone (Bank and Weiser 1985) is
/// cheaper, but locks in shear where a single brick spans a thin plate, and misses most of the error there.
///
/// The cells' matrices take about 70 kB a cell, and the patches, in single precision, 20 kB.
class MeshErrorEstimate {
 public:
  /// The mesh, of bricks of 20 nodes, and its dofs must outlive this object.
  MeshErrorEstimate(const SectorMesh& mesh, const SectorDofs& dofs, const Material& material, int threads);

  /// [1] by which the mesh makes each frequency too high; `shapes` are modes at rest of unit modal mass, independent
  /// x modes, and `eigenvalues` [rad^2/s^2] their omega^2.
  Eigen::VectorXd of_frequencies(const CyclicSolver& at_rest, const Eigen::VectorXd& eigenvalues,
                                 const Eigen::MatrixXcd& shapes) const;
  /// [1] by which the mesh makes the static displacement of each contact unknown under a unit force along its normal
  /// too small.
  Eigen::VectorXd of_compliances(const CyclicSolver& at_rest, const ContactUnknowns& contact) const;

 private:
  /// Real matrices act on rows of complex numbers as on twice as many real ones.
  using Rows = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// A function seen from a patch on a cut, which continues into the sector before: `sectors` are counted from the
  /// patch to the sector of the function.
  struct Seen {
    int dof = 0;  ///< independent, the first of three
    int sectors = 0;
    auto operator<=>(const Seen&) const = default;
  };
  struct Patch {
    std::vector<Seen> functions;
    Eigen::MatrixXf compliance;  ///< [m/N] of the cubic functions
  };
  class Patches;

  Rows residual(const Rows& displacement, const Rows& acceleration) const;
  Eigen::VectorXd energies(const CyclicSolver& at_rest, Rows residual, int steps) const;
  Rows apply_schur_complement(const CyclicSolver& at_rest, const Rows& cubic) const;
  Rows precondition(const CyclicSolver& at_rest, const Rows& residual) const;

  const SectorDofs& node_dofs_;
  AddedFunctions functions_;
  std::vector<AddedCell> cells_;
  std::vector<Patch> patches_;
};

}  // namespace tiprub::reduce
