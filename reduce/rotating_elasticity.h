// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <functional>
#include <vector>

#include "reduce/brick_quadrature.h"
#include "reduce/sector_dofs.h"
#include "reduce/sector_mesh.h"

namespace tiprub {

/// Isotropic, linear elastic.
struct Material {
  double young = 0;    ///< [Pa]
  double poisson = 0;  ///< [1]
  double density = 0;  ///< [kg/m^3]

  /// 6 x 6 [Pa], for strains xx, yy, zz, 2 xy, 2 yz, 2 zx.
  Eigen::Matrix<double, 6, 6> elasticity() const;
};

/// What the loaded shape changes in the stiffness.
enum class Prestress {
  stress_only,  ///< K0 + Omega^2 (K_sigma - M_perp): the stress of the linear static solution, on the shape at rest
  linear,       ///< material stiffness at F = I + grad u of the linear static solution, plus its K_sigma: what
                ///< CalculiX does after a linear static step; then quadratic in Omega^2, exactly as eq. 7
};

/// Lower triangle of a symmetric matrix over the sector's dofs.
using SymmetricMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/// K, M and the load of one sector in the rotating frame, on its own dofs (both cut faces free), in cylindrical
/// components. Assembly is by full 3 x 3 x 3 Gauss quadrature on 20- or 27-node bricks.
class RotatingElasticity {
 public:
  /// Assembly runs on up to `threads` threads; the result doesn't depend on their number.
  RotatingElasticity(const SectorMesh& mesh, const SectorDofs& dofs, const Material& material, int threads = 1);

  SymmetricMatrix mass() const;
  /// Tangent stiffness at a speed [rad/s]: material stiffness + K_sigma - Omega^2 M_perp, where M_perp is the mass
  /// without the axial direction (spin softening). `displacement` [m] is the static one at this speed; 3 x nodes, x,
  /// y, z.
  SymmetricMatrix stiffness(double speed, const Eigen::Matrix3Xd& displacement, Prestress prestress) const;
  /// Centrifugal load over Omega^2 [kg m], at the shape at rest; sector dofs.
  Eigen::VectorXd centrifugal_load() const;
  /// [m^3]
  double volume() const;

 private:
  using CellMatrix = std::function<Eigen::MatrixXd(const BrickPoints&)>;
  SymmetricMatrix assemble(const CellMatrix& cell_matrix) const;
  void scatter(const Eigen::MatrixXd& cell_matrix, const std::vector<int>& nodes, SymmetricMatrix& into) const;

  const SectorMesh& mesh_;
  const SectorDofs& dofs_;
  Material material_;
  int threads_;
  BrickQuadrature quadrature_;
  SymmetricMatrix zero_;  ///< the pattern
};

}  // namespace tiprub
