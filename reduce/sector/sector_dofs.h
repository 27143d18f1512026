// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <vector>

#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// The dofs of a sector: r, theta, z at each node that moves. eq. 5: interior i, contact (boundary) b and cut faces c
/// are apart in every vector and matrix. They are numbered
///     interior | low cut face | high cut face | contact nodes,
/// so that the elimination of the interior leaves what nodal diameters and contact need, and the interior itself is
/// in nested-dissection order. The independent dofs of a nodal diameter are interior | low | contact (the paper's i,
/// c, b). Displacements are in cylindrical components at every node: partners on the cut faces then differ by a phase
/// only.
struct SectorDofs {
  std::vector<int> first;    ///< of each mesh node: its r-dof; theta and z follow; -1 if clamped
  std::vector<int> contact;  ///< the chosen contact nodes, leading to trailing edge; none with segments
  int interior = 0;          ///< number of dofs off the cut faces and the contact nodes
  int face = 0;              ///< number of dofs of one cut face
  /// B: the loads of unit forces on the contact unknowns, r, theta, z of each; their displacements are q = B' u. With
  /// nodes, these are the nodes' dofs; with segments, B is on interior dofs. Sector x contact dofs.
  Eigen::SparseMatrix<double> contact_loads;

  int boundary() const { return static_cast<int>(3 * contact.size()); }
  int contact_dofs() const { return static_cast<int>(contact_loads.cols()); }
  int sector() const { return interior + 2 * face + boundary(); }
  int independent() const { return interior + face + boundary(); }
  int interface() const { return 2 * face + boundary(); }
};

/// Numbers the dofs of a sector whose contact nodes are `contact`. Raises InputError if a contact node is clamped or
/// lies on a cut face, or if a node on the axis is free (it has no cylindrical frame).
SectorDofs number_dofs(const SectorMesh& mesh, const std::vector<int>& contact);

/// Nodes that share a cell, or an entry of the matrices, with each node, itself included, ascending.
std::vector<std::vector<int>> node_neighbours(const SectorMesh& mesh);

/// The pattern of a symmetric matrix between the nodes that move, counted in the order of their dofs: for each of
/// them its neighbours from itself on, ascending.
std::vector<std::vector<int>> lower_neighbours(const SectorMesh& mesh, const SectorDofs& dofs);

/// The frame of a node: columns e_r, e_theta, e_z in x, y, z.
Eigen::Matrix3d cylindrical_frame(const Eigen::Vector3d& position);

/// Displacements of one vector of sector dofs at all mesh nodes, in x, y, z; 3 x nodes, zero where clamped.
Eigen::Matrix3Xd cartesian_displacement(const SectorMesh& mesh, const SectorDofs& dofs,
                                        const Eigen::VectorXd& sector_vector);

}  // namespace tiprub::reduce
