// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reduce/test_rotor.h"

#include <Eigen/SparseCholesky>
#include <cmath>
#include <numbers>

namespace tiprub::reduce::test {

Placement Annulus::placement(double angle) const {
  return [*this, angle](const Eigen::Vector3d& at) -> Eigen::Vector3d {
    const double r = inner + (outer - inner) * at[0] * (1 - grading + grading * at[0]);
    const double theta = angle * at[1] + wrap * at[0] * at[0] + twist * at[2];
    return {r * std::cos(theta), r * std::sin(theta), height * at[2] + coning * at[0] * at[0]};
  };
}

SectorMesh Annulus::sector() const {
  const BrickGrid grid(bricks, nodes_per_brick, Around::open);
  SectorMesh mesh = grid.place(placement(2 * std::numbers::pi / sector_count));
  mesh.sector_count = sector_count;
  mesh.cyclic_low = grid.layer(1, 0);
  mesh.cyclic_high = grid.layer(1, 2 * bricks[1]);
  if (bore == Bore::clamped) mesh.clamped = grid.layer(0, 0);
  for (int k = 0; k <= 2 * bricks[2]; ++k)
    if (const int node = grid.node(2 * bricks[0], bricks[1], k); node >= 0) mesh.contact_line.push_back(node);
  if (bricks[1] >= 4) mesh.tip_faces = grid.outer_faces(1, bricks[1] - 2);
  return mesh;
}

SectorMesh Annulus::wheel() const {
  const BrickGrid grid({bricks[0], sector_count * bricks[1], bricks[2]}, nodes_per_brick, Around::closed);
  SectorMesh mesh = grid.place(placement(2 * std::numbers::pi));
  mesh.sector_count = 1;
  if (bore == Bore::clamped) mesh.clamped = grid.layer(0, 0);
  return mesh;
}

Annulus skewed_annulus(int sector_count) {
  Annulus annulus;
  annulus.sector_count = sector_count;
  annulus.wrap = 0.3;
  annulus.twist = 0.1;
  annulus.coning = 0.02;
  return annulus;
}

Material steel() {
  return {.young = 200e9, .poisson = 0.3, .density = 7800.0};
}

TestRotor::TestRotor(SectorMesh mesh, std::vector<int> contact, const Material& material)
    : mesh_(std::move(mesh)), dofs_(number_dofs(mesh_, contact)), elasticity_(mesh_, dofs_, material) {}

Eigen::Matrix3Xd TestRotor::static_displacement(double speed) {
  if (speed == 0.0) return Eigen::Matrix3Xd::Zero(3, mesh_.node_count());
  // The high face moves as the low one: dof -> the independent dof that it follows.
  const auto independent = [&](int dof) {
    const bool follows = dof >= dofs_.interior + dofs_.face;
    return follows ? dof - dofs_.face : dof;
  };
  Eigen::SparseMatrix<double> T(dofs_.sector(), dofs_.independent());
  T.reserve(Eigen::VectorXi::Constant(dofs_.independent(), 2));
  for (int dof = 0; dof < dofs_.sector(); ++dof) T.insert(dof, independent(dof)) = 1.0;
  const Eigen::SparseMatrix<double> both(at_rest().selfadjointView<Eigen::Lower>());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> K(T.transpose() * both * T);
  const Eigen::VectorXd u = T * K.solve(T.transpose() * elasticity_.centrifugal_load());
  return speed * speed * cartesian_displacement(mesh_, dofs_, u);
}

SymmetricMatrix TestRotor::at_speed(double speed, Prestress prestress) {
  return elasticity_.stiffness(speed, static_displacement(speed), prestress);
}

ProcessGroup& alone() {
  static ProcessGroup group;
  return group;
}

TestRotor tip_rotor(const Annulus& annulus, const Material& material) {
  SectorMesh mesh = annulus.sector();
  const std::vector<int> contact = {mesh.contact_line.front(), mesh.contact_line.back()};
  return TestRotor(std::move(mesh), contact, material);
}

}  // namespace tiprub::reduce::test
