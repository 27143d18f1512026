// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

namespace tiprub {

/// Lists of cells or nodes by their names.
using NamedLists = std::map<std::string, std::vector<int>>;

/// Why these lists of cells can't be the parts of a sector; empty if they can. No part is empty, no cell is listed
/// twice or in two parts, and the nodes of a blade's tip line (`tips`, by the name of the blade's part) belong to
/// cells of that part, if it is there. What is computed by part (stress, energy) would else be told of another part.
std::string wrong_parts(const Eigen::MatrixXi& cells, const NamedLists& parts, const NamedLists& tips);

/// A value that a list has twice, or -1.
int listed_twice(std::vector<int> list);

}  // namespace tiprub
