// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>

#include "cases/program/process_group.h"
#include "reduce/basis/diameter_reduction.h"

namespace tiprub::reduce {

/// The independent components of shape k of a basis.
using ShapeOfBasis = std::function<Eigen::VectorXcd(Eigen::Index k)>;

/// Calls reduce(n) for each nodal diameter in process n modulo their number, and keep(n, result, shapes) in the
/// leader, in ascending order; all must call this. They work in rounds of as many nodal diameters as they have
/// threads. After each round the leader gets the results, bit for bit, and all end if one has failed. The shapes
/// arrive one at a time, because they are large; if a result has some, keep() must ask for all of them, in their
/// order.
void share_diameters(ProcessGroup& group, int diameters, int threads,
                     const std::function<DiameterResult(int n)>& reduce,
                     const std::function<void(int n, DiameterResult, const ShapeOfBasis&)>& keep);

}  // namespace tiprub::reduce
