// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <vector>

#include "reduce/operators/cyclic_solver.h"
#include "reduce/sector/added_functions.h"
#include "reduce/sector/contact_unknowns.h"

namespace tiprub::reduce {

/// Estimates the error that a mesh causes in frequencies and compliances at rest, without a finer mesh.
///
/// A mesh with the stiffness K answers the load f_u with K u = f_u and the work J = f_u'u. If its space is enlarged
/// by cubic functions w (see AddedFunctions), the stiffness A of both, of a quadrature that is exact in straight
/// cells, answers the load f = (f_w, f_u) with the work f'A^-1 f. From u on, with the residual r = f - A (0, u),
///     f'A^-1 f - J = u'r_u + r'A^-1 r.
/// r_u = (K - A_uu) u is due to the quadrature by which the cells themselves are integrated. A is positive definite,
/// whatever K is. A Schur complement of it with K^-1 in place of A_uu^-1 is not, where the points of a cell are few:
/// K of wedges of 9 points is smaller than A_uu by more than is left.
///
/// A compliance is the work of a unit force. A mode (omega^2, u) with u' M u = 1 has the load omega^2 B u, where B is
/// the mass of that quadrature. Its squared frequency is to the exact one as
///     omega^2 : omega_exact^2 = u' B_uu u f'A^-1 f : J.
///
/// Some steps of the conjugate gradient method find r'A^-1 r from below. Their preconditioner is the block
/// elimination of A, with K in place of A_uu. In place of the Schur complement of w it solves the problem of the
/// functions, cubic ones and those of the nodes, that vanish outside the cells around a corner, for each corner
/// (additive Schwarz). In the frame of a patch on the cuts all factors e^{i n alpha} cancel, so that its matrix is
/// real and serves all nodal diameters. A problem for each cell alone (Bank and Weiser 1985) is cheaper, but locks in
/// shear where a single brick spans a thin plate, and misses most of the error there. A step costs two solutions with
/// K. One of them, that for the nodes' residual, changes nothing for straight bricks; without it the steps stall for
/// wedges.
///
/// A brick of 20 nodes takes 95 kB, one of 27 nodes 190 kB, a tetrahedron 25 kB; the patches, in single precision,
/// take 30 kB a cell, for bricks of 27 nodes 110 kB.
class MeshErrorEstimate {
 public:
  /// Of some results.
  struct Errors {
    Eigen::VectorXd of_each;   ///< [1] relative error of each
    Eigen::VectorXd of_cells;  ///< [1] what each cell contributes to the mean of these; their sum is that mean
  };

  /// [bytes] that one takes.
  static double memory(const SectorMesh& mesh);
  /// The mesh, which AddedFunctions must serve, and its dofs must outlive this object.
  MeshErrorEstimate(const SectorMesh& mesh, const SectorDofs& dofs, const Material& material, int threads);

  /// By how much the mesh makes each frequency too high; `shapes` are modes at rest of unit modal mass, independent x
  /// modes, and `eigenvalues` [rad^2/s^2] their omega^2.
  Errors of_frequencies(const CyclicSolver& at_rest, const Eigen::VectorXd& eigenvalues,
                        const Eigen::MatrixXcd& shapes) const;
  /// By how much the mesh makes the static displacement of each contact unknown under a unit force along its normal
  /// too small.
  Errors of_compliances(const CyclicSolver& at_rest, const ContactUnknowns& contact) const;

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

  /// Displacements or forces of the independent dofs.
  struct Pair {
    Rows cubic, nodes;
  };

  /// The change e = A^-1 r of some displacements, and its energy.
  struct Change {
    Pair displacement;
    Eigen::RowVectorXd energy;  ///< [J] e'A e
  };
  /// (f'A^-1 f - J)/J of some loads, and the energies e'A e [J] of the cells.
  struct Growths {
    Eigen::ArrayXd of_each;
    Eigen::MatrixXd of_cells;  ///< cells x loads
  };

  Growths growths(const CyclicSolver& at_rest, const Pair& load, int steps) const;
  Change change(const CyclicSolver& at_rest, Pair residual, int steps) const;
  Eigen::MatrixXd energies_of_cells(const CyclicSolver& at_rest, const Pair& displacement) const;
  Pair apply_stiffness(const CyclicSolver& at_rest, const Pair& displacement) const;
  Pair apply_mass(const CyclicSolver& at_rest, const Eigen::MatrixXcd& acceleration) const;
  Pair precondition(const CyclicSolver& at_rest, const Pair& residual) const;
  Rows solve_patches(const CyclicSolver& at_rest, const Rows& residual) const;

  const SectorDofs& node_dofs_;
  AddedFunctions functions_;
  std::vector<AddedCell> cells_;
  std::vector<Patch> patches_;
};

}  // namespace tiprub::reduce
