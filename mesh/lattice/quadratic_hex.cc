// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/lattice/quadratic_hex.h"

#include <cmath>
#include <cstdlib>

namespace tiprub {

namespace {

struct Lagrange {
  std::array<double, 3> value;  ///< of the functions that are 1 at -1, 0, 1
  std::array<double, 3> derivative;
};

Lagrange lagrange(double x) {
  return {{0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0)}, {x - 0.5, -2.0 * x, x + 0.5}};
}

int odd_directions(const std::array<int, 3>& node) {
  int count = 0;
  for (int coordinate : node) count += coordinate == 0 ? 1 : 0;
  return count;
}

// Whether a node lies on the face or in the cell whose centre is given: it shares the centre's non-zero coordinates.
bool touches(const std::array<int, 3>& node, const std::array<int, 3>& centre) {
  for (int d = 0; d < 3; ++d)
    if (centre[d] != 0 && node[d] != centre[d]) return false;
  return true;
}

std::vector<HexSample> make_samples() {
  std::vector<HexSample> samples;
  const auto add = [&](const Eigen::Vector3d& at, double weight) {
    samples.push_back({at, weight, hex_gradients(at)});
  };
  for (const GaussPoint& a : gauss_3)
    for (const GaussPoint& b : gauss_3)
      for (const GaussPoint& c : gauss_3) add({a.x, b.x, c.x}, a.weight * b.weight * c.weight);
  for (int n = 0; n < hex_corners; ++n) {
    const auto& corner = hex_reference_nodes()[n];
    add({double(corner[0]), double(corner[1]), double(corner[2])}, 0.0);
  }
  return samples;
}

}  // namespace

int node_count(ElementKind kind) {
  return kind == ElementKind::hex20 ? hex20_nodes : hex27_nodes;
}

const std::array<std::array<int, 3>, hex27_nodes>& hex_reference_nodes() {
  static constexpr std::array<std::array<int, 3>, hex27_nodes> nodes = {
      {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1},  {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1},
       {-1, 1, 1},   {0, -1, -1}, {-1, 0, -1}, {-1, -1, 0}, {1, 0, -1},  {1, -1, 0}, {0, 1, -1},
       {1, 1, 0},    {-1, 1, 0},  {0, -1, 1},  {-1, 0, 1},  {1, 0, 1},   {0, 1, 1},  {0, 0, -1},
       {0, -1, 0},   {-1, 0, 0},  {1, 0, 0},   {0, 1, 0},   {0, 0, 1},   {0, 0, 0}}};
  return nodes;
}

void complete_hex20(HexCoordinates& coordinates) {
  const auto& nodes = hex_reference_nodes();
  for (int n = hex20_nodes; n < hex27_nodes; ++n) {
    const double mid_side_weight = odd_directions(nodes[n]) == 2 ? 0.5 : 0.25;  // a face's, the cell's
    coordinates.col(n).setZero();
    for (int m = 0; m < hex20_nodes; ++m)
      if (touches(nodes[m], nodes[n]))
        coordinates.col(n) += (m < hex_corners ? -0.25 : mid_side_weight) * coordinates.col(m);
  }
}

HexGradients hex_gradients(const Eigen::Vector3d& reference) {
  const std::array<Lagrange, 3> along = {lagrange(reference[0]), lagrange(reference[1]), lagrange(reference[2])};
  HexGradients gradients;
  for (int n = 0; n < hex27_nodes; ++n) {
    const auto& node = hex_reference_nodes()[n];
    for (int d = 0; d < 3; ++d) {
      double product = 1.0;
      for (int e = 0; e < 3; ++e) product *= e == d ? along[e].derivative[node[e] + 1] : along[e].value[node[e] + 1];
      gradients(n, d) = product;
    }
  }
  return gradients;
}

const std::vector<HexSample>& hex_samples() {
  static const std::vector<HexSample> samples = make_samples();
  return samples;
}

}  // namespace tiprub
