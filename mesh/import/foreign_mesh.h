// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "cases/program/text_file.h"

namespace tiprub::mesh {

/// A solid of another code: its number there, and its nodes' numbers in VTK's order (see cell_kind.h).
struct ForeignCell {
  long number;
  std::vector<long> nodes;
};

/// Numbers of nodes or of elements, by the name of their set; in the file's order.
using Sets = std::map<std::string, std::vector<long>>;

/// A mesh as every format gives it: nodes, solids and sets, under the numbers and names of the file.
struct ForeignMesh {
  std::string file;                          ///< its name, for messages
  std::map<long, Eigen::Vector3d> nodes;     ///< in the file's unit of length, about the file's axis
  std::vector<ForeignCell> cells;            ///< in the file's order
  std::map<long, std::vector<long>> others;  ///< nodes of elements that aren't solids, as shells on a surface
  Sets node_sets;
  Sets cell_sets;  ///< numbers of cells, or of others
  /// Nodes of surfaces where these have names of their own, of which a set of nodes may have the same.
  Sets surfaces;
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

/// A text line by line, for formats in which the meaning of a line depends on its place.
class TextLines {
 public:
  explicit TextLines(const NamedText& file) : file_(file), rest_(file.text) {}

  const NamedText& file() const { return file_; }
  /// The next line without its end, or nothing after the last.
  std::optional<std::string_view> next();
  /// The line that next() will give.
  std::optional<std::string_view> peek() const;
  int number() const { return number_; }  ///< of the line that next() gave last, from 1
  /// Raises InputError: "FILE:LINE: message", of that line.
  [[noreturn]] void refuse(const std::string& message) const;

  /// A word as a finite number, as Fortran writes them too: 1.5D-3, 1.5-3. Raises InputError.
  double number_in(std::string_view word, const char* meaning) const;
  /// A word as a whole number of magnitude up to 2e9. Raises InputError.
  long whole_in(std::string_view word, const char* meaning) const;

 private:
  const NamedText& file_;
  std::string_view rest_;
  int number_ = 0;
};

/// What the readers of all formats share: the lines of the file, and the mesh that is made of them.
class MeshReader {
 protected:
  explicit MeshReader(const NamedText& file) : lines_(file) { mesh_.file = file.name; }

  /// Three coordinates, of which those that are missing or empty are 0.
  template <class Fields>
  Eigen::Vector3d point_in(const Fields& fields, std::size_t first) const {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    for (std::size_t d = 0; d < 3 && first + d < fields.size(); ++d)
      if (!fields[first + d].empty())
        at[static_cast<Eigen::Index>(d)] = lines_.number_in(fields[first + d], "a coordinate");
    return at;
  }
  /// Raises InputError, with the line, if the number isn't positive or is another node's.
  void add_node(int line, long number, const Eigen::Vector3d& at);
  /// Refuses elements that have corners only; `what` is the format's own name for them.
  [[noreturn]] void refuse_linear(int line, const std::string& what) const;
  /// Refuses elements with a volume that aren't known; `known`: those that are, in words.
  [[noreturn]] void refuse_solid(int line, const std::string& what, const std::string& known) const;
  /// Refuses statements that would be passed over although they change the mesh: those that read another file, and
  /// those that make, move or remove nodes or elements.
  [[noreturn]] void refuse_other_file(const std::string& statement) const;
  [[noreturn]] void refuse_rule(const std::string& statement) const;

  TextLines lines_;
  ForeignMesh mesh_;
};

std::string upper(std::string_view text);
/// The fields between commas, trimmed. A comma at the end begins no further field.
std::vector<std::string_view> comma_fields(std::string_view line);
/// The fields in columns of this width, trimmed; empty ones at the end are left out.
std::vector<std::string_view> column_fields(std::string_view line, std::size_t width);

}  // namespace tiprub::mesh
