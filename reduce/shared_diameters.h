// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "cases/program/process_group.h"

namespace tiprub::reduce {

/// What the reduction of one nodal diameter gives to the model, and to fields.h5.
struct DiameterResult {
  int generalized_dofs = 0;
  int dropped = 0;                          ///< shapes
  int corrections = 0;                      ///< shapes added for modes between the speeds
  std::vector<Eigen::MatrixXcd> stiffness;  ///< the model's K at the samples (eq. 10)
  Eigen::MatrixXcd mass;                    ///< eq. 10
  Eigen::MatrixXd unreduced;                ///< [Hz] n_s x n_f
  Eigen::VectorXd frequency_errors;         ///< [1] of the mesh; empty: not estimated
  Eigen::VectorXd compliance_errors;        ///< [1] of the mesh; of nodal diameter 0 only
  Eigen::VectorXd frequency_cells;          ///< [1] see MeshErrorEstimate::Errors; empty without fields.h5
  Eigen::VectorXd compliance_cells;         ///< [1] likewise
  Eigen::MatrixXcd shapes;                  ///< of the basis, independent x model dofs; empty without fields.h5
};

/// The independent components of shape k of a basis.
using ShapeOfBasis = std::function<Eigen::VectorXcd(Eigen::Index k)>;

/// Reduces nodal diameters 0 .. `diameters` - 1, as many at once as there are threads, and keeps them in order, so
/// that fields.h5 has the same bytes every time.
void reduce_in_rounds(int diameters, int threads, const std::function<DiameterResult(int n)>& reduce,
                      const std::function<void(int n, DiameterResult, const ShapeOfBasis&)>& keep);

/// Calls reduce(n) for each nodal diameter in process n modulo their number, and keep(n, result, shapes) in the
/// leader, in ascending order; all must call this. They work in rounds of as many nodal diameters as they have
/// threads. After each round the leader gets the results, bit for bit, and all end if one has failed. The shapes
/// arrive one at a time, because they are large; if a result has some, keep() must ask for all of them, in their
/// order.
void share_diameters(ProcessGroup& group, int diameters, int threads,
                     const std::function<DiameterResult(int n)>& reduce,
                     const std::function<void(int n, DiameterResult, const ShapeOfBasis&)>& keep);

}  // namespace tiprub::reduce
