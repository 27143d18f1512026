// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "reduce/operators/cyclic_transformation.h"
#include "reduce/sector/rotating_elasticity.h"

namespace tiprub::reduce::test {

/// Both triangles.
Eigen::MatrixXd dense(const SymmetricMatrix& lower);

/// T of one nodal diameter written out: the high cut face is the low one times e^{i n 2 pi/N}; sector x independent.
Eigen::MatrixXcd phase_matrix(const SectorDofs& dofs, int sector_count, int nodal_diameter);

/// T^H Y T written out.
Eigen::MatrixXcd cyclic(const SymmetricMatrix& matrix, const SectorDofs& dofs, int sector_count, int nodal_diameter);

/// eq. 10: T^H Y T for a sector matrix and a basis; Hermitian, and real for a standing transform.
Eigen::MatrixXcd project(const CyclicTransformation& transform, const SymmetricMatrix& matrix,
                         const Eigen::MatrixXcd& basis);

/// A^-1 b of a Hermitian positive definite A.
Eigen::MatrixXd solved(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b);
Eigen::MatrixXcd solved(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& b);

bool is_positive_definite(const Eigen::MatrixXcd& A);

/// Of K x = lambda M x, ascending.
Eigen::VectorXd generalized_eigenvalues(const Eigen::MatrixXcd& K, const Eigen::MatrixXcd& M);

/// Largest entry of a - b over the largest entry of b.
double difference(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b);

/// Reproducible entries in [-1, 1], complex.
Eigen::MatrixXcd arbitrary(Eigen::Index rows, Eigen::Index columns);

}  // namespace tiprub::reduce::test
