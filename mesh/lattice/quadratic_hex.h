// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "mesh/curves/gauss_points.h"

namespace tiprub {

enum class ElementKind {
  hex20,  ///< serendipity: corners and mid-side nodes
  hex27,  ///< full quadratic: also face centres and the cell's centre
};

inline constexpr int hex27_nodes = 27;
inline constexpr int hex20_nodes = 20;
inline constexpr int hex_corners = 8;

/// Coordinates of the 27 nodes of a cell, one a column [m].
using HexCoordinates = Eigen::Matrix<double, 3, hex27_nodes>;

int node_count(ElementKind kind);

/// Where the nodes of gmsh's hexahedra sit in [-1, 1]^3: 8 corners, 12 mid-sides on the edges 01 03 04 12 15 23 26 37
/// 45 47 56 67, 6 face centres, the centre. A hex20 has the first 20.
const std::array<std::array<int, 3>, hex27_nodes>& hex_reference_nodes();

/// Gives a hex20 the face centres and the centre that its own shape functions imply: -1/4 of a face's corners + 1/2
/// of its mid-sides, and -1/4 of the cell's corners + 1/4 of its mid-sides. So one mapping, the full quadratic one,
/// serves both kinds.
void complete_hex20(HexCoordinates& coordinates);

/// The derivatives of the 27 shape functions at one reference point, 27 x 3.
using HexGradients = Eigen::Matrix<double, hex27_nodes, 3>;
HexGradients hex_gradients(const Eigen::Vector3d& reference);

/// A sample of a cell: its place in the reference cube and its weight in the volume.
struct HexSample {
  Eigen::Vector3d reference;
  double weight;  ///< 0 at corners
  HexGradients gradients;
};

/// The 27 points of the 3 x 3 x 3 Gauss rule and the 8 corners.
const std::vector<HexSample>& hex_samples();

}  // namespace tiprub
