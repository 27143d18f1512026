// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cases/program/text_file.h"

namespace tiprub {

/// Elements of one type in one named group, or cells in none, in the order of the file.
struct GmshElements {
  int dimension = 0;
  std::string group;               ///< empty: none that has a name
  int type = 0;                    ///< gmsh's number
  std::vector<std::size_t> tags;   ///< one an element
  std::vector<std::size_t> nodes;  ///< tags, the same number an element

  std::size_t nodes_per_element() const { return nodes.size() / tags.size(); }
};

/// A mesh as it lies in a gmsh file: all nodes, the elements of all named groups, and the cells of none.
struct GmshFile {
  std::vector<std::size_t> node_tags;
  std::vector<double> positions;  ///< x, y, z of each node, in the unit of the file
  std::vector<GmshElements> elements;

  /// The elements of the groups of a name, each once: msh 2.2 repeats an element for each of its groups, and gmsh
  /// takes the copies as elements of their own. Two with the same nodes are one; the first counts.
  std::vector<GmshElements> group(int dimension, const std::string& name) const;
};

/// Reads a mesh in gmsh's format, version 2.2, 4.0 or 4.1, in text or binary. gmsh runs what is in its script
/// language as commands, in the file or in "FILE.opt" beside it; only what begins as a mesh is given to it, under a
/// name that leads to its mesh reader and has nothing beside it. gmsh runs in a child process because it doesn't
/// check the counts in a file: one that is too small makes it write past its arrays, and a check of all counts
/// beforehand would be a second reader of all versions. Raises RunError if the file can't be opened, and InputError
/// with gmsh's reason if it is no such mesh.
GmshFile read_gmsh_file(const std::filesystem::path& path);

/// The same, of the contents of a file.
GmshFile read_gmsh_file(const NamedText& contents);

/// Adds a section of comments, which readers pass over, to the end of a file. Raises RunError if it can't be written.
void append_comments(const std::string& lines, const std::filesystem::path& path);
/// What append_comments() has added; empty if nothing.
std::string appended_comments(const std::filesystem::path& path);

}  // namespace tiprub
