// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/linear_results.h"

#include <gtest/gtest.h>

#include <numbers>
#include <sstream>

#include "reduce/model/dense_eigen.h"
#include "reduce/model/hdf5_file.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce {
namespace {

using test::TestRotor;

constexpr int sectors = 5, modes = 6;

ReductionParameters parameters() {
  ReductionParameters p;
  p.material = test::steel();
  p.speed_max = 3000.0;
  p.contact_nodes = 2;
  p.verification_speeds = {0.0, 0.5, 1.0};
  p.verification_modes = modes;
  return p;
}

/// Cells 0 and 1 are the disc, the others the blade.
SectorMesh mesh_of_two_parts() {
  SectorMesh mesh = test::skewed_annulus(sectors).sector();
  mesh.parts["disc"] = {0, 1};
  for (int cell = 2; cell < mesh.cell_count(); ++cell) mesh.parts["main_blade"].push_back(cell);
  return mesh;
}

class Results : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { results_ = new LinearResults(linear_results(mesh_of_two_parts(), parameters())); }
  static void TearDownTestSuite() { delete results_; }
  static LinearResults* results_;
};
LinearResults* Results::results_ = nullptr;

TEST_F(Results, HoldTheFrequenciesOfTheDenseProblem) {
  TestRotor rotor = test::tip_rotor(test::skewed_annulus(sectors));
  for (int row = 0; row < 3; ++row) {
    const SymmetricMatrix K = rotor.at_speed(results_->speeds[row], Prestress::linear), M = rotor.mass();
    for (int n = 0; n <= sectors / 2; ++n) {
      const Eigen::VectorXd squares = test::generalized_eigenvalues(test::cyclic(K, rotor.dofs(), sectors, n),
                                                                    test::cyclic(M, rotor.dofs(), sectors, n));
      for (int k = 0; k < modes; ++k)
        EXPECT_NEAR(results_->nodal_diameters[n].frequency(row, k) * 2 * std::numbers::pi / std::sqrt(squares[k]),
                    1.0, 1e-9);
    }
  }
}

TEST_F(Results, ShareAllOfTheStrainEnergy) {
  ASSERT_EQ(results_->parts, (std::vector<std::string>{"disc", "main_blade"}));
  for (const ModesOverSpeed& of : results_->nodal_diameters) {
    EXPECT_LT((of.energy_share[0] + of.energy_share[1] - Eigen::MatrixXd::Ones(3, modes)).cwiseAbs().maxCoeff(),
              1e-12);
    EXPECT_GT(of.energy_share[0].minCoeff(), 0.0);
    EXPECT_GT(of.energy_share[1].minCoeff(), 0.0);
  }
  // The strain of a mode at rest is its frequency: phi' K phi = omega^2, part by part.
  TestRotor rotor = test::tip_rotor(test::skewed_annulus(sectors));
  const Eigen::MatrixXcd K = test::cyclic(rotor.elasticity().stiffness_of({0, 1}), rotor.dofs(), sectors, 1);
  const Eigen::MatrixXcd all = test::cyclic(rotor.at_rest(), rotor.dofs(), sectors, 1);
  const Eigen::MatrixXcd M = test::cyclic(rotor.mass(), rotor.dofs(), sectors, 1);
  const ComplexEigenpairs solved = eigenpairs(all, M);
  // The shapes are found to 1e-5, see mode_tolerance.
  for (int k = 0; k < modes; ++k) {
    const Eigen::VectorXcd shape = solved.vectors.col(k);
    const double share = shape.dot(K * shape).real() / solved.values[k];
    EXPECT_NEAR(results_->nodal_diameters[1].energy_share[0](0, k), share, 1e-5);
  }
}

TEST_F(Results, FollowEveryModeOnce) {
  for (const ModesOverSpeed& of : results_->nodal_diameters)
    for (int row = 0; row < 3; ++row) {
      Eigen::VectorXi branches = of.branch.row(row);
      std::sort(branches.begin(), branches.end());
      for (int k = 1; k < modes; ++k) EXPECT_LT(branches[k - 1], branches[k]);
      EXPECT_GE(branches[modes - 1], modes - 1);
      EXPECT_GE(of.mac.row(row).minCoeff(), 0.5);
      EXPECT_LE(of.mac.row(row).maxCoeff(), 1 + 1e-9);
    }
}

TEST_F(Results, FollowModesThroughACrossing) {
  // A thin plate: bending stiffens under spin, torsion in its plane softens; so branches change places.
  test::Annulus plate;
  plate.sector_count = 12;
  plate.bricks = {4, 1, 1};
  plate.height = 0.008;
  SectorMesh mesh = plate.sector();
  ReductionParameters p = parameters();
  p.speed_max = 6000.0;
  p.verification_speeds = {0.0, 0.2, 0.4, 0.6, 0.8, 1.0};
  const LinearResults found = linear_results(mesh, p);
  int crossings = 0;
  for (const ModesOverSpeed& of : found.nodal_diameters)
    for (Eigen::Index row = 1; row < of.branch.rows(); ++row)
      for (int k = 1; k < modes; ++k) crossings += of.branch(row, k) < of.branch(row, k - 1);
  EXPECT_GT(crossings, 0);
}

TEST_F(Results, HoldTheStaticState) {
  TestRotor rotor = test::tip_rotor(test::skewed_annulus(sectors));
  EXPECT_EQ(results_->displacement.row(0).maxCoeff(), 0.0);
  EXPECT_EQ(results_->von_mises.row(0).maxCoeff(), 0.0);
  const Eigen::Matrix3Xd u = rotor.static_displacement(3000.0);
  EXPECT_NEAR(results_->displacement.row(2).maxCoeff() / u.colwise().norm().maxCoeff(), 1.0, 1e-9);
  EXPECT_NEAR(results_->von_mises.row(2).maxCoeff() / rotor.elasticity().von_mises(u, Prestress::linear).maxCoeff(),
              1.0, 1e-9);
  // Linear: a quarter of the displacement at half the speed; the tip goes outwards.
  EXPECT_LT((results_->clearance_loss.row(2) - 4 * results_->clearance_loss.row(1)).norm(),
            1e-12 * results_->clearance_loss.row(2).norm());
  EXPECT_GT(results_->clearance_loss.row(2).minCoeff(), 0.0);
  EXPECT_EQ(results_->tip_arc_length.size(), results_->clearance_loss.cols());
}

TEST_F(Results, ArePrintedAsThreeTables) {
  std::ostringstream out;
  print(out, *results_);
  const std::string text = out.str();
  const auto lines = std::count(text.begin(), text.end(), '\n');
  const auto tip = results_->tip_arc_length.size();
  EXPECT_EQ(lines, 1 + 3 * 3 * modes + 2 + 3 * 2 + 2 + 3 * tip);
  EXPECT_EQ(text.rfind("speed_rpm nodal_diameter mode frequency_hz branch mac energy_disc energy_main_blade\n", 0),
            0u);
  EXPECT_NE(text.find("\n\nspeed_rpm part displacement_m von_mises_pa\n"), std::string::npos);
  EXPECT_NE(text.find("\n\nspeed_rpm tip_arc_length_m clearance_loss_m\n"), std::string::npos);
}

TEST_F(Results, AreWritten) {
  const auto path = std::filesystem::path(::testing::TempDir()) / "modes.h5";
  write_linear_results(*results_, path, "test", "case");
  const Hdf5File file = Hdf5File::open(path);
  file.require_schema("tiprub-modes", 1);
  EXPECT_EQ(file.read_matrix("/nodal_diameter/1/frequency"), results_->nodal_diameters[1].frequency);
  EXPECT_EQ(file.read_matrix("/nodal_diameter/2/energy_share/disc"), results_->nodal_diameters[2].energy_share[0]);
  EXPECT_EQ(file.read_vector("/static/von_mises/main_blade"), results_->von_mises.col(1));
  EXPECT_EQ(file.read_matrix("/tip/clearance_loss"), results_->clearance_loss);
}

}  // namespace
}  // namespace tiprub::reduce
