// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "reduce/model/reduced_model.h"
#include "reduce/operators/speed_samples.h"

namespace tiprub {

/// A model's K by nodal diameter and sampled speed.
using SampledStiffness = std::vector<std::vector<Eigen::MatrixXcd>>;

/// eq. 7 of the paper: fills in K0, K1, ... of a model that has M, and for nonlinear prestress what eq. 7 alone makes
/// wrong in the verification frequencies: K of the polynomial's shape against K of the equilibrium on the same basis.
void fit_polynomial(const SampledStiffness& stiffness, const SpeedSamples& samples,
                    const ReductionParameters& parameters, ReducedModel& model);

}  // namespace tiprub
