// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sector/sector_file.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tiprub::mesh {
namespace {

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

/// Adds the nodes of a cell that is not in the mesh yet; a cube at this height.
std::vector<std::size_t> cube(NamedMesh& mesh, double height) {
  const double corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                               {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const int edge[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                           {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  std::vector<Eigen::Vector3d> places;
  for (const auto& at : corner) places.emplace_back(5 + at[0], at[1] - 0.5, at[2] + height);
  for (const auto& [a, b] : edge) places.emplace_back((places[a] + places[b]) / 2);
  std::vector<std::size_t> cell;
  for (const Eigen::Vector3d& at : places) {
    const auto known = std::find(mesh.nodes.begin(), mesh.nodes.end(), at);
    cell.push_back(static_cast<std::size_t>(known - mesh.nodes.begin()));
    if (known == mesh.nodes.end()) mesh.nodes.push_back(at);
  }
  return cell;
}

/// From either side one sees three faces of a box, in the colours of their groups, dimmed by how they are turned.
TEST(SectorPicture, ShowsThreeFacesOfABoxFromEitherSide) {
  NamedMesh mesh;
  const std::vector<std::size_t> cell = cube(mesh, 0);
  mesh.entities = {{3, {"sector", "disc"}, {{17, cell}}},
                   {2, {"clamped"}, {{16, {0, 4, 7, 3, 16, 15, 19, 11}}}},
                   {2, {"blade_tip"}, {{16, {1, 2, 6, 5, 9, 18, 13, 17}}}},
                   {1, {"contact"}, {{1, {1, 17, 17, 5}}}}};
  const std::string picture = picture_of(mesh);
  EXPECT_EQ(count(picture, "<path fill="), 6U);
  EXPECT_EQ(count(picture, "stroke-width=\"3\"/>"), 1U);
  EXPECT_EQ(count(picture, "<path d=\"M"), 5U);  // two pieces of the line in either view, and one in the legend
  for (const char* words : {"clamped: 1 faces", "blade_tip: 1 faces", "disc: 4 faces", "contact: 3 nodes"})
    EXPECT_EQ(count(picture, words), 1U) << words;
}

/// Symptom: a face was of the part that came last among those at one of its edges.
TEST(SectorPicture, FacesAtTheBorderOfTwoPartsAreOfTheirOwnCells) {
  NamedMesh mesh;
  const std::vector<std::size_t> below = cube(mesh, 0), above = cube(mesh, 1);
  mesh.entities = {{3, {"sector", "disc"}, {{17, above}}}, {3, {"sector", "main_blade"}, {{17, below}}}};
  const std::string picture = picture_of(mesh);
  for (const char* words : {"disc: 5 faces", "main_blade: 5 faces"}) EXPECT_EQ(count(picture, words), 1U) << words;
}

}  // namespace
}  // namespace tiprub::mesh
