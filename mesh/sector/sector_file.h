// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "mesh/sector/sector_mesher.h"

namespace tiprub::mesh {

/// The contents of a mesh file: nodes, and elements in named groups.
struct NamedMesh {
  struct Entity {
    int dimension;                                     ///< 3 cells, 2 faces, 1 lines
    std::vector<std::string> groups;                   ///< that it is in
    std::map<int, std::vector<std::size_t>> elements;  ///< nodes from 0, in VTK's order; by gmsh's type
  };
  std::vector<Eigen::Vector3d> nodes;  ///< [m]
  std::vector<Entity> entities;        ///< cells first
};

/// The ends of the pieces of a line through these nodes: gmsh's elements of type 1.
std::vector<std::size_t> pieces_of(const std::vector<std::size_t>& line);

/// Writes a mesh as gmsh 4.1 in text. The same mesh gives the same bytes. Raises RunError if the file can't be
/// written.
void write_mesh(const NamedMesh& mesh, const std::filesystem::path& path);

/// The sector with the named groups that mesh/format.md lists.
NamedMesh named_groups(const MeshedSector& mesh);

/// A drawing (SVG) of the surface of a mesh from two sides, which together show both cuts, the tip and a clamped
/// bore: each face in the colour of its group, or else of its part, with its curved edges, and the lines of contact
/// nodes. Faces are drawn from the farthest to the nearest, without those that look away.
std::string picture_of(const NamedMesh& mesh);

}  // namespace tiprub::mesh
