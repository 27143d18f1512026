// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cases/program/errors.h"
#include "cases/program/text.h"

namespace tiprub::reduce {

/// K and M of a sector as another code made them: x, y, z of each node, both triangles.
struct SectorMatrices {
  Eigen::SparseMatrix<double> mass;                    ///< [kg]
  std::vector<double> speeds;                          ///< [rad/s] rest first
  std::vector<Eigen::SparseMatrix<double>> stiffness;  ///< [N/m] at these

  /// [kg] Of the nodes that have rows.
  double total_mass() const;
};

/// The degree of the displacements.
enum class Degree { quadratic, cubic };

/// Nodes by function and cell, with the signs of the functions.
struct SignedNodes {
  Eigen::MatrixXi node;
  Eigen::MatrixXd sign;  ///< 1 or -1
};

/// The displacements of bricks of the third degree (see cubic_bricks.h), for which nodes are added to a mesh.
struct CubicFunctions {
  int file_nodes = 0;          ///< nodes before this number are those of the file
  int points = 0;              ///< nodes before this number are points; a later one stands for an odd function
  SignedNodes cells;           ///< 64 x cells
  SignedNodes tip_faces;       ///< 16 x faces of the main blade's tip
  SignedNodes splitter_faces;  ///< of the splitter's tip, likewise
};

/// One sector of a wheel, as it lies in sector.msh: quadratic cells and the named groups. The axis of rotation is z.
struct SectorMesh {
  std::string file = "the sector";     ///< where it comes from, for messages
  int sector_count = 0;                ///< N, found from the angle between the two cut faces; 1 without them
  Eigen::Matrix3Xd nodes;              ///< [m] x, y, z; 3 x nodes
  Eigen::MatrixXi cells;               ///< node numbers in VTK's order, then -1 (see nodes_of()); most nodes x cells
  std::vector<std::size_t> cell_tags;  ///< gmsh's numbers of the cells, for messages; may be left empty
  std::vector<int> cyclic_low;         ///< nodes of the lower cut face
  std::vector<int> cyclic_high;        ///< the same turned by +2 pi/N: node k stands where cyclic_low[k] comes to lie
  std::vector<int> clamped;            ///< nodes that don't move
  std::vector<int> contact_line;       ///< nodes of the main blade's tip line, from leading to trailing edge
  std::vector<int> splitter_line;      ///< nodes of the splitter's, likewise; none unless contact is wanted there
  Eigen::MatrixXi tip_faces;  ///< node numbers of the faces of the main blade's tip (see face_shape()), then -1; none
                              ///< if the mesh doesn't name them
  Eigen::MatrixXi splitter_faces;                  ///< of the splitter's tip, likewise
  std::map<std::string, std::vector<int>> parts;   ///< cells of `disc`, `main_blade`, `splitter`, where present
  std::shared_ptr<const SectorMatrices> matrices;  ///< of a sector given by its matrices, which has no cells
  std::shared_ptr<const CubicFunctions> cubic;     ///< of bricks of the third degree; none with quadratic cells

  int node_count() const { return static_cast<int>(nodes.cols()); }
  /// Nodes of the file, which come first.
  int file_node_count() const { return cubic != nullptr ? cubic->file_nodes : node_count(); }
  /// The nodes that a cell moves with.
  std::vector<int> moving_nodes(int cell) const;
  int cell_count() const { return static_cast<int>(cells.cols()); }
  /// "1500 tet10, 96 wedge15", for people.
  std::string kinds_in_words() const;
  /// "x y z = 0.1 0 0.02 m", for messages.
  std::string place_of(int node) const;
  /// "cell 12 (main_blade)": by gmsh's number, or by ours from 0 where there is none, and the part that it is in.
  std::string name_of_cell(int cell) const;
};

/// A name for all that a reduction reads of a mesh (see cases/program/digest.h): the nodes, the cells, the groups.
std::string digest(const SectorMesh& mesh);

/// "x y z = 0.1 0 0.02 m", for messages.
std::string place_text(const Eigen::Vector3d& position);

/// Raises InputError: the file of a mesh, and the parts of a message one after another.
template <class... Parts>
[[noreturn]] void refuse(const SectorMesh& mesh, const Parts&... message) {
  throw InputError(text_of(mesh.file, ": ", message...));
}

}  // namespace tiprub::reduce
