// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "cases/program/progress.h"
#include "reduce/operators/mesh_error.h"
#include "reduce/operators/spinning_sector.h"

namespace tiprub::reduce {

/// What the reductions of all nodal diameters share.
struct SharedByDiameters {
  const ReductionParameters& parameters;
  const SpinningSector& sector;
  const SectorFactor& at_rest;
  const SectorFactor& at_top;  ///< at Omega_max
  const ContactUnknowns& contact;
  const MeshErrorEstimate* mesh_error;  ///< null: not estimated
  bool with_fields;                     ///< whether there will be a fields.h5
};

/// What the reduction of one nodal diameter gives to the model, and to fields.h5.
struct DiameterResult {
  int generalized_dofs = 0;
  int dropped = 0;                          ///< shapes
  int corrections = 0;                      ///< shapes added for modes between the speeds
  std::vector<Eigen::MatrixXcd> stiffness;  ///< the model's K at the samples (eq. 10)
  Eigen::MatrixXcd mass;                    ///< eq. 10
  Eigen::MatrixXd unreduced;                ///< [Hz] lowest frequencies at the verification speeds; n_s x n_f
  Eigen::VectorXd frequency_errors;         ///< [1] of the mesh, at rest; n_f; empty: not estimated
  Eigen::VectorXd compliance_errors;        ///< [1] of the mesh; of nodal diameter 0 only
  Eigen::VectorXd frequency_cells;          ///< [1] see MeshErrorEstimate::Errors; empty without fields.h5
  Eigen::VectorXd compliance_cells;         ///< [1] likewise
  Eigen::MatrixXcd shapes;                  ///< of the basis, independent x model dofs; empty without fields.h5
};

/// What reduce_diameter() reports as progress: the modes at rest, the basis, its verification.
inline constexpr int steps_of_a_diameter = 3;

/// The reduction of one nodal diameter: a Craig-Bampton basis from two speeds, rest and Omega_max, its corrections at
/// the speeds between, and the unreduced frequencies that verify it. Holds a dense factor for each of the two speeds,
/// and a Lanczos or Davidson space while it looks for modes. Raises RunError, with the speed, if the rotor is
/// unstable, and InputError if the model would have fewer dofs than frequencies that verify it.
DiameterResult reduce_diameter(const SharedByDiameters& shared, const CyclicTransformation& transform,
                               int nodal_diameter, Progress& progress);

}  // namespace tiprub::reduce
