// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <vector>

#include "reduce/operators/cyclic_solver.h"
#include "reduce/sector/added_functions.h"
#include "reduce/sector/contact_unknowns.h"

namespace tiprub::reduce {

/// Estimates the error that a mesh causes in frequencies and compliances at rest, without a finer mesh: section 8 of
/// reduce/theory.md, with its names. w are those of AddedFunctions.
///
/// A is positive definite, whatever K is. If K took the place of A_uu in A, this would not hold for cells with few
/// points: K of wedges with 9 points is smaller than A_uu by more than the Schur complement.
///
/// The preconditioner of the conjugate gradients is the block elimination of A with K in place of A_uu. In place of
/// the Schur complement on w, it solves for each corner the problem of the functions, cubic and nodal ones, that
/// vanish outside the cells around this corner (additive Schwarz). For a patch on the cuts, the factors e^{i n alpha}
/// cancel in a frame of its own, so that its matrix is real and serves all nodal diameters. K of straight bricks is
/// A_uu, so that the nodes that follow the cubic functions leave no residual, and that of curved ones is left out
/// (4e-5 of the error of a frequency on a sector of 115,812 dofs). Without the solution for it the iteration stalls
/// for wedges.
///
/// Memory: a brick of 20 nodes takes 95 kB, one of 27 nodes 190 kB, a tetrahedron 25 kB. The patches, in single
/// precision, take 30 kB per cell, or 110 kB for bricks of 27 nodes.
class MeshErrorEstimate {
 public:
  /// The relative errors of some results.
  struct Errors {
    Eigen::VectorXd of_each;   ///< [1] relative error of each result
    Eigen::VectorXd of_cells;  ///< [1] contribution of each cell to the mean error; their sum is this mean
  };

  /// [bytes] The memory that an object takes.
  static double memory(const SectorMesh& mesh);
  /// The mesh must be one that AddedFunctions accepts. The mesh and its dofs must outlive this object.
  MeshErrorEstimate(const SectorMesh& mesh, const SectorDofs& dofs, const Material& material, int threads);

  /// By how much the mesh makes each frequency too high. `shapes` are modes at rest of unit modal mass, independent x
  /// modes, and `eigenvalues` [rad^2/s^2] their omega^2.
  Errors of_frequencies(const CyclicSolver& at_rest, const Eigen::VectorXd& eigenvalues,
                        const Eigen::MatrixXcd& shapes) const;
  /// By how much the mesh makes each compliance too small: the static displacement of a contact unknown under a unit
  /// force along its normal.
  Errors of_compliances(const CyclicSolver& at_rest, const ContactUnknowns& contact) const;

 private:
  /// Rows of complex numbers, on which a real matrix acts as on twice as many real numbers.
  using Rows = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// A function in the frame of a patch on a cut, which continues into the sector before. `sectors` counts from the
  /// sector of the patch to that of the function.
  struct Seen {
    int dof = 0;  ///< independent dof, the first of three
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

  /// The changes e = A^-1 r of some displacements, and their energies.
  struct Change {
    Pair displacement;
    Eigen::RowVectorXd energy;  ///< [J] e'A e
  };
  /// The growth (f'A^-1 f - J)/J of the work of some loads, and the energies e'A e [J] of the cells.
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
  bool of_bricks_ = false;  ///< all cells
};

}  // namespace tiprub::reduce
