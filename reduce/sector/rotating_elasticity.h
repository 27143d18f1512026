// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <functional>
#include <vector>

#include "reduce/model/reduced_model.h"
#include "reduce/sector/finite_elements.h"
#include "reduce/sector/sector_dofs.h"
#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// Isotropic, linear elastic.
struct Material {
  double young = 0;    ///< [Pa]
  double poisson = 0;  ///< [1]
  double density = 0;  ///< [kg/m^3]

  /// 6 x 6 [Pa], for strains xx, yy, zz, 2 xy, 2 yz, 2 zx.
  Eigen::Matrix<double, 6, 6> elasticity() const;
};

/// Lower triangle of a symmetric matrix over the sector's dofs.
using SymmetricMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/// The pattern of a matrix over the sector's dofs, with zeros in it.
SymmetricMatrix zero_matrix(const SectorMesh& mesh, const SectorDofs& dofs);

/// K, M and the load of one sector in the rotating frame, on its own dofs (both cut faces free; Y_s of eq. 5, of
/// which the blocks of eq. 3 are made, see CyclicTransformation), in cylindrical components. The cells are
/// integrated by deal.II (see FiniteElements).
class RotatingElasticity {
 public:
  /// Assembly runs on up to `threads` threads; the result doesn't depend on their number.
  RotatingElasticity(const SectorMesh& mesh, const SectorDofs& dofs, const Material& material, int threads = 1);

  SymmetricMatrix mass() const;
  /// Tangent stiffness at a speed [rad/s]: material stiffness + K_sigma - Omega^2 M_perp, where M_perp is the mass
  /// without the axial direction (spin softening). `displacement` [m] is the static one at this speed; 3 x nodes, x,
  /// y, z.
  SymmetricMatrix stiffness(double speed, const Eigen::Matrix3Xd& displacement, Prestress prestress,
                            SpinSoftening softening = SpinSoftening::on) const;
  /// Centrifugal load over Omega^2 [kg m], at the shape at rest; sector dofs.
  Eigen::VectorXd centrifugal_load() const;
  /// The same at the radius of the displaced shape; x, y, z, 3 x nodes.
  Eigen::VectorXd centrifugal_load(const Eigen::Matrix3Xd& displacement) const;
  /// Forces of the stress at a displaced shape, int B(F)' S(E) [N]: Green-Lagrange strain E, second Piola-Kirchhoff
  /// stress S = lambda tr(E) + 2 mu E. stiffness(0, u, nonlinear) is its derivative. Sector dofs.
  Eigen::VectorXd internal_force(const Eigen::Matrix3Xd& displacement) const;
  /// phi_a' K'[psi] phi_b [N], where K'[psi] is the derivative of the stiffness at rest along the displacement psi,
  /// with large displacements: the third derivative of the strain energy, which is symmetric in its three directions.
  /// One symmetric matrix for each psi of `along`; `shapes` are the phi. Displacements are 3 x nodes, x, y, z.
  std::vector<Eigen::MatrixXd> stiffness_change(const std::vector<Eigen::Matrix3Xd>& along,
                                                const std::vector<Eigen::Matrix3Xd>& shapes) const;
  /// Stiffness at rest of only some cells: u' K u / 2 is their share of the strain energy [J].
  SymmetricMatrix stiffness_of(const std::vector<int>& cells) const;
  /// [Pa] von Mises stress, the largest of each cell's Gauss points: of the linear stress, or with nonlinear
  /// prestress of the Cauchy stress F S F' / det F.
  Eigen::VectorXd von_mises(const Eigen::Matrix3Xd& displacement, Prestress prestress) const;
  /// [m^3]
  double volume() const;
  /// [kg]
  double total_mass() const { return material_.density * volume(); }

 private:
  using Integral = std::function<Eigen::MatrixXd(const CellPoints&)>;
  /// Of matrices in x, y, z at the nodes of a cell.
  SymmetricMatrix assemble(const Integral& integral) const;
  SymmetricMatrix assemble(const std::vector<int>& cells, const Integral& integral) const;
  /// Of forces, x, y, z at the nodes of a cell; 3 x nodes.
  Eigen::VectorXd assemble_forces(const Integral& nodal_forces) const;
  void scatter(const Eigen::MatrixXd& cell_matrix, const std::vector<int>& nodes, SymmetricMatrix& into) const;

  const SectorMesh& mesh_;
  const SectorDofs& dofs_;
  Material material_;
  FiniteElements elements_;
  SymmetricMatrix zero_;  ///< the pattern
  std::vector<int> all_cells_;
};

}  // namespace tiprub::reduce
