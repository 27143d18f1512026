// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "mesh/wheels/wheel.h"

namespace tiprub::mesh {

/// A hexahedron and where it sits in the lattice, all counted from 0.
struct SectorCell {
  Region region;
  int station;                     ///< from leading to trailing edge
  int column;                      ///< round the sector
  int layer;                       ///< from bore or back face to hub, and on to the tip
  std::vector<std::size_t> nodes;  ///< in VTK's order
};

/// A named surface: faces of 8 nodes (hex20) or 9 (hex27), corners around, mid-sides, centre; normals outward.
struct SectorSurface {
  std::string name;
  std::vector<std::size_t> face_nodes;  ///< faces x 8 or 9
};

/// One sector, in memory.
struct MeshedSector {
  ElementKind element;
  int sector_count;                    ///< N
  std::vector<Eigen::Vector3d> nodes;  ///< [m], axis of rotation z
  std::vector<SectorCell> cells;
  std::vector<SectorSurface> surfaces;
  std::vector<std::size_t> contact;           ///< leading to trailing edge, on the main blade's tip
  std::vector<std::size_t> contact_splitter;  ///< likewise on the splitter's; empty unless the case asks for it

  const CellKind& kind() const { return cell_kind(static_cast<int>(element)); }
  const SectorSurface& surface(const std::string& name) const;
  int nodes_per_face() const;
};

/// A structured lattice of blocks (gap, main blade, gap, splitter, gap round the sector; disc and blade in depth), on
/// the wheel's own map: mid-side nodes lie on the true geometry, and cyclic_high is cyclic_low turned by 2 pi/N. A
/// lattice conforms for any numbers of elements and pairs node for node, which a mesh of a CAD volume would not.
MeshedSector mesh_sector(const Wheel& wheel);

}  // namespace tiprub::mesh
