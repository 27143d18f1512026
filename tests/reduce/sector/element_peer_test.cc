// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "mesh/cells/cell_kind.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/split_cells.h"
#include "tests/reduce/test_rotor.h"

// K, M and the forces of deal.II's assembly against a plain one, which shares nothing with it but the mesh: shape
// functions and integration points are those of the tables of cell_kind.h, and stress works on tensors, without B.

namespace tiprub::reduce {
namespace {

/// A displacement at all nodes and one cell's part of it at an integration point.
struct Motion {
  Motion(const Eigen::Matrix3Xd& nodal, const Eigen::VectorXd& N, const Eigen::MatrixX3d& slopes)
      : value(nodal * N), gradient(nodal * slopes) {}
  Eigen::Vector3d value;
  Eigen::Matrix3d gradient;
};

Eigen::Matrix3d symmetric(const Eigen::Matrix3d& H) {
  return 0.5 * (H + H.transpose());
}

Eigen::Matrix3d stress_of(const Eigen::Matrix3d& strain, const Material& material) {
  const double shear = material.young / (2 * (1 + material.poisson));
  const double lame = 2 * shear * material.poisson / (1 - 2 * material.poisson);
  return lame * strain.trace() * Eigen::Matrix3d::Identity() + 2 * shear * strain;
}

/// Sums `integrand(N, grad N, position)`, a force of x, y, z for each node of a cell, over all cells.
template <class Integrand>
Eigen::Matrix3Xd integrated(const SectorMesh& mesh, const Integrand& integrand) {
  Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, mesh.node_count());
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto nodes = nodes_of(mesh.cells, cell);
    const CellKind& kind = cell_kind(static_cast<int>(nodes.size()));
    const Eigen::Matrix3Xd places = mesh.nodes(Eigen::all, nodes);
    for (const ReferencePoint& point : kind.integration) {
      const Eigen::VectorXd N = kind.shape(point.at);
      const Eigen::Matrix3d jacobian = places * kind.gradient(point.at);
      const Eigen::MatrixX3d slopes = kind.gradient(point.at) * jacobian.inverse();
      const Eigen::Matrix3Xd forces =
          point.weight * jacobian.determinant() * integrand(nodes, N, slopes, Eigen::Vector3d(places * N));
      for (Eigen::Index a = 0; a < nodes.size(); ++a) sum.col(nodes[a]) += forces.col(a);
    }
  }
  return sum;
}

struct Case {
  const char* name;
  std::function<SectorMesh()> mesh;
};

test::Annulus annulus(int nodes_per_brick) {
  test::Annulus annulus = test::skewed_annulus(5);
  annulus.nodes_per_brick = nodes_per_brick;
  annulus.bore = test::Bore::free;
  return annulus;
}

/// Each brick begins at another of its corners than the one before: turned about its axis from 0 to 3.
SectorMesh turned_bricks(int nodes_per_brick) {
  SectorMesh mesh = annulus(nodes_per_brick).sector();
  const CellKind& kind = cell_kind(nodes_per_brick);
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const Eigen::VectorXi before = mesh.cells.col(cell);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(cell % 4 * std::numbers::pi / 2, Eigen::Vector3d::UnitX()).toRotationMatrix();
    for (int node = 0; node < kind.nodes(); ++node)
      for (int other = 0; other < kind.nodes(); ++other)
        if ((turn * kind.places[node] - kind.places[other]).norm() < 0.1) mesh.cells(node, cell) = before[other];
  }
  return mesh;
}

Case cut(const char* name, test::Split into) {
  return {name, [into] { return test::split(annulus(27).sector(), into); }};
}

class EveryCell : public ::testing::TestWithParam<Case> {
 protected:
  EveryCell() : rotor_(mesh(), {}) { displacement_ = 1e-5 * test::arbitrary(3, rotor_.mesh().node_count()).real(); }
  static SectorMesh mesh() { return GetParam().mesh(); }

  Eigen::VectorXd on_dofs(const Eigen::Matrix3Xd& nodal) const {
    Eigen::VectorXd values(rotor_.dofs().sector());
    for (int node = 0; node < rotor_.mesh().node_count(); ++node)
      values.segment<3>(rotor_.dofs().first[node]) =
          cylindrical_frame(rotor_.mesh().nodes.col(node)).transpose() * nodal.col(node);
    return values;
  }
  /// To 1e-12, on ten vectors.
  template <class Integrand>
  void expect_action(const SymmetricMatrix& matrix, const Integrand& integrand) const {
    for (int k = 0; k < 10; ++k) {
      const Eigen::VectorXd x = Eigen::VectorXd::Random(rotor_.dofs().sector());
      const Eigen::Matrix3Xd moved = cartesian_displacement(rotor_.mesh(), rotor_.dofs(), x);
      const Eigen::VectorXd peer = on_dofs(integrated(
          rotor_.mesh(), [&](const auto& nodes, const auto& N, const auto& slopes, const Eigen::Vector3d&) {
            return integrand(nodes, Motion(moved(Eigen::all, nodes), N, slopes), N, slopes);
          }));
      EXPECT_LT((matrix.selfadjointView<Eigen::Lower>() * x - peer).norm(), 1e-12 * peer.norm());
    }
  }

  test::TestRotor rotor_;
  Eigen::Matrix3Xd displacement_;  // [m] some shape under spin
  const Material material_ = test::steel();
};
INSTANTIATE_TEST_SUITE_P(Kinds, EveryCell,
                         ::testing::Values(Case{"hex20", [] { return annulus(20).sector(); }},
                                           Case{"hex27", [] { return annulus(27).sector(); }},
                                           Case{"turned_hex20", [] { return turned_bricks(20); }},
                                           Case{"turned_hex27", [] { return turned_bricks(27); }},
                                           cut("tet10", test::Split::tet10), cut("wedge15", test::Split::wedge15),
                                           cut("pyramid13", test::Split::pyramid13),
                                           cut("bricks_and_pyramids", test::Split::mixed),
                                           cut("bricks_and_wedges", test::Split::bricks_and_wedges)),
                         [](const auto& given) { return given.param.name; });

TEST_P(EveryCell, HasTheMassOfAPlainAssembly) {
  expect_action(rotor_.mass(), [&](const auto&, const Motion& x, const auto& N, const auto&) -> Eigen::Matrix3Xd {
    return material_.density * x.value * N.transpose();
  });
}

TEST_P(EveryCell, HasTheTangentOfAPlainAssembly) {
  const double speed = 3000.0;
  for (const Prestress prestress : {Prestress::stress_only, Prestress::linear, Prestress::nonlinear})
    expect_action(rotor_.elasticity().stiffness(speed, displacement_, prestress),
                  [&](const auto& nodes, const Motion& x, const auto& N, const auto& slopes) -> Eigen::Matrix3Xd {
                    const Eigen::Matrix3d H = Motion(displacement_(Eigen::all, nodes), N, slopes).gradient;
                    Eigen::Matrix3d F = Eigen::Matrix3d::Identity(), strain = symmetric(H);
                    if (prestress != Prestress::stress_only) F += H;
                    if (prestress == Prestress::nonlinear) strain += 0.5 * H.transpose() * H;
                    const Eigen::Matrix3d S = stress_of(strain, material_);
                    const Eigen::Matrix3d dS = stress_of(symmetric(F.transpose() * x.gradient), material_);
                    const Eigen::Vector3d softened(x.value[0], x.value[1], 0);
                    return (F * dS + x.gradient * S) * slopes.transpose() -
                           speed * speed * material_.density * softened * N.transpose();
                  });
}

TEST_P(EveryCell, HasTheForcesOfAPlainAssembly) {
  const Eigen::VectorXd load = on_dofs(
      integrated(rotor_.mesh(), [&](const auto& nodes, const auto& N, const auto& slopes, Eigen::Vector3d radius) {
        radius += Motion(displacement_(Eigen::all, nodes), N, slopes).value;
        radius[2] = 0;
        return Eigen::Matrix3Xd(material_.density * radius * N.transpose());
      }));
  EXPECT_LT((rotor_.elasticity().centrifugal_load(displacement_) - load).norm(), 1e-12 * load.norm());
  const Eigen::VectorXd internal = on_dofs(
      integrated(rotor_.mesh(), [&](const auto& nodes, const auto& N, const auto& slopes, const Eigen::Vector3d&) {
        const Eigen::Matrix3d H = Motion(displacement_(Eigen::all, nodes), N, slopes).gradient;
        const Eigen::Matrix3d S = stress_of(symmetric(H + 0.5 * H.transpose() * H), material_);
        return Eigen::Matrix3Xd((Eigen::Matrix3d::Identity() + H) * S * slopes.transpose());
      }));
  EXPECT_LT((rotor_.elasticity().internal_force(displacement_) - internal).norm(), 1e-12 * internal.norm());
}

}  // namespace
}  // namespace tiprub::reduce
