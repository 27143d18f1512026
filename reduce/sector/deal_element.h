// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe.h>

#include <Eigen/Dense>
#include <memory>
#include <optional>
#include <vector>

#include "mesh/cells/cell_kind.h"
#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// A kind of cell as an element of deal.II: its geometry, which is quadratic, and its displacements.
struct DealElement {
  const CellKind* kind;
  std::shared_ptr<const dealii::FiniteElement<3>> geometry, displacement;
  dealii::Quadrature<3> points;
  Eigen::MatrixXd from_nodes;  ///< [1] the values of the geometry's dofs from the nodes, by multiples of a quarter
  std::vector<int> node;       ///< of each dof of the geometry; `no_node` where the kind has none
  Eigen::MatrixXd from_cubic;  ///< [1] the values of cubic displacements' dofs from the functions of cubic_shape()
};
constexpr int no_node = -1;

/// The element of a kind of cell; none for pyramids. Only bricks have cubic displacements.
std::optional<DealElement> deal_element(const CellKind& kind, Degree degree);

}  // namespace tiprub::reduce
