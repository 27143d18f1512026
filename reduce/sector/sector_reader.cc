// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/sector_reader.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "cases/program/errors.h"
#include "cases/program/text.h"
#include "mesh/cells/cell_kind.h"
#include "mesh/cells/free_faces.h"
#include "mesh/cells/gmsh_file.h"
#include "reduce/sector/contact_line.h"
#include "reduce/sector/cut_faces.h"

namespace tiprub::reduce {

namespace {

constexpr int line_2 = 1, line_3 = 8, point = 15;                                  // gmsh's element types
constexpr std::array<std::array<int, 2>, 3> faces = {{{9, 6}, {16, 8}, {10, 9}}};  // those of faces, and their nodes

using CellTags = std::vector<std::vector<std::size_t>>;  // gmsh's node tags, a list a cell

/// gmsh's node tags to our numbers, 0 .. nodes-1 in the order of the tags; only nodes of cells are kept.
class NodeNumbers {
 public:
  explicit NodeNumbers(const CellTags& cells) {
    for (const std::vector<std::size_t>& cell : cells) tags_.insert(tags_.end(), cell.begin(), cell.end());
    std::ranges::sort(tags_);
    tags_.erase(std::unique(tags_.begin(), tags_.end()), tags_.end());
  }
  std::size_t count() const { return tags_.size(); }
  std::size_t tag(int node) const { return tags_[node]; }
  int find(std::size_t tag) const {
    const auto at = std::ranges::lower_bound(tags_, tag);
    return at != tags_.end() && *at == tag ? static_cast<int>(at - tags_.begin()) : -1;
  }

 private:
  std::vector<std::size_t> tags_;
};

/// The kind of cell of one of gmsh's types.
const CellKind& kind_of(const GmshElements& elements, const std::string& mesh) {
  for (const CellKind& kind : all_cell_kinds())
    if (kind.gmsh_type == elements.type) return kind;
  constexpr std::array<int, 4> linear = {4, 5, 6, 7}, complete = {13, 14};
  const auto is_in = [&](const auto& types) { return std::ranges::find(types, elements.type) != types.end(); };
  const std::string what = is_in(linear)
                               ? "; its cells have corners only: make them quadratic, by gmsh FILE -order 2 -save "
                                 "-o sector.msh, or Mesh.ElementOrder = 2"
                           : is_in(complete) ? "; set Mesh.SecondOrderIncomplete = 1 in gmsh"
                                             : "";
  throw InputError(text_of(mesh, ": volume group \"sector\" holds elements of gmsh type ", elements.type,
                           "; it must hold tet10 (11), pyramid13 (19), wedge15 (18), hex20 (17), or hex27 (12) only",
                           what));
}

/// The cells in the file's order, entity by entity, which is the same in all of gmsh's formats: sums over them are
/// the same to the last bit. Node tags, a list a cell.
CellTags read_cells(const GmshFile& file, SectorMesh& mesh) {
  CellTags cells;
  std::set<int> kinds;
  for (const GmshElements& elements : file.group(3, "sector")) {
    const int width = kind_of(elements, mesh.file).nodes();
    kinds.insert(width);
    for (auto at = elements.nodes.begin(); at != elements.nodes.end(); at += width)
      cells.emplace_back(at, at + width);
    mesh.cell_tags.insert(mesh.cell_tags.end(), elements.tags.begin(), elements.tags.end());
  }
  if (cells.empty())
    refuse(mesh,
           "has no volume group \"sector\" with cells; name it in the mesher, or import the mesh first: "
           "tiprub-mesh with [mesh] mesh_file");
  constexpr int lagrange = 27;
  if (kinds.contains(lagrange) && kinds.size() > 1)
    refuse(mesh, "hex27 beside other kinds of cells: their faces don't fit; mesh the bricks as hex20");
  mesh.cells = Eigen::MatrixXi::Constant(*kinds.rbegin(), static_cast<Eigen::Index>(cells.size()), -1);
  return cells;
}

/// The cells of each part of the sector that has a name. A part whose cells are none of the sector's stays empty.
std::map<std::string, std::vector<int>> read_parts(const GmshFile& file, const CellTags& cells) {
  const auto sorted = [](std::vector<std::size_t> nodes) {
    std::ranges::sort(nodes);
    return nodes;
  };
  std::map<std::vector<std::size_t>, int> cell_of;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) cell_of[sorted(cells[cell])] = static_cast<int>(cell);
  std::map<std::string, std::vector<int>> parts;
  for (const char* name : {"disc", "main_blade", "splitter"})
    for (const GmshElements& elements : file.group(3, name)) {
      const auto width = static_cast<std::ptrdiff_t>(elements.nodes_per_element());
      std::vector<int>& part = parts[name];
      for (auto first = elements.nodes.begin(); first != elements.nodes.end(); first += width)
        if (const auto at = cell_of.find(sorted({first, first + width})); at != cell_of.end())
          part.push_back(at->second);
    }
  return parts;
}

Eigen::Matrix3Xd read_positions(const GmshFile& file, const NodeNumbers& numbers, const std::string& name) {
  Eigen::Matrix3Xd nodes = Eigen::Matrix3Xd::Constant(3, static_cast<Eigen::Index>(numbers.count()),
                                                      std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < file.node_tags.size(); ++i)
    if (const int node = numbers.find(file.node_tags[i]); node >= 0)
      nodes.col(node) = Eigen::Map<const Eigen::Vector3d>(file.positions.data() + 3 * i);
  for (int node = 0; node < nodes.cols(); ++node)
    if (!nodes.col(node).allFinite())
      throw InputError(
          text_of(name, ": node ", numbers.tag(node), " stands at no finite place; write the mesh again"));
  return nodes;
}

/// Refuses a face of a surface group whose nodes don't belong to one cell: a stray node would be held, or loaded.
void require_faces_of_cells(const GmshFile& file, const NodeNumbers& numbers, const SectorMesh& mesh) {
  std::vector<std::vector<int>> cells_of(numbers.count());  // ascending
  for (int cell = 0; cell < mesh.cell_count(); ++cell)
    for (const int node : nodes_of(mesh.cells, cell)) cells_of[node].push_back(cell);
  for (const char* name : {"cyclic_low", "cyclic_high", "clamped", "blade_tip", "splitter_tip"})
    for (const GmshElements& elements : file.group(2, name)) {
      const std::size_t width = elements.nodes_per_element();
      for (std::size_t face = 0; face < elements.nodes.size() / width; ++face) {
        std::vector<int> common;
        for (std::size_t k = 0; k < width; ++k) {
          const int node = numbers.find(elements.nodes[face * width + k]);
          const std::vector<int> here = node < 0 ? std::vector<int>() : cells_of[node];
          std::vector<int> both;
          std::set_intersection(common.begin(), common.end(), here.begin(), here.end(), std::back_inserter(both));
          common = k == 0 ? here : both;
        }
        if (common.empty())
          refuse(mesh, "surface group \"", name, "\": the nodes of element ", elements.tags[face],
                 " belong to no cell in common; write the mesh again");
      }
    }
}

std::vector<int> read_surface(const GmshFile& file, const std::string& name, const NodeNumbers& numbers,
                              const std::string& mesh) {
  std::vector<int> nodes;
  for (const GmshElements& elements : file.group(2, name))
    for (const std::size_t tag : elements.nodes) nodes.push_back(numbers.find(tag));
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  if (nodes.empty()) throw InputError(mesh + ": has no surface group \"" + name + "\"; name it in the mesher");
  if (nodes.front() < 0) throw InputError(mesh + ": surface group \"" + name + "\" has nodes that belong to no cell");
  return nodes;
}

/// A mesh without cut faces is one whole body: a blade, or a whole wheel. One cut face without the other is refused.
void read_cut_faces(const GmshFile& file, const NodeNumbers& numbers, double tolerance, SectorMesh& mesh) {
  mesh.sector_count = 1;
  if (file.group(2, "cyclic_low").empty() && file.group(2, "cyclic_high").empty()) return;
  mesh.cyclic_low = read_surface(file, "cyclic_low", numbers, mesh.file);
  mesh.cyclic_high = read_surface(file, "cyclic_high", numbers, mesh.file);
  pair_cut_faces(mesh, tolerance);
  require_whole_cuts(mesh);
}

/// A clamp on a cut would hold the wheel in planes inside it.
void require_clamp_off_cuts(const GmshFile& file, const NodeNumbers& numbers, const SectorMesh& mesh) {
  for (const std::vector<int>* cut : {&mesh.cyclic_low, &mesh.cyclic_high}) {
    const std::set<int> nodes(cut->begin(), cut->end());
    const auto on_cut = [&](std::size_t tag) { return nodes.contains(numbers.find(tag)); };
    for (const GmshElements& elements : file.group(2, "clamped")) {
      const auto width = static_cast<std::ptrdiff_t>(elements.nodes_per_element());
      for (auto at = elements.nodes.begin(); at != elements.nodes.end(); at += width)
        if (std::all_of(at, at + width, on_cut))
          refuse(mesh, "the face at ", mesh.place_of(numbers.find(*at)),
                 " of the surface group \"clamped\" lies on a cut, inside the wheel; take the cuts out of "
                 "this group");
    }
  }
}

/// The faces of a blade's tip. Not all reductions need them: they are none if the mesh doesn't name them, or not by
/// faces of its cells.
Eigen::MatrixXi read_tip(const GmshFile& file, const std::string& name, const NodeNumbers& numbers) {
  std::vector<std::vector<int>> tip;
  int most = 0;
  for (const GmshElements& elements : file.group(2, name)) {
    const auto known = std::ranges::find_if(faces, [&](const auto& face) { return face[0] == elements.type; });
    if (known == faces.end()) return {};
    const int width = (*known)[1];
    most = std::max(most, width);
    for (auto at = elements.nodes.begin(); at != elements.nodes.end(); at += width) {
      tip.emplace_back();
      std::transform(at, at + width, std::back_inserter(tip.back()),
                     [&](std::size_t tag) { return numbers.find(tag); });
      if (std::ranges::count(tip.back(), -1) > 0) return {};
    }
  }
  Eigen::MatrixXi table = Eigen::MatrixXi::Constant(most, static_cast<Eigen::Index>(tip.size()), -1);
  for (std::size_t face = 0; face < tip.size(); ++face)
    std::copy(tip[face].begin(), tip[face].end(), table.col(static_cast<Eigen::Index>(face)).begin());
  return table;
}

/// The nodes of each curve element (or point), in order along it.
std::vector<std::vector<std::size_t>> line_pieces(const GmshFile& file, const std::string& name) {
  std::vector<std::vector<std::size_t>> pieces;
  for (const int dimension : {1, 0}) {
    for (const GmshElements& elements : file.group(dimension, name)) {
      const std::vector<std::size_t>& nodes = elements.nodes;
      if (elements.type != line_3 && elements.type != line_2 && elements.type != point) continue;
      for (std::size_t i = 0; i < nodes.size(); i += elements.nodes_per_element()) {
        if (elements.type == point) pieces.push_back({nodes[i]});
        if (elements.type == line_2) pieces.push_back({nodes[i], nodes[i + 1]});
        if (elements.type == line_3) pieces.push_back({nodes[i], nodes[i + 2], nodes[i + 1]});  // end, end, middle
      }
    }
    if (!pieces.empty()) break;
  }
  return pieces;
}

/// The nodes of a chain of line elements (or of points) in order; none if the mesh doesn't name it.
std::vector<int> read_line(const GmshFile& file, const std::string& name, const NodeNumbers& numbers,
                           const SectorMesh& mesh) {
  std::vector<int> nodes;
  for (const std::vector<std::size_t>& piece : line_pieces(file, name)) {
    for (const std::size_t tag : piece) {
      const int node = numbers.find(tag);
      if (node < 0) refuse(mesh, "group \"", name, "\" has nodes that belong to no cell");
      const bool joins = !nodes.empty() && nodes.back() == node;
      if (piece.size() > 1 && tag == piece.front() && !nodes.empty() && !joins)
        refuse(mesh, "the curve \"", name, "\" jumps from ", mesh.place_of(nodes.back()), " to ", mesh.place_of(node),
               "; order its elements, and direct all of them, from leading to trailing edge");
      if (!joins) nodes.push_back(node);
    }
  }
  return nodes;
}

/// The line along the splitter's tip. It may be absent, but a group of its name must hold a line.
std::vector<int> read_splitter_line(const GmshFile& file, const NodeNumbers& numbers, const SectorMesh& mesh) {
  const std::string name = "contact_splitter";
  std::vector<int> nodes = read_line(file, name, numbers, mesh);
  const bool named =
      std::ranges::any_of(file.elements, [&](const GmshElements& elements) { return elements.group == name; });
  if (named && nodes.empty())
    refuse(mesh, "\"", name,
           "\" names neither a curve nor points; name the line along the splitter's tip so, from leading "
           "to trailing edge");
  return nodes;
}

}  // namespace

SectorMesh read_sector_mesh(const std::filesystem::path& path, double tolerance) {
  const GmshFile file = read_gmsh_file(path);
  SectorMesh mesh;
  mesh.file = path.string();
  const CellTags cells = read_cells(file, mesh);
  const NodeNumbers numbers(cells);
  mesh.nodes = read_positions(file, numbers, mesh.file);
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const std::vector<int>& place = cell_kind(static_cast<int>(cells[cell].size())).gmsh_node;
    for (std::size_t k = 0; k < place.size(); ++k)
      mesh.cells(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(cell)) =
          numbers.find(cells[cell][static_cast<std::size_t>(place[k])]);
  }
  if (const auto [first, second] = equal_cells(listed_cells(mesh.cells)); first >= 0)
    refuse(mesh, mesh.name_of_cell(first), " and ", mesh.name_of_cell(second),
           " have the same nodes; is the mesh there twice? Write it once");
  mesh.parts = read_parts(file, cells);
  require_faces_of_cells(file, numbers, mesh);
  read_cut_faces(file, numbers, tolerance, mesh);
  mesh.clamped = read_surface(file, "clamped", numbers, mesh.file);
  require_clamp_off_cuts(file, numbers, mesh);
  mesh.tip_faces = read_tip(file, "blade_tip", numbers);
  mesh.contact_line = read_line(file, "contact", numbers, mesh);
  if (mesh.contact_line.empty())
    refuse(mesh,
           "has no curve or points named \"contact\" (the main blade's tip, from leading to trailing edge); "
           "name it in the mesher");
  mesh.splitter_line = read_splitter_line(file, numbers, mesh);
  if (!mesh.splitter_line.empty()) mesh.splitter_faces = read_tip(file, "splitter_tip", numbers);
  require_one_way(mesh);
  if (const std::string wrong =
          wrong_parts(mesh.cells, mesh.parts, {{"main_blade", mesh.contact_line}, {"splitter", mesh.splitter_line}});
      !wrong.empty())
    refuse(mesh, wrong, "; name the groups of cells again in the mesher");
  return mesh;
}

}  // namespace tiprub::reduce
