// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sector/sector_file.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

#include "mesh/cells/cell_kind.h"
#include "mesh/cells/free_faces.h"

namespace tiprub::mesh {

namespace {

constexpr double view_size = 560, view_margin = 20, legend_row = 18;  // of the drawing, in pixels

/// A face of the surface, and the name by which it is coloured.
struct NamedFace {
  FreeFace face;
  std::string name;
};

/// What is drawn: the surface, lines of nodes, and how many faces or nodes each name has.
struct Surface {
  Eigen::Matrix3Xd nodes;
  std::vector<NamedFace> faces;
  std::vector<std::pair<std::string, std::vector<std::size_t>>> lines;  ///< pieces: two nodes each
  std::map<std::string, std::size_t> counts;
};

template <class Node>
std::vector<int> sorted_corners(const Node* first, std::size_t corners) {
  std::vector<int> key(first, first + corners);
  std::ranges::sort(key);
  return key;
}

/// The names of faces that are in groups, by their corners.
std::map<std::vector<int>, std::string> named_faces(const NamedMesh& mesh) {
  constexpr int triangle6 = 9, quadrangle9 = 10;
  std::map<std::vector<int>, std::string> names;
  for (const NamedMesh::Entity& entity : mesh.entities)
    for (const auto& [type, nodes] : entity.elements) {
      if (entity.dimension != 2) continue;
      const std::size_t width = type == triangle6 ? 6 : type == quadrangle9 ? 9 : 8, corners = width == 6 ? 3 : 4;
      for (std::size_t at = 0; at < nodes.size(); at += width)
        names[sorted_corners(nodes.data() + at, corners)] = entity.groups.front();
    }
  return names;
}

Surface surface_of(const NamedMesh& mesh) {
  Surface surface;
  surface.nodes.resize(3, static_cast<Eigen::Index>(mesh.nodes.size()));
  for (std::size_t k = 0; k < mesh.nodes.size(); ++k) surface.nodes.col(static_cast<Eigen::Index>(k)) = mesh.nodes[k];
  std::vector<std::vector<int>> cells;
  std::vector<std::string> parts;  // by cell
  for (const NamedMesh::Entity& entity : mesh.entities)
    for (const auto& [type, nodes] : entity.elements) {
      if (entity.dimension == 1) surface.lines.emplace_back(entity.groups.front(), nodes);
      if (entity.dimension != 3) continue;
      const auto kind = std::ranges::find(all_cell_kinds(), type, &CellKind::gmsh_type);
      const auto width = static_cast<std::ptrdiff_t>(kind->nodes());
      for (auto at = nodes.begin(); at != nodes.end(); at += width) cells.emplace_back(at, at + width);
      parts.resize(cells.size(), entity.groups.back());  // "sector" comes first
    }
  const std::map<std::vector<int>, std::string> names = named_faces(mesh);
  for (const FreeFace& face : free_faces(surface.nodes, cells)) {
    const auto known = names.find(sorted_corners(face.nodes.data(), face.corners()));
    surface.faces.push_back({face, known == names.end() ? parts[face.cell] : known->second});
    ++surface.counts[surface.faces.back().name];
  }
  return surface;
}

using Colour = std::array<int, 3>;

Colour colour_of(const std::string& name) {
  static const std::map<std::string, Colour> colours = {
      {"sector", {176, 180, 186}},      {"disc", {176, 180, 186}},     {"main_blade", {214, 205, 178}},
      {"splitter", {196, 214, 190}},    {"clamped", {214, 69, 65}},    {"blade_tip", {52, 116, 196}},
      {"splitter_tip", {98, 168, 224}}, {"cyclic_low", {66, 160, 98}}, {"cyclic_high", {230, 150, 48}},
      {"hub", {150, 130, 176}}};
  const auto known = colours.find(name);
  return known == colours.end() ? Colour{176, 180, 186} : known->second;
}

std::string hex(const Colour& colour, double brightness) {
  std::array<char, 8> text{};
  std::array<int, 3> dimmed{};
  for (std::size_t k = 0; k < 3; ++k) dimmed[k] = static_cast<int>(std::lround(brightness * colour[k]));
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", dimmed[0], dimmed[1], dimmed[2]);
  return text.data();
}

/// A direction from which the mesh is seen, with the radius upwards.
struct View {
  Eigen::Vector3d right, up, towards;  ///< orthonormal; `towards` the eye

  View(const Eigen::Vector3d& radial, const Eigen::Vector3d& eye)
      : right(radial.cross(eye).normalized()), up(eye.cross(right).normalized()), towards(eye.normalized()) {}
  Eigen::Vector2d on_paper(const Eigen::Vector3d& at) const { return {right.dot(at), -up.dot(at)}; }
};

/// From the inlet and above onto the tip and cyclic_low, and from the outlet and below onto the clamp and
/// cyclic_high.
std::array<View, 2> views_of(const Eigen::Matrix3Xd& nodes) {
  Eigen::Vector3d radial = nodes.rowwise().mean();
  radial.z() = 0;
  const bool whole = radial.norm() < 1e-3 * nodes.colwise().norm().maxCoeff();
  radial = whole ? Eigen::Vector3d::UnitX() : Eigen::Vector3d(radial.normalized());
  const Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(), around = axis.cross(radial);
  return {View(radial, 0.8 * radial - around - 0.8 * axis), View(radial, -0.6 * radial + around + 0.8 * axis)};
}

/// Writes one view of a surface into a square at `left` of the drawing.
class Drawing {
 public:
  Drawing(const Surface& surface, const View& view, double left) : surface_(surface), view_(view) {
    Eigen::Matrix2Xd places(2, surface.nodes.cols());
    for (Eigen::Index k = 0; k < places.cols(); ++k) places.col(k) = view.on_paper(surface.nodes.col(k));
    const Eigen::Vector2d low = places.rowwise().minCoeff(), high = places.rowwise().maxCoeff();
    scale_ = (view_size - 2 * view_margin) / (high - low).maxCoeff();
    shift_ = Eigen::Vector2d(left + view_size / 2, view_size / 2) - scale_ * (low + high) / 2;
  }

  std::string svg() const {
    std::vector<const NamedFace*> seen;
    for (const NamedFace& face : surface_.faces)
      if (face.face.normal.dot(view_.towards) > 0) seen.push_back(&face);
    std::ranges::stable_sort(seen, [&](const NamedFace* a, const NamedFace* b) { return depth(*a) < depth(*b); });
    std::string text = "<g stroke=\"#333\" stroke-width=\"0.5\" stroke-linejoin=\"round\">\n";
    for (const NamedFace* face : seen) text += polygon(*face);
    text += "</g>\n<g stroke=\"#000\" stroke-width=\"3\" stroke-linecap=\"round\">\n";
    for (const auto& [name, pieces] : surface_.lines)
      for (std::size_t k = 0; k + 1 < pieces.size(); k += 2)
        text += "<path d=\"M" + place(pieces[k]) + "L" + place(pieces[k + 1]) + "\"/>\n";
    return text + "</g>\n";
  }

 private:
  double depth(const NamedFace& face) const {
    double sum = 0;
    for (const int node : face.face.nodes) sum += view_.towards.dot(surface_.nodes.col(node));
    return sum / static_cast<double>(face.face.nodes.size());
  }

  std::string place(std::size_t node) const {
    const Eigen::Vector2d at = shift_ + scale_ * view_.on_paper(surface_.nodes.col(static_cast<Eigen::Index>(node)));
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f,%.1f", at.x(), at.y());
    return text.data();
  }

  /// Corners and mid-sides in turn, so that curved edges look curved.
  std::string polygon(const NamedFace& named) const {
    const FreeFace& face = named.face;
    const double brightness = 0.6 + 0.4 * face.normal.dot(view_.towards);
    std::string text = "<path fill=\"" + hex(colour_of(named.name), brightness) + "\" d=\"";
    for (std::size_t k = 0; k < face.corners(); ++k)
      text += (k == 0 ? "M" : "L") + place(static_cast<std::size_t>(face.nodes[k])) + "L" +
              place(static_cast<std::size_t>(face.nodes[face.corners() + k]));
    return text + "z\"/>\n";
  }

  const Surface& surface_;
  const View& view_;
  double scale_ = 1;
  Eigen::Vector2d shift_;
};

std::string legend(const Surface& surface) {
  std::string text;
  double y = view_size + legend_row;
  const auto row = [&](const std::string& mark, const std::string& words) {
    const std::string at = std::to_string(static_cast<int>(y));
    text += "<g transform=\"translate(20," + at + ")\">" + mark + "<text x=\"22\">" + words + "</text></g>\n";
    y += legend_row;
  };
  for (const auto& [name, count] : surface.counts)
    row("<rect y=\"-11\" width=\"14\" height=\"12\" fill=\"" + hex(colour_of(name), 1) + "\"/>",
        name + ": " + std::to_string(count) + " faces");
  for (const auto& [name, pieces] : surface.lines)
    row("<path d=\"M0,-5L14,-5\" stroke=\"#000\" stroke-width=\"3\"/>",
        name + ": " + std::to_string(pieces.size() / 2 + 1) + " nodes");
  return text;
}

}  // namespace

std::string picture_of(const NamedMesh& mesh) {
  const Surface surface = surface_of(mesh);
  const std::array<View, 2> views = views_of(surface.nodes);
  const auto rows = static_cast<double>(surface.counts.size() + surface.lines.size());
  const std::string width = std::to_string(static_cast<int>(2 * view_size));
  const std::string height = std::to_string(static_cast<int>(view_size + legend_row * (rows + 1)));
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
         "\" font-family=\"sans-serif\" font-size=\"14\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" +
         Drawing(surface, views[0], 0).svg() + Drawing(surface, views[1], view_size).svg() + legend(surface) +
         "</svg>\n";
}

}  // namespace tiprub::mesh
