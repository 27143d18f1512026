// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>

namespace tiprub {

/// One number of each row of a list: a member, or what a function makes of the row.
template <class Rows, class Number>
Eigen::VectorXd column(const Rows& rows, const Number& number) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(rows.size()));
  Eigen::Index place = 0;
  for (const auto& row : rows) values[place++] = static_cast<double>(std::invoke(number, row));
  return values;
}

}  // namespace tiprub
