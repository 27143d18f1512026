// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "simulate/periodic/periodic_map.h"

namespace tiprub::simulate {

/// x with |f - (1 - A) x| <= tolerance |f|, or the best after 200 steps, by GMRES (Saad, Schultz 1986).
/// `precondition` is a fixed linear map near (1 - A)^-1. A step costs one product with A and one with that map.
///
/// Belos has such a solver for vectors of Epetra or Tpetra only. Their libraries take 40 ms to load, four times as
/// long as the rest of the program.
Eigen::VectorXd gmres(const LinearMap& A, const LinearMap& precondition, const Eigen::VectorXd& f, double tolerance);

}  // namespace tiprub::simulate
