// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reduce/brick_grid.h"

#include "mesh/cells/cell_kind.h"

namespace tiprub::reduce::test {

namespace {

using Steps = std::array<int, 3>;

// Faces of 8 or 9 nodes, in half-brick steps around and along the axis.
constexpr std::array<std::array<int, 2>, 9> face_steps = {
    {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}}};

}  // namespace

BrickGrid::BrickGrid(const std::array<int, 3>& bricks, int nodes_per_brick, Around around)
    : bricks_(bricks), nodes_per_brick_(nodes_per_brick), around_(around) {
  int next = 0;
  for (int j = 0; j < steps(1); ++j)
    for (int k = 0; k < steps(2); ++k)
      for (int i = 0; i < steps(0); ++i) {
        const bool exists = nodes_per_brick == 27 || i % 2 + j % 2 + k % 2 <= 1;
        number_.push_back(exists ? next++ : -1);
      }
}

int BrickGrid::steps(int direction) const {
  return 2 * bricks_[direction] + (direction == 1 && around_ == Around::closed ? 0 : 1);
}

int BrickGrid::node(int i, int j, int k) const {
  return number_[(static_cast<std::size_t>(j % steps(1)) * steps(2) + k) * steps(0) + i];
}

std::vector<int> BrickGrid::layer(int direction, int step) const {
  std::vector<int> nodes;
  for (int j = 0; j < steps(1); ++j)
    for (int k = 0; k < steps(2); ++k)
      for (int i = 0; i < steps(0); ++i)
        if (Steps{i, j, k}[direction] == step && node(i, j, k) >= 0) nodes.push_back(node(i, j, k));
  return nodes;
}

Eigen::MatrixXi BrickGrid::outer_faces(int first, int count) const {
  Eigen::MatrixXi faces(nodes_per_brick_ == 27 ? 9 : 8, count * bricks_[2]);
  for (int face = 0; face < faces.cols(); ++face)
    for (Eigen::Index n = 0; n < faces.rows(); ++n)
      faces(n, face) =
          node(2 * bricks_[0], 2 * (first + face % count) + face_steps[n][0], 2 * (face / count) + face_steps[n][1]);
  return faces;
}

SectorMesh BrickGrid::place(const Placement& placement) const {
  SectorMesh mesh;
  int count = 0;
  for (const int number : number_) count += number >= 0;
  mesh.nodes.resize(3, count);
  for (int j = 0; j < steps(1); ++j)
    for (int k = 0; k < steps(2); ++k)
      for (int i = 0; i < steps(0); ++i)
        if (const int at = node(i, j, k); at >= 0)
          mesh.nodes.col(at) = placement({i / (2.0 * bricks_[0]), j / (2.0 * bricks_[1]), k / (2.0 * bricks_[2])});
  mesh.cells.resize(nodes_per_brick_, bricks_[0] * bricks_[1] * bricks_[2]);
  const CellKind& kind = cell_kind(nodes_per_brick_);
  int cell = 0;
  for (int j = 0; j < bricks_[1]; ++j)
    for (int k = 0; k < bricks_[2]; ++k)
      for (int i = 0; i < bricks_[0]; ++i, ++cell)
        for (int n = 0; n < nodes_per_brick_; ++n) {
          const Eigen::Vector3i step = kind.places[n].cast<int>();
          mesh.cells(n, cell) = node(2 * i + 1 + step[0], 2 * j + 1 + step[1], 2 * k + 1 + step[2]);
        }
  return mesh;
}

}  // namespace tiprub::reduce::test
