// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/cut_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/reduce/complaint.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub {
namespace {

constexpr double tolerance = 1e-6;

std::string complaint(SectorMesh mesh) {
  return test::complaint<InputError>([&] { pair_cut_faces(mesh, tolerance); });
}

TEST(CutFaces, PairInAnyOrderAndTellTheCount) {
  const SectorMesh expected = test::skewed_annulus(7).sector();
  SectorMesh mesh = expected;
  std::reverse(mesh.cyclic_high.begin(), mesh.cyclic_high.end());
  pair_cut_faces(mesh, tolerance);
  EXPECT_EQ(mesh.sector_count, 7);
  EXPECT_EQ(mesh.cyclic_high, expected.cyclic_high);
}

TEST(CutFaces, SayThatTheyAreExchanged) {
  SectorMesh mesh = test::skewed_annulus(7).sector();
  std::swap(mesh.cyclic_low, mesh.cyclic_high);
  EXPECT_EQ(complaint(mesh),
            "the sector: cyclic_low and cyclic_high are exchanged: cyclic_high must be cyclic_low turned by +360/7 "
            "degrees about z; exchange their names");
}

TEST(CutFaces, NameAnotherAxis) {
  const SectorMesh sector = test::skewed_annulus(7).sector();
  SectorMesh mesh = sector;
  mesh.nodes = sector.nodes(std::array{2, 0, 1}, Eigen::all);  // z becomes x
  EXPECT_EQ(complaint(mesh), "the sector: the wheel turns about x; the axis of rotation must be z: turn the mesh");
  mesh.nodes = sector.nodes(std::array{1, 2, 0}, Eigen::all);  // z becomes y
  std::swap(mesh.cyclic_low, mesh.cyclic_high);
  EXPECT_EQ(complaint(mesh), "the sector: the wheel turns about y; the axis of rotation must be z: turn the mesh");
}

TEST(CutFaces, SayHowManyNodesStandAlone) {
  SectorMesh mesh = test::skewed_annulus(7).sector();
  mesh.nodes.col(mesh.cyclic_high.front()).z() += 1e-3;
  EXPECT_EQ(complaint(mesh).rfind("the sector: 1 of ", 0), 0u) << complaint(mesh);
  EXPECT_NE(complaint(mesh).find("within tolerance; the farthest is 0.001 m from the nearest;"), std::string::npos)
      << complaint(mesh);
}

TEST(CutFaces, SayThatOneIsShifted) {
  SectorMesh mesh = test::skewed_annulus(7).sector();
  for (const int node : mesh.cyclic_high) mesh.nodes.col(node).z() += 1e-3;
  EXPECT_NE(complaint(mesh).find("turned by 360/7 degrees about z and then shifted by x "), std::string::npos)
      << complaint(mesh);
  EXPECT_NE(complaint(mesh).find("z 0.001 m; the axis of rotation must be z through the origin"), std::string::npos)
      << complaint(mesh);
}

}  // namespace
}  // namespace tiprub
