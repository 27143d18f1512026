// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/sector_dofs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "tests/cases/complaint.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce {
namespace {

using test::Annulus;

TEST(SectorDofs, PartsSumToTheTotal) {
  // eq. 5: interior, cut faces, contact nodes.
  for (const int nodes_per_brick : {20, 27}) {
    Annulus annulus;
    annulus.nodes_per_brick = nodes_per_brick;
    const SectorMesh mesh = annulus.sector();
    const SectorDofs dofs = number_dofs(mesh, mesh.contact_line);
    EXPECT_EQ(dofs.interior + dofs.face + dofs.face + dofs.boundary(), dofs.sector());
    EXPECT_EQ(dofs.interior + dofs.face + dofs.boundary(), dofs.independent());
    EXPECT_EQ(dofs.face + dofs.face + dofs.boundary(), dofs.interface());
    EXPECT_EQ(dofs.sector(), 3 * (mesh.node_count() - static_cast<int>(mesh.clamped.size())));
    EXPECT_EQ(dofs.boundary(), 9);
  }
}

TEST(SectorDofs, EachIsNumberedOnceAndInItsPart) {
  // eq. 5: the blocks of Y_s follow from the order.
  const SectorMesh mesh = Annulus().sector();
  const SectorDofs dofs = number_dofs(mesh, mesh.contact_line);
  std::vector<int> numbers;
  for (const int first : dofs.first)
    if (first >= 0)
      for (int d = 0; d < 3; ++d) numbers.push_back(first + d);
  std::sort(numbers.begin(), numbers.end());
  std::vector<int> all(dofs.sector());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(numbers, all);
  for (std::size_t k = 0; k < mesh.cyclic_low.size(); ++k) {
    const int low = dofs.first[mesh.cyclic_low[k]], high = dofs.first[mesh.cyclic_high[k]];
    EXPECT_EQ(low < 0, high < 0);
    if (low < 0) continue;
    EXPECT_GE(low, dofs.interior);
    EXPECT_EQ(high, low + dofs.face);  // partners stand in the same place of their face
  }
  for (std::size_t k = 0; k < dofs.contact.size(); ++k)
    EXPECT_EQ(dofs.first[dofs.contact[k]], dofs.interior + 2 * dofs.face + static_cast<int>(3 * k));
}

TEST(SectorDofs, TheClampWinsOnCutFaces) {
  const SectorMesh mesh = Annulus().sector();
  const SectorDofs dofs = number_dofs(mesh, std::vector<int>{});
  EXPECT_EQ(static_cast<int>(mesh.cyclic_low.size()) - dofs.face / 3,
            3);  // bottom, middle and top of the lower face's bore
  for (const int node : mesh.clamped) EXPECT_EQ(dofs.first[node], -1);
}

TEST(SectorDofs, AClampOnOneCutFaceHoldsThePartner) {
  SectorMesh mesh = Annulus().sector();
  const int free_pair = static_cast<int>(mesh.cyclic_low.size()) - 1;
  mesh.clamped.push_back(mesh.cyclic_high[free_pair]);
  const SectorDofs dofs = number_dofs(mesh, std::vector<int>{});
  EXPECT_EQ(dofs.first[mesh.cyclic_low[free_pair]], -1);
  EXPECT_EQ(dofs.first[mesh.cyclic_high[free_pair]], -1);
  EXPECT_EQ(static_cast<int>(mesh.cyclic_low.size()) - dofs.face / 3, 4);
}

TEST(SectorDofs, RefusesContactOnACutFace) {
  const SectorMesh mesh = Annulus().sector();
  for (const int node : {mesh.cyclic_low.back(), mesh.cyclic_high.back()}) {
    const std::string message = complaint<InputError>([&] { number_dofs(mesh, std::vector<int>{node}); });
    EXPECT_EQ(message, "the sector: the contact node at " + mesh.place_of(node) +
                           " lies on a cyclic face; a contact node must be inside the sector");
  }
}

TEST(SectorDofs, RefusesAClampedContactNode) {
  const SectorMesh mesh = Annulus().sector();
  const auto inside = std::find_if(mesh.clamped.begin(), mesh.clamped.end(), [&](int node) {
    return std::count(mesh.cyclic_low.begin(), mesh.cyclic_low.end(), node) +
               std::count(mesh.cyclic_high.begin(), mesh.cyclic_high.end(), node) ==
           0;
  });
  ASSERT_NE(inside, mesh.clamped.end());
  EXPECT_EQ(complaint<InputError>([&] { number_dofs(mesh, std::vector<int>{*inside}); }),
            "the sector: the contact node at " + mesh.place_of(*inside) + " is clamped; a contact node must be free");
}

TEST(SectorDofs, RefusesAFreeNodeOnTheAxis) {
  SectorMesh mesh = Annulus().sector();
  const int node = mesh.contact_line.front();
  mesh.nodes.col(node).head<2>().setZero();
  EXPECT_EQ(complaint<InputError>([&] { number_dofs(mesh, std::vector<int>{}); }),
            "the sector: the node at " + mesh.place_of(node) +
                " lies on the axis and is free; clamp it, or bore the wheel");
}

TEST(SectorDofs, CylindricalFramesTurnWithTheirPlace) {
  const Eigen::Matrix3d frame = cylindrical_frame({0.0, 2.0, 1.0});
  EXPECT_LT((frame.col(0) - Eigen::Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_LT((frame.col(1) + Eigen::Vector3d::UnitX()).norm(), 1e-15);
  EXPECT_LT((frame.col(2) - Eigen::Vector3d::UnitZ()).norm(), 1e-15);
}

TEST(SectorDofs, NeighboursShareACell) {
  const SectorMesh mesh = Annulus().sector();
  const std::vector<std::vector<int>> neighbours = node_neighbours(mesh);
  for (int node = 0; node < mesh.node_count(); ++node) {
    std::set<int> expected;
    for (int cell = 0; cell < mesh.cell_count(); ++cell) {
      const auto nodes = mesh.cells.col(cell);
      if (std::count(nodes.begin(), nodes.end(), node) > 0) expected.insert(nodes.begin(), nodes.end());
    }
    EXPECT_EQ(neighbours[node], std::vector<int>(expected.begin(), expected.end()));
  }
}

}  // namespace
}  // namespace tiprub::reduce
