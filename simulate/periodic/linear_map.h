// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>

namespace tiprub {

/// The product A x of an operator A that is not available as a matrix.
using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

}  // namespace tiprub
