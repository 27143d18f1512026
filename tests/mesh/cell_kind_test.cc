// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cells/cell_kind.h"

#include <gmsh.h>
#include <gtest/gtest.h>

namespace tiprub::mesh {
namespace {

/// Where gmsh has the nodes of its reference cell, in our cell of the same kind: its pyramid stands on z = 0.
Eigen::Matrix3Xd places_by_gmsh(const CellKind& kind) {
  std::string name;
  int dimension = 0, order = 0, nodes = 0, corners = 0;
  std::vector<double> local;
  gmsh::model::mesh::getElementProperties(kind.gmsh_type, name, dimension, order, nodes, local, corners);
  EXPECT_EQ(nodes, kind.nodes());
  EXPECT_EQ(corners, kind.corners);
  Eigen::Matrix3Xd places = Eigen::Map<const Eigen::Matrix3Xd>(local.data(), 3, nodes);
  if (kind.name == "pyramid13") places.row(2).array() -= 1;
  return places;
}

TEST(CellKind, KnowsWhereItsNodesStandInGmshsOrder) {
  gmsh::initialize(0, nullptr, false);
  for (const CellKind& kind : all_cell_kinds()) {
    const Eigen::Matrix3Xd places = places_by_gmsh(kind);
    for (std::size_t k = 0; k < kind.places.size(); ++k)
      EXPECT_EQ(Eigen::Vector3d(places.col(kind.gmsh_node[k])), kind.places[k]) << kind.name << " node " << k;
  }
  gmsh::finalize();
}

TEST(CellKind, ReproducesItsReferenceCell) {
  for (const CellKind& kind : all_cell_kinds()) {
    Eigen::Matrix3Xd places(3, kind.nodes());
    for (int k = 0; k < kind.nodes(); ++k) places.col(k) = kind.places[static_cast<std::size_t>(k)];
    for (const ReferencePoint& point : kind.integration) {
      EXPECT_LT((places * kind.shape(point.at) - point.at).norm(), 1e-14) << kind.name;
      EXPECT_LT((places * kind.gradient(point.at) - Eigen::Matrix3d::Identity()).norm(), 1e-13) << kind.name;
    }
  }
}

}  // namespace
}  // namespace tiprub::mesh
