// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/refinement.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/cases/complaint.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/split_cells.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce::refinement_test {
namespace {

using test::Annulus;

double volume_of(const SectorMesh& mesh) {
  double volume = 0;
  FiniteElements(mesh).visit([&](const CellPoints& points) { volume += points.weight.sum(); });
  return volume;
}

SectorMesh sector_of(int nodes_per_brick) {
  Annulus annulus = test::skewed_annulus(5);
  annulus.nodes_per_brick = nodes_per_brick;
  return annulus.sector();
}

class Refined : public ::testing::TestWithParam<test::Split> {
 protected:
  const SectorMesh coarse_ = test::split(sector_of(27), GetParam()), fine_ = refined(coarse_);
};
INSTANTIATE_TEST_SUITE_P(Kinds, Refined,
                         ::testing::Values(test::Split::tet10, test::Split::wedge15, test::Split::hex20));

TEST_P(Refined, FillsTheSameSpaceWithEightTimesTheCells) {
  // Not one volume for the other: a rule of 9 or 4 points doesn't integrate that of a curved cell exactly.
  EXPECT_EQ(fine_.cell_count(), 8 * coarse_.cell_count());
  EXPECT_NEAR(volume_of(fine_) / volume_of(coarse_), 1.0, 1e-3);
  EXPECT_TRUE(fine_.nodes.leftCols(coarse_.node_count()) == coarse_.nodes);
}

TEST_P(Refined, KeepsTheGroups) {
  const double angle = 2 * std::numbers::pi / coarse_.sector_count;
  ASSERT_EQ(fine_.cyclic_low.size(), fine_.cyclic_high.size());
  EXPECT_GT(fine_.cyclic_low.size(), 2 * coarse_.cyclic_low.size());
  const Eigen::AngleAxisd turn(angle, Eigen::Vector3d::UnitZ());
  for (std::size_t k = 0; k < fine_.cyclic_low.size(); ++k)
    EXPECT_LT((turn * fine_.nodes.col(fine_.cyclic_low[k]) - fine_.nodes.col(fine_.cyclic_high[k])).norm(), 1e-12);
  for (const int node : fine_.clamped) EXPECT_NEAR(fine_.nodes.col(node).head<2>().norm(), 0.1, 1e-3);
  EXPECT_EQ(fine_.contact_line, coarse_.contact_line);
}

Eigen::VectorXd lowest_frequencies(const SectorMesh& mesh) {
  test::TestRotor rotor(mesh, {mesh.contact_line.front()});
  return test::generalized_eigenvalues(test::dense(rotor.at_rest()), test::dense(rotor.mass())).head(6).cwiseSqrt();
}

TEST(Refinement, OfBricksLowersEachFrequency) {
  // Rayleigh-Ritz: the displacements of the given mesh are among those of the refined one.
  test::Annulus annulus;
  annulus.bricks = {1, 2, 1};
  for (const int nodes : {20, 27}) {
    annulus.nodes_per_brick = nodes;
    const SectorMesh coarse = annulus.sector();
    const Eigen::VectorXd before = lowest_frequencies(coarse), after = lowest_frequencies(refined(coarse));
    for (Eigen::Index k = 0; k < before.size(); ++k) {
      EXPECT_LT(after[k], before[k]);
      EXPECT_GT(after[k], 0.7 * before[k]);
    }
  }
}

TEST(Refinement, RepeatsTheGeometryOfBricksToTheLastDigit) {
  for (const int nodes : {20, 27}) {
    const SectorMesh coarse = sector_of(nodes), fine = refined(coarse);
    EXPECT_NEAR(volume_of(fine) / volume_of(coarse), 1.0, 1e-13);
  }
}

TEST(Refinement, SplitsTheTipsFaces) {
  Annulus annulus = test::skewed_annulus(5);
  annulus.bricks = {1, 4, 1};
  for (const int nodes : {20, 27}) {
    annulus.nodes_per_brick = nodes;
    const SectorMesh coarse = annulus.sector(), fine = refined(coarse);
    EXPECT_EQ(fine.tip_faces.cols(), 4 * coarse.tip_faces.cols());
    for (const int node : fine.tip_faces.reshaped())
      EXPECT_NEAR(fine.nodes.col(node).head<2>().norm(), annulus.outer, 1e-3);
  }
}

TEST(Refinement, RefusesPyramids) {
  const SectorMesh mesh = test::split(sector_of(27), test::Split::pyramid13);
  EXPECT_EQ(complaint<InputError>([&] { refined(mesh); }),
            "the sector: cell 0 is a pyramid, which [reduce] refine can't split; leave refine at 0");
}

}  // namespace
}  // namespace tiprub::reduce::refinement_test
