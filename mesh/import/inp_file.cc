// SPDX-License-Identifier: GPL-3.0-or-later
// CalculiX's and Abaqus' decks. Only what describes the mesh is read; steps, materials and the like are passed over.
#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <map>
#include <set>

#include "cases/program/text.h"
#include "mesh/cells/cell_kind.h"
#include "mesh/import/foreign_mesh.h"

namespace tiprub::mesh {

namespace {

/// A name as both programs understand it: only quotes keep its case.
std::string name_in(std::string_view word) {
  if (word.size() > 2 && word.starts_with('"') && word.ends_with('"'))
    return std::string(word.substr(1, word.size() - 2));
  return upper(word);
}

/// "*NSET, NSET=low, GENERATE".
struct Keyword {
  std::string name;                           ///< "NSET"
  std::map<std::string, std::string> values;  ///< "NSET": "LOW"; "GENERATE": ""

  bool has(const char* key) const { return values.contains(key); }
  std::string value(const char* key) const { return has(key) ? values.at(key) : ""; }
};

Keyword keyword_of(std::string_view line) {
  Keyword keyword;
  const std::vector<std::string_view> fields = comma_fields(line.substr(1));
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::size_t equals = fields[i].find('=');
    const std::string key = upper(trimmed(fields[i].substr(0, equals)));
    if (i == 0)
      keyword.name = key;
    else
      keyword.values[key] = equals == std::string_view::npos ? "" : name_in(trimmed(fields[i].substr(equals + 1)));
  }
  return keyword;
}

/// Blanks may stand before a keyword.
bool is_comment(std::string_view line) {
  return trimmed(line).starts_with("**");
}

bool is_keyword(std::string_view line) {
  return trimmed(line).starts_with('*') && !is_comment(line);
}

using Prefixes = std::initializer_list<const char*>;

/// Types that lie on the surface of solids and often only name it: shells, membranes, surface, plane, axisymmetric
/// and rigid elements, beams, pipes and trusses. Continuum shells (SC8R, CSS8) are solids.
constexpr Prefixes sheets_and_lines = {"S3",  "S4",  "S6",  "S8",  "S9",  "STRI", "DS", "M3D",  "SFM3D", "CPS", "CPE",
                                       "CAX", "R2D", "R3D", "RAX", "SAX", "B2",   "B3", "PIPE", "T2D",   "T3D"};
constexpr Prefixes masses_and_connectors = {"MASS",    "ROTARYI", "SPRING", "DASHPOT",
                                            "CONN2D2", "CONN3D2", "DCOUP",  "GAP"};

bool starts_with_any(const std::string& type, const Prefixes& prefixes) {
  return std::ranges::any_of(prefixes, [&](const char* prefix) { return type.starts_with(prefix); });
}

class InpReader : MeshReader {
 public:
  explicit InpReader(const NamedText& file) : MeshReader(file) { mesh_.upper_names = true; }

  ForeignMesh read() {
    while (const auto line = lines_.next()) {
      if (!is_keyword(*line)) continue;
      const Keyword keyword = keyword_of(with_continuations(*line));
      require_written_out(keyword);
      note_constraint(keyword);
      if (keyword.name == "INSTANCE") require_single(keyword);
      if (keyword.name == "INSTANCE") require_unmoved();
      if (keyword.name == "SOLID SECTION" && keyword.has("MATERIAL"))
        mesh_.materials.insert(keyword.value("MATERIAL"));
      if (keyword.name == "SYSTEM" && data()) refuse_system("*SYSTEM");
      if (keyword.name == "NODE") read_nodes(keyword);
      if (keyword.name == "ELEMENT") read_elements(keyword);
      if (keyword.name == "NSET") read_set(keyword, keyword.value("NSET"), mesh_.node_sets);
      if (keyword.name == "ELSET") read_set(keyword, keyword.value("ELSET"), mesh_.cell_sets);
      if (keyword.name == "SURFACE") read_surface(keyword);
    }
    return std::move(mesh_);
  }

 private:
  /// A comma at the end of a keyword's line continues it on the next. Where that line is a keyword or begins with a
  /// number, the comma stands there by mistake.
  std::string with_continuations(std::string_view line) {
    std::string text(trimmed(line));
    while (text.ends_with(',')) {
      const std::string_view more = trimmed(lines_.peek().value_or(""));
      if (more.empty() || std::isalpha(static_cast<unsigned char>(more.front())) == 0) break;
      text += more;
      lines_.next();
    }
    return text;
  }

  /// Counts what joins nodes without elements. The cuts of a sector are found without their *TIE.
  void note_constraint(const Keyword& keyword) {
    static const std::set<std::string> constraints = {
        "EQUATION",          "TIE", "MPC", "COUPLING", "KINEMATIC COUPLING", "DISTRIBUTING COUPLING", "RIGID BODY",
        "NONSTRUCTURAL MASS"};
    if (constraints.contains(keyword.name) && !keyword.has("CYCLIC SYMMETRY")) ++mesh_.not_read["*" + keyword.name];
  }

  void require_written_out(const Keyword& keyword) const {
    static const std::set<std::string> rules = {
        "NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYMMETRIC MODEL GENERATION", "IMPERFECTION"};
    const bool mesh = keyword.name == "NODE" || keyword.name == "ELEMENT";
    const bool library = keyword.name == "INSTANCE" && keyword.has("LIBRARY");
    if (keyword.name == "INCLUDE" || keyword.name == "IMPORT" || library || (mesh && keyword.has("INPUT")))
      refuse_other_file("*" + keyword.name);
    const bool elements_change = keyword.name == "MODEL CHANGE" && keyword.value("TYPE") != "CONTACT PAIR";
    if (rules.contains(keyword.name) || elements_change) refuse_rule("*" + keyword.name);
  }

  /// The nodes of a part are read once.
  void require_single(const Keyword& keyword) {
    const std::string part = keyword.value("PART");
    if (!part.empty() && !instanced_.insert(part).second)
      lines_.refuse("*INSTANCE places the part " + part + " again, which is read once; write the wheel as one part");
  }

  /// The next line of data before a keyword.
  std::optional<std::string_view> data() {
    while (const auto line = lines_.peek()) {
      if (is_keyword(*line)) return std::nullopt;
      lines_.next();
      if (!is_comment(*line) && !trimmed(*line).empty()) return line;
    }
    return std::nullopt;
  }

  /// A line of data after *INSTANCE shifts the part, a second one turns it by its last number.
  void require_unmoved() {
    constexpr std::size_t angle = 6;  // behind two points of the axis
    while (const auto line = data()) {
      const std::vector<std::string_view> fields = comma_fields(*line);
      for (std::size_t k = fields.size() > angle ? angle : 0; k < fields.size(); ++k)
        if (!fields[k].empty() && lines_.number_in(fields[k], "a shift or an angle") != 0)
          lines_.refuse(
              "*INSTANCE shifts or turns its part, which is read where *NODE has it; write the part in its "
              "place in the wheel");
    }
  }

  [[noreturn]] void refuse_system(const std::string& keyword) const {
    lines_.refuse(keyword + " gives coordinates in another system; write them as global x, y, z");
  }

  void read_nodes(const Keyword& keyword) {
    if (const std::string system = upper(keyword.value("SYSTEM")); !system.empty() && system != "R")
      refuse_system("*NODE, SYSTEM=" + system);
    while (const auto line = data()) {
      const std::vector<std::string_view> fields = comma_fields(*line);
      const Eigen::Vector3d at = point_in(fields, 1);
      const long number = lines_.whole_in(fields.front(), "a node's number");
      add_node(lines_.number(), number, at);
      if (keyword.has("NSET")) mesh_.node_sets[keyword.value("NSET")].push_back(number);
    }
  }

  /// The number of nodes of a solid of this type (C3D20R, C3D10M), or 0 for an element that is no solid.
  std::size_t nodes_of_type(const std::string& type) const {
    if (starts_with_any(type, sheets_and_lines) || starts_with_any(type, masses_and_connectors)) return 0;
    for (const char* linear : {"C3D8", "C3D6", "C3D5", "C3D4"})
      if (type.starts_with(linear)) refuse_linear(lines_.number(), type);
    for (const int nodes : {20, 15, 10})
      if (type.starts_with("C3D" + std::to_string(nodes))) return static_cast<std::size_t>(nodes);
    lines_.refuse((type.empty() ? "elements without a TYPE" : "elements of type " + type) +
                  " are not known; C3D10, C3D15 and C3D20 (also C3D10M, C3D20R) are, and shells and beams are left "
                  "out; mesh every volume with these solids, or delete the elements");
  }

  void read_elements(const Keyword& keyword) {
    const std::string type = upper(keyword.value("TYPE"));
    const std::size_t width = nodes_of_type(type);
    const std::string set = keyword.value("ELSET");
    std::vector<long> numbers;
    bool goes_on = false;
    while (const auto line = data()) {
      for (const std::string_view field : comma_fields(*line))
        if (!field.empty()) numbers.push_back(lines_.whole_in(field, "a number of an element or a node"));
      goes_on = trimmed(*line).ends_with(',') || (width > 0 && numbers.size() <= width);
      if (goes_on && numbers.size() <= width) continue;
      if (width > 0 && numbers.size() != width + 1)
        lines_.refuse("an element of type " + type + " has " + std::to_string(numbers.size() - 1) + " nodes");
      add_element(numbers, type, set);
      numbers.clear();
    }
    if (!numbers.empty()) lines_.refuse("the last element of type " + type + " lacks nodes; is the file cut off?");
  }

  void add_element(const std::vector<long>& numbers, const std::string& type, const std::string& set) {
    if (numbers.empty()) return;
    const std::vector<long> nodes(numbers.begin() + 1, numbers.end());
    if (type.starts_with("C3D"))
      mesh_.cells.push_back({numbers.front(), nodes});
    else
      mesh_.others[numbers.front()] = nodes;
    if (starts_with_any(type, masses_and_connectors)) ++mesh_.not_read[type];
    if (!set.empty()) mesh_.cell_sets[set].push_back(numbers.front());
  }

  void add_range(const std::vector<std::string_view>& fields, std::vector<long>& set) {
    constexpr long most = 10000000;
    if (fields.size() < 2) lines_.refuse("GENERATE takes first, last, step");
    const long first = lines_.whole_in(fields[0], "the first number"), last = lines_.whole_in(fields[1], "the last");
    const long step = fields.size() > 2 && !fields[2].empty() ? lines_.whole_in(fields[2], "the step") : 1;
    if (step <= 0 || last < first || (last - first) / step > most)
      lines_.refuse("GENERATE takes first, last, step, with last after first");
    for (long number = first; number <= last; number += step) set.push_back(number);
  }

  static void append(const std::vector<long>& members, std::vector<long>& set) {
    set.insert(set.end(), members.begin(), members.end());
  }

  /// Those of the set that the word names, or the number that it is.
  std::vector<long> members(std::string_view word, const Sets& sets, const char* meaning) const {
    const auto known = sets.find(name_in(word));
    return known != sets.end() ? known->second : std::vector{lines_.whole_in(word, meaning)};
  }

  void read_set(const Keyword& keyword, const std::string& name, Sets& sets) {
    std::vector<long> set;
    if (keyword.name == "NSET" && keyword.has("ELSET")) add_nodes_of(keyword.value("ELSET"), set);
    while (const auto line = data()) {
      const std::vector<std::string_view> fields = comma_fields(*line);
      if (keyword.has("GENERATE")) {
        add_range(fields, set);
        continue;
      }
      for (const std::string_view field : fields)
        if (!field.empty()) append(members(field, sets, "a number, or a set that stands before"), set);
    }
    append(set, sets[name]);
  }

  void add_nodes_of(const std::string& cell_set, std::vector<long>& set) {
    const auto cells = mesh_.cell_sets.find(cell_set);
    if (cells == mesh_.cell_sets.end())
      lines_.refuse("\"" + cell_set + "\" must be a set of elements that stands before");
    for (const long number : cells->second) {
      const ForeignCell* cell = cell_numbered(number);
      const auto other = mesh_.others.find(number);
      if (cell != nullptr) append(cell->nodes, set);
      if (other != mesh_.others.end()) append(other->second, set);
    }
  }

  /// Null if the element is no solid that was read before.
  const ForeignCell* cell_numbered(long number) {
    for (std::size_t k = cell_of_.size(); k < mesh_.cells.size(); ++k) cell_of_.emplace(mesh_.cells[k].number, k);
    const auto known = cell_of_.find(number);
    return known == cell_of_.end() ? nullptr : &mesh_.cells[known->second];
  }

  /// A surface is a set of nodes or of faces of elements: "12, S3" or "set, S3".
  void read_surface(const Keyword& keyword) {
    std::vector<long>& set = mesh_.surfaces[keyword.value("NAME")];
    const bool nodes = upper(keyword.value("TYPE")) == "NODE";
    while (const auto line = data()) {
      const std::vector<std::string_view> fields = comma_fields(*line);
      if (nodes) {
        append(members(fields.front(), mesh_.node_sets, "a node, or a set that stands before"), set);
        continue;
      }
      if (fields.size() < 2) lines_.refuse("a face of a surface is given as ELEMENT, S1 to S6");
      const std::string face = upper(fields[1]);
      for (const long cell : members(fields.front(), mesh_.cell_sets, "an element, or a set"))
        add_face(cell, face, set);
    }
  }

  /// Faces S1, S2, ... of a tetrahedron and of a wedge are counted as those of our kinds of cells, a brick's are not.
  void add_face(long cell, const std::string& face, std::vector<long>& set) {
    static constexpr std::array<std::size_t, 6> of_brick = {4, 5, 2, 1, 3, 0};
    const ForeignCell* known = cell_numbered(cell);
    if (known == nullptr) return;  // the face of a shell
    const std::vector<long>& nodes = known->nodes;
    const CellKind& kind = cell_kind(static_cast<int>(nodes.size()));
    const std::size_t at = face.size() == 2 && face[0] == 'S' ? static_cast<std::size_t>(face[1] - '1') : 99;
    if (at >= kind.faces.size()) lines_.refuse("\"" + face + "\" is no face of an element, S1 to S6");
    const std::vector<int>& corners = kind.faces[kind.corners == 8 ? of_brick.at(at) : at];
    for (std::size_t k = 0; k < corners.size(); ++k) {
      set.push_back(nodes[corners[k]]);
      set.push_back(nodes[kind.middle_of(corners[k], corners[(k + 1) % corners.size()])]);
    }
  }

  std::map<long, std::size_t> cell_of_;
  std::set<std::string> instanced_;  // parts
};

}  // namespace

ForeignMesh read_inp(const NamedText& file) {
  return InpReader(file).read();
}

}  // namespace tiprub::mesh
