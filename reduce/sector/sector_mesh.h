// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tiprub {

/// One sector of a wheel, as it lies in sector.msh: quadratic bricks and the named groups. The axis of rotation is z.
struct SectorMesh {
  int sector_count = 0;           ///< N, found from the angle between the two cut faces
  Eigen::Matrix3Xd nodes;         ///< [m] x, y, z; 3 x nodes
  Eigen::MatrixXi cells;          ///< node numbers in gmsh's order; 20 or 27 x cells
  std::vector<int> cyclic_low;    ///< nodes of the lower cut face
  std::vector<int> cyclic_high;   ///< the same turned by +2 pi/N: node k stands where cyclic_low[k] comes to lie
  std::vector<int> clamped;       ///< nodes that don't move
  std::vector<int> contact_line;  ///< nodes of the main blade's tip line, from leading to trailing edge
  std::map<std::string, std::vector<int>> parts;  ///< cells of `disc`, `main_blade`, `splitter`, where present
  double pairing_mismatch = 0;                    ///< [m] largest distance between partners on the cut faces

  int node_count() const { return static_cast<int>(nodes.cols()); }
  int cell_count() const { return static_cast<int>(cells.cols()); }
  int nodes_per_cell() const { return static_cast<int>(cells.rows()); }
};

/// Reads a gmsh file with the groups `sector` (volume), `cyclic_low`, `cyclic_high`, `clamped` (surfaces) and
/// `contact` (a curve directed from leading to trailing edge, or points in that order), and the volume groups `disc`,
/// `main_blade`, `splitter` where there are any. `tolerance` is what two
/// partners on the cut faces may differ by, over the largest radius. Raises RunError if the file can't be read,
/// InputError if a group is missing, cells are no quadratic bricks, or the faces don't pair.
SectorMesh read_sector_mesh(const std::filesystem::path& path, double tolerance);

}  // namespace tiprub
