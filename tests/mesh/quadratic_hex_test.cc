// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/lattice/quadratic_hex.h"

#include <gmsh.h>
#include <gtest/gtest.h>

#include <Eigen/LU>

namespace tiprub {
namespace {

double quadratic(const Eigen::Vector3d& x) {
  return 1.0 + x[0] - 2.0 * x[1] + x[0] * x[2] + x[1] * x[1] - 0.5 * x[2] * x[2] + x[0] * x[1];
}

HexCoordinates reference_cell() {
  HexCoordinates cell;
  for (int n = 0; n < hex27_nodes; ++n)
    for (int d = 0; d < 3; ++d) cell(d, n) = hex_reference_nodes()[n][d];
  return cell;
}

TEST(QuadraticHex, NodesAreOrderedLikeGmshs) {
  gmsh::initialize(0, nullptr, false);
  for (const int type : {17, 12}) {
    std::string name;
    int dimension, order, nodes, corners;
    std::vector<double> local;
    gmsh::model::mesh::getElementProperties(type, name, dimension, order, nodes, local, corners);
    ASSERT_EQ(nodes, type == 17 ? hex20_nodes : hex27_nodes);
    for (int n = 0; n < nodes; ++n)
      for (int d = 0; d < 3; ++d) EXPECT_EQ(local[3 * n + d], hex_reference_nodes()[n][d]) << type << " node " << n;
  }
  gmsh::finalize();
}

TEST(QuadraticHex, CompletionReproducesQuadratics) {
  HexCoordinates values = HexCoordinates::Zero();
  for (int n = 0; n < hex20_nodes; ++n) values(0, n) = quadratic(reference_cell().col(n));
  complete_hex20(values);
  for (int n = hex20_nodes; n < hex27_nodes; ++n)
    EXPECT_NEAR(values(0, n), quadratic(reference_cell().col(n)), 1e-14) << n;
}

TEST(QuadraticHex, MapsTheReferenceCellToItself) {
  double volume = 0.0;
  for (const HexSample& sample : hex_samples()) {
    const Eigen::Matrix3d jacobian = reference_cell() * sample.gradients;
    EXPECT_NEAR((jacobian - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-14);
    volume += sample.weight * jacobian.determinant();
  }
  EXPECT_NEAR(volume, 8.0, 1e-13);
}

}  // namespace
}  // namespace tiprub
