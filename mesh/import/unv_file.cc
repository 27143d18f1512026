// SPDX-License-Identifier: GPL-3.0-or-later
// I-deas' universal file: nodes (2411), elements (2412), permanent groups (2435, 2452, 2467, 2477).
#include <map>
#include <set>

#include "cases/program/text.h"
#include "mesh/import/foreign_mesh.h"

namespace tiprub::mesh {

namespace {

class UnvReader : MeshReader {
 public:
  explicit UnvReader(const NamedText& file) : MeshReader(file) {}

  ForeignMesh read() {
    static const std::set<std::string_view> groups = {"2435", "2452", "2467", "2477"};
    while (const auto line = lines_.next()) {
      if (trimmed(*line) != "-1") continue;
      const auto name = lines_.next();
      if (!name) break;
      const std::string_view dataset = trimmed(*name);
      if (dataset == "2411" || dataset == "781")
        while (!ended()) read_node();
      else if (dataset == "2412")
        while (!ended()) read_element();
      else if (groups.contains(dataset))
        while (!ended()) read_group();
      else
        while (!ended()) lines_.next();
    }
    return std::move(mesh_);
  }

 private:
  /// Whether the dataset ends here; its last line is then taken.
  bool ended() {
    const auto line = lines_.peek();
    if (!line) lines_.refuse("a dataset has no end, -1; is the file cut off?");
    if (trimmed(*line) != "-1") return false;
    lines_.next();
    return true;
  }

  std::vector<std::string_view> words(std::size_t least, const char* what) {
    const auto line = lines_.next();
    std::vector<std::string_view> found;
    if (line) found = words_of(*line);
    if (found.size() < least) lines_.refuse(std::string("must be ") + what);
    return found;
  }

  long whole(std::string_view word) const { return lines_.whole_in(word, "a number of the dataset"); }

  void read_node() {
    const long number = whole(words(4, "a node's number and three others")[0]);
    const Eigen::Vector3d at = point_in(words(3, "three coordinates"), 0);
    add_node(lines_.number(), number, at);
  }

  std::vector<long> read_numbers(long count) {
    std::vector<long> numbers;
    while (static_cast<long>(numbers.size()) < count)
      for (const std::string_view word : words(1, "nodes")) numbers.push_back(whole(word));
    return numbers;
  }

  void read_element() {
    constexpr long most_nodes = 100;
    static const std::set<long> beams = {11, 21, 22, 23, 24}, linear = {111, 112, 115};
    // Rigid bars and elements, lumped masses.
    static const std::set<long> masses_and_constraints = {121, 122, 161};
    // Thick shells, and wedges and bricks of third order.
    static const std::set<long> other_volumes = {101, 102, 103, 104, 105, 106, 114, 117};
    // Where VTK's nodes stand. I-deas lists corners and mid-sides in turn around either face, and between the two
    // faces the mid-sides of the upright edges.
    static const std::map<long, std::vector<std::size_t>> solids = {
        {118, {0, 2, 4, 9, 1, 3, 5, 6, 7, 8}},
        {113, {0, 2, 4, 9, 11, 13, 1, 3, 5, 10, 12, 14, 6, 7, 8}},
        {116, {0, 2, 4, 6, 12, 14, 16, 18, 1, 3, 5, 7, 13, 15, 17, 19, 8, 9, 10, 11}}};
    const std::vector<std::string_view> head = words(6, "an element's six numbers");
    const long number = whole(head[0]), type = whole(head[1]), count = whole(head[5]);
    if (count < 1 || count > most_nodes) lines_.refuse("an element has " + std::to_string(count) + " nodes");
    if (linear.contains(type)) refuse_linear(lines_.number(), "descriptor " + std::to_string(type));
    if (other_volumes.contains(type))
      refuse_solid(lines_.number(), "an element of descriptor " + std::to_string(type), "118, 113 and 116");
    if (beams.contains(type)) lines_.next();
    const std::vector<long> nodes = read_numbers(count);
    if (masses_and_constraints.contains(type)) ++mesh_.not_read["of descriptor " + std::to_string(type)];
    const auto solid = solids.find(type);
    if (solid == solids.end()) {
      mesh_.others[number] = nodes;
      return;
    }
    if (nodes.size() != solid->second.size())
      lines_.refuse("an element of descriptor " + std::to_string(type) + " has " + std::to_string(nodes.size()) +
                    " nodes");
    ForeignCell cell{number, {}};
    for (const std::size_t at : solid->second) cell.nodes.push_back(nodes[at]);
    mesh_.cells.push_back(std::move(cell));
  }

  /// Entities of type 7 are nodes, of type 8 elements.
  void read_group() {
    constexpr std::size_t entity = 4;
    const long count = whole(words(8, "a group's eight numbers").back());
    const auto line = lines_.next();
    const std::string name(line ? trimmed(*line) : "");
    for (long read = 0; read < count;) {
      const std::vector<std::string_view> fields = words(entity, "entities of the group ");
      for (std::size_t at = 0; at + entity <= fields.size(); at += entity, ++read) {
        const long type = whole(fields[at]), number = whole(fields[at + 1]);
        if (type == 7) mesh_.node_sets[name].push_back(number);
        if (type == 8) mesh_.cell_sets[name].push_back(number);
      }
    }
  }
};

}  // namespace

ForeignMesh read_unv(const NamedText& file) {
  return UnvReader(file).read();
}

}  // namespace tiprub::mesh
