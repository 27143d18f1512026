// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>

namespace tiprub {

/// A x, for an A that nobody has as a matrix.
using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

}  // namespace tiprub
