// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/sector_reader.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>

#include "cases/program/errors.h"
#include "reduce/sector/contact_line.h"
#include "reduce/sector/cut_faces.h"
#include "reduce/sector/gmsh_file.h"

namespace tiprub {

namespace {

constexpr int line_2 = 1, line_3 = 8, point = 15, face_8 = 16, face_9 = 10, brick_20 = 17,
              brick_27 = 12;  // gmsh's element types

/// gmsh's node tags to our numbers, 0 .. nodes-1 in the order of the tags; only nodes of cells are kept.
class NodeNumbers {
 public:
  explicit NodeNumbers(std::vector<std::size_t> tags) : tags_(std::move(tags)) {
    std::sort(tags_.begin(), tags_.end());
    tags_.erase(std::unique(tags_.begin(), tags_.end()), tags_.end());
  }
  std::size_t count() const { return tags_.size(); }
  std::size_t tag(int node) const { return tags_[node]; }
  int find(std::size_t tag) const {
    const auto at = std::lower_bound(tags_.begin(), tags_.end(), tag);
    return at != tags_.end() && *at == tag ? static_cast<int>(at - tags_.begin()) : -1;
  }

 private:
  std::vector<std::size_t> tags_;
};

/// The cells in the file's order, entity by entity, which is the same in all of gmsh's formats: sums over them are
/// the same to the last bit.
std::vector<std::size_t> read_cells(const GmshFile& file, SectorMesh& mesh) {
  std::vector<std::size_t> cells;
  std::size_t width = 0;
  for (const GmshElements& elements : file.group(3, "sector")) {
    const std::size_t wanted = elements.type == brick_20 ? 20 : elements.type == brick_27 ? 27 : 0;
    if (wanted == 0 || (width != 0 && wanted != width))
      throw InputError(mesh.file + ": volume group \"sector\" holds elements of gmsh type " +
                       std::to_string(elements.type) +
                       "; it must hold 20-node bricks (17) only, or 27-node bricks (12) only");
    width = wanted;
    cells.insert(cells.end(), elements.nodes.begin(), elements.nodes.end());
    mesh.cell_tags.insert(mesh.cell_tags.end(), elements.tags.begin(), elements.tags.end());
  }
  if (width == 0) throw InputError(mesh.file + ": has no volume group \"sector\" with cells; name it in the mesher");
  mesh.cells.resize(static_cast<Eigen::Index>(width), static_cast<Eigen::Index>(cells.size() / width));
  return cells;
}

/// The cells of each part of the sector that has a name.
std::map<std::string, std::vector<int>> read_parts(const GmshFile& file, const std::vector<std::size_t>& cells,
                                                   std::size_t width) {
  const auto key = [&](const std::vector<std::size_t>& nodes, std::size_t first) {
    const auto begin = nodes.begin() + static_cast<std::ptrdiff_t>(first);
    std::vector<std::size_t> sorted(begin, begin + static_cast<std::ptrdiff_t>(width));
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  };
  std::map<std::vector<std::size_t>, int> cell_of;
  for (std::size_t first = 0; first < cells.size(); first += width)
    cell_of[key(cells, first)] = static_cast<int>(first / width);
  std::map<std::string, std::vector<int>> parts;
  for (const char* name : {"disc", "main_blade", "splitter"})
    for (const GmshElements& elements : file.group(3, name))
      for (std::size_t first = 0; first + width <= elements.nodes.size(); first += width)
        if (const auto at = cell_of.find(key(elements.nodes, first)); at != cell_of.end())
          parts[name].push_back(at->second);
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
      throw InputError(name + ": node " + std::to_string(numbers.tag(node)) +
                       " stands at no finite place; write the mesh again");
  return nodes;
}

std::vector<int> read_surface(const GmshFile& file, const std::string& name, const NodeNumbers& numbers,
                              const std::string& mesh) {
  std::vector<int> nodes;
  for (const GmshElements& elements : file.group(2, name))
    for (const std::size_t tag : elements.nodes) nodes.push_back(numbers.find(tag));
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  if (nodes.empty()) throw InputError(mesh + ": has no surface group \"" + name + "\"; name it in the mesher");
  if (nodes.front() < 0) throw InputError(mesh + ": surface group \"" + name + "\" has nodes that belong to no cell");
  return nodes;
}

/// A mesh without both cut faces is whole: one blade, or one turn of a wheel. One face without the other is missed.
void read_cut_faces(const GmshFile& file, const NodeNumbers& numbers, double tolerance, SectorMesh& mesh) {
  mesh.sector_count = 1;
  if (file.group(2, "cyclic_low").empty() && file.group(2, "cyclic_high").empty()) return;
  mesh.cyclic_low = read_surface(file, "cyclic_low", numbers, mesh.file);
  mesh.cyclic_high = read_surface(file, "cyclic_high", numbers, mesh.file);
  pair_cut_faces(mesh, tolerance);
}

/// The main blade's tip, if the mesh names it, and by faces of its cells; not all reductions ask for it.
Eigen::MatrixXi read_tip(const GmshFile& file, const NodeNumbers& numbers, int nodes_per_cell) {
  std::vector<int> nodes;
  const int type = nodes_per_cell == 20 ? face_8 : face_9, width = nodes_per_cell == 20 ? 8 : 9;
  for (const GmshElements& elements : file.group(2, "blade_tip"))
    for (const std::size_t tag : elements.nodes) nodes.push_back(elements.type == type ? numbers.find(tag) : -1);
  if (std::count(nodes.begin(), nodes.end(), -1) > 0) nodes.clear();
  return Eigen::Map<Eigen::MatrixXi>(nodes.data(), width, static_cast<Eigen::Index>(nodes.size()) / width);
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

/// The nodes of a chain of line elements (or of points) in order.
std::vector<int> read_line(const GmshFile& file, const std::string& name, const NodeNumbers& numbers,
                           const SectorMesh& mesh) {
  std::vector<int> nodes;
  for (const std::vector<std::size_t>& piece : line_pieces(file, name)) {
    for (const std::size_t tag : piece) {
      const int node = numbers.find(tag);
      if (node < 0) throw InputError(mesh.file + ": group \"" + name + "\" has nodes that belong to no cell");
      const bool joins = !nodes.empty() && nodes.back() == node;
      if (piece.size() > 1 && tag == piece.front() && !nodes.empty() && !joins)
        throw InputError(mesh.file + ": the curve \"" + name + "\" jumps from " + mesh.place_of(nodes.back()) +
                         " to " + mesh.place_of(node) +
                         "; order its elements, and direct all of them, from leading to trailing edge");
      if (!joins) nodes.push_back(node);
    }
  }
  if (nodes.empty())
    throw InputError(mesh.file + ": has no curve or points named \"" + name +
                     "\" (the main blade's tip, from leading to trailing edge); name it in the mesher");
  return nodes;
}

}  // namespace

SectorMesh read_sector_mesh(const std::filesystem::path& path, double tolerance) {
  const GmshFile file = read_gmsh_file(path);
  SectorMesh mesh;
  mesh.file = path.string();
  const std::vector<std::size_t> cells = read_cells(file, mesh);
  const NodeNumbers numbers(cells);
  mesh.nodes = read_positions(file, numbers, mesh.file);
  for (std::size_t i = 0; i < cells.size(); ++i) mesh.cells.data()[i] = numbers.find(cells[i]);
  mesh.parts = read_parts(file, cells, static_cast<std::size_t>(mesh.cells.rows()));
  read_cut_faces(file, numbers, tolerance, mesh);
  mesh.clamped = read_surface(file, "clamped", numbers, mesh.file);
  mesh.tip_faces = read_tip(file, numbers, mesh.nodes_per_cell());
  mesh.contact_line = read_line(file, "contact", numbers, mesh);
  require_one_way(mesh);
  return mesh;
}

}  // namespace tiprub
