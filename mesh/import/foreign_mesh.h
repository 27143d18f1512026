// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cases/program/case_file.h"

namespace tiprub::mesh {

/// A solid of another code: its number there, and its nodes' numbers in VTK's order (see cell_kind.h).
struct ForeignCell {
  long number;
  std::vector<long> nodes;
};

/// A mesh as every format gives it: nodes, solids and sets, under the numbers and names of the file.
struct ForeignMesh {
  std::string file;                          ///< its name, for messages
  std::map<long, Eigen::Vector3d> nodes;     ///< in the file's unit of length, about the file's axis
  std::vector<ForeignCell> cells;            ///< in the file's order
  std::map<long, std::vector<long>> others;  ///< nodes of elements that aren't solids, as shells on a surface
  std::map<std::string, std::vector<long>> node_sets;  ///< in the file's order
  std::map<std::string, std::vector<long>> cell_sets;  ///< numbers of cells, or of others
  /// Nodes of surfaces where these have names of their own, of which a set of nodes may have the same.
  std::map<std::string, std::vector<long>> surfaces;
  /// Masses, springs and constraints that are not read, by the format's name for the kind: how many there are.
  std::map<std::string, int> not_read;
  std::set<std::string> materials;  ///< of solids, by the file's names or numbers
  bool upper_names = false;         ///< the format ignores the case of names; they are in upper case here
};

/// The readers of the formats. They raise InputError with the line.
ForeignMesh read_inp(const NamedText& file);  ///< CalculiX, Abaqus: *NODE, *ELEMENT, *NSET, *ELSET, *SURFACE
ForeignMesh read_bdf(const NamedText& file);  ///< Nastran: GRID, CTETRA, CPYRAM, CPENTA, CHEXA, SPC, SPC1, SET
ForeignMesh read_cdb(const NamedText& file);  ///< Ansys: NBLOCK, EBLOCK, CMBLOCK
ForeignMesh read_unv(const NamedText& file);  ///< I-deas universal file: 2411, 2412, groups
ForeignMesh read_msh(const NamedText& file);  ///< gmsh: physical groups that have a name; raises without a line

}  // namespace tiprub::mesh
