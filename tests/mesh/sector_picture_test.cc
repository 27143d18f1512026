// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sector/sector_file.h"

#include <gtest/gtest.h>

namespace tiprub::mesh {
namespace {

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

/// From either side one sees three faces of a box, in the colours of their groups, dimmed by how they are turned.
TEST(SectorPicture, ShowsThreeFacesOfABoxFromEitherSide) {
  NamedMesh mesh;
  const double corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                               {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const int edge[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                           {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  for (const auto& at : corner) mesh.nodes.emplace_back(5 + at[0], at[1] - 0.5, at[2]);
  for (const auto& [a, b] : edge) mesh.nodes.emplace_back((mesh.nodes[a] + mesh.nodes[b]) / 2);
  std::vector<std::size_t> cell(20);
  for (std::size_t k = 0; k < cell.size(); ++k) cell[k] = k;
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

}  // namespace
}  // namespace tiprub::mesh
