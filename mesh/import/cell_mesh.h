// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mesh/cells/free_faces.h"
#include "mesh/import/foreign_mesh.h"

namespace tiprub::mesh {

/// An imported mesh in metres, with the axis z, and with nodes and cells counted from 0.
struct CellMesh {
  std::string file;
  Eigen::Matrix3Xd nodes;               ///< [m]; only those of solids
  std::vector<std::vector<int>> cells;  ///< in VTK's order
  std::vector<FreeFace> faces;
  /// Nodes of sets of nodes, else of surfaces, else of sets of elements, in the file's order.
  std::map<std::string, std::vector<int>> node_sets;
  std::map<std::string, std::vector<int>> surfaces;   ///< nodes of surfaces where these have names of their own
  std::map<std::string, std::vector<int>> cell_sets;  ///< solids of sets of elements
  std::set<std::string> sets_of_solids;               ///< the node sets that stand for solids only
  bool upper_names = false;                           ///< see ForeignMesh

  /// The name of the set that a key of the case means by `name`, or `name` if there is none.
  std::string set_named(const std::string& name) const;
  /// [m] from the axis.
  double largest_radius() const { return nodes.topRows<2>().colwise().norm().maxCoeff(); }
  /// "x y z = ... m".
  std::string place_of(int node) const;
};

/// Of the corners of a face [m], and of the polygon between them [m^2].
Eigen::Vector3d centre(const CellMesh& mesh, const FreeFace& face);
double area(const CellMesh& mesh, const FreeFace& face);

enum class Axis { x, y, z };

/// `length` [m] is the file's unit. Raises InputError if there are no solids, if they name nodes that don't exist, or
/// if two have the same number or the same nodes.
CellMesh in_our_terms(const ForeignMesh& mesh, double length, Axis axis);

}  // namespace tiprub::mesh
