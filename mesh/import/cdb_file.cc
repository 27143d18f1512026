// SPDX-License-Identifier: GPL-3.0-or-later
// Ansys' archive, as CDWRITE makes it: ETBLOCK, NBLOCK and EBLOCK in columns, components as CMBLOCK.
#include <algorithm>
#include <map>
#include <set>

#include "cases/program/text.h"
#include "mesh/cells/cell_kind.h"
#include "mesh/import/foreign_mesh.h"

namespace tiprub::mesh {

namespace {

/// "(3i9,6e21.13e3)" or "(19i10)".
struct Columns {
  std::size_t whole_count = 0, whole_width = 0, number_width = 0;
};

class CdbReader : MeshReader {
 public:
  explicit CdbReader(const NamedText& file) : MeshReader(file) {}

  ForeignMesh read() {
    while (const auto line = lines_.next()) {
      const std::vector<std::string_view> words = comma_fields(*line);
      if (words.empty()) continue;
      const std::string name = upper(words[0]);
      require_written_out(name, words);
      note_system(name, words);
      if (name == "CP" || name == "CE") note_constraint(name, words);
      if (name == "ET" && words.size() > 2) types_[whole(words[1])] = type_of(words[2]);
      if (name == "ETBLOCK") read_types();
      if (name == "NBLOCK") read_nodes();
      if (name == "EBLOCK") read_elements(words);
      if (name == "CMBLOCK") read_component(words);
    }
    return std::move(mesh_);
  }

 private:
  /// N and EN with the number -1 end a list.
  void require_written_out(const std::string& name, const std::vector<std::string_view>& words) const {
    static const std::set<std::string> rules = {
        "N",     "FILL", "NGEN", "NSYM",  "NSCALE", "NMODIF", "NDELE",  "TRANSFER", "NUMMRG", "E",     "EN",
        "EMORE", "EMID", "EGEN", "ENGEN", "ESYM",   "ENSYM",  "EMODIF", "EDELE",    "VMESH",  "VSWEEP"};
    static const std::set<std::string> readers = {"/INPUT", "CDREAD", "NREAD", "EREAD", "UPGEOM"};
    if (readers.contains(name)) refuse_other_file(name);
    if (rules.contains(name) && std::ranges::find(words, "-1") == words.end()) refuse_rule(name);
  }

  /// NBLOCK takes places in the active system. These commands define a system and activate it, but not where CDWRITE
  /// lists the systems (LOCAL,R5.0,LOC,...).
  void note_system(const std::string& name, const std::vector<std::string_view>& words) {
    static const std::set<std::string> defining = {"LOCAL", "CLOCAL", "CS", "CSKP", "CSWPLA"};
    const std::string first = words.size() > 1 ? upper(words[1]) : "";
    if (name == "CSYS") system_ = first;
    if (defining.contains(name) && !first.starts_with('R')) system_ = first;
    if (name == "NBLOCK" && !system_.empty() && system_ != "0")
      lines_.refuse("NBLOCK gives places in coordinate system " + system_ +
                    "; write them in the global one (CSYS,0)");
  }

  /// CP and CE are "CE,2,0,..." or, from CDWRITE, "CE,R5.0,DEFI,2,...", which lines "CE,R5.0,NODE,..." go on. Further
  /// lines of the same number add nodes.
  void note_constraint(const std::string& name, const std::vector<std::string_view>& words) {
    const bool written = words.size() > 3 && upper(words[1]).starts_with('R');
    if (words.size() < 2 || (written && upper(words[2]) == "NODE")) return;
    if (constraints_.emplace(name, written ? words[3] : words[1]).second) ++mesh_.not_read[name];
  }

  long whole(std::string_view word) const { return lines_.whole_in(word, "a number of the archive"); }

  /// "186" or "SOLID186".
  long type_of(std::string_view word) const {
    const std::size_t digit = word.find_first_of("0123456789");
    return digit == std::string_view::npos ? 0 : whole(word.substr(digit));
  }

  Columns read_columns() {
    const auto line = lines_.next();
    Columns columns;
    const std::string text = line ? upper(trimmed(*line)) : "";
    const auto count_at = [&](std::size_t at) {
      std::size_t value = 0;
      for (; at < text.size() && text[at] >= '0' && text[at] <= '9'; ++at) value = 10 * value + (text[at] - '0');
      return value;
    };
    const std::size_t i = text.find('I'), e = text.find_first_of("EG");
    if (text.starts_with('(') && i != std::string::npos) {
      columns = {count_at(1), count_at(i + 1), e == std::string::npos ? 0 : count_at(e + 1)};
    }
    constexpr std::size_t most = 1000;
    if (columns.whole_count == 0 || columns.whole_width == 0 || columns.whole_count > most ||
        columns.whole_width > most || columns.number_width > most)
      lines_.refuse("must be the columns of the block, as (3i9,6e21.13e3) or (19i10)");
    return columns;
  }

  /// Of each type its number and Ansys' own.
  void read_types() {
    const Columns columns = read_columns();
    while (const auto line = lines_.next()) {
      const std::vector<std::string_view> fields = column_fields(*line, columns.whole_width);
      if (!fields.empty() && fields[0] == "-1") return;
      if (fields.size() < 2) lines_.refuse("an element type has a number and Ansys' number");
      types_[whole(fields[0])] = type_of(fields[1]);
    }
    lines_.refuse("the block of element types has no end; is the file cut off?");
  }

  void read_nodes() {
    const Columns columns = read_columns();
    if (columns.number_width == 0) lines_.refuse("names no columns of coordinates");
    while (const auto line = lines_.next()) {
      if (line->starts_with('N') || trimmed(*line).starts_with('-')) return;
      const std::size_t wholes = columns.whole_count * columns.whole_width;
      const std::string_view rest = line->substr(std::min(wholes, line->size()));
      const Eigen::Vector3d at = point_in(column_fields(rest, columns.number_width), 0);
      add_node(lines_.number(), whole(trimmed(line->substr(0, columns.whole_width))), at);
    }
    lines_.refuse("the block of nodes has no end; is the file cut off?");
  }

  void read_elements(const std::vector<std::string_view>& words) {
    constexpr std::size_t head = 11, count_at = 8, number_at = 10, type_at = 1;
    if (std::ranges::none_of(words, [](std::string_view word) { return upper(word) == "SOLID"; }))
      lines_.refuse("EBLOCK without SOLID isn't known; write it by CDWRITE,DB");
    const Columns columns = read_columns();
    while (const auto line = lines_.next()) {
      std::vector<std::string_view> fields = column_fields(*line, columns.whole_width);
      if (!fields.empty() && fields[0] == "-1") return;
      if (fields.size() < head)
        lines_.refuse("an element's line has " + std::to_string(fields.size()) + " numbers, of 11 or more");
      const long count = whole(fields[count_at]), number = whole(fields[number_at]), type = whole(fields[type_at]);
      if (count < 1 || count > 20)
        lines_.refuse("an element has " + std::to_string(count) + " nodes; it must be 1 to 20");
      std::vector<long> nodes;
      for (std::size_t k = head; k < fields.size(); ++k) nodes.push_back(whole(fields[k]));
      while (nodes.size() < static_cast<std::size_t>(count))
        if (const auto more = lines_.next())
          for (const std::string_view field : column_fields(*more, columns.whole_width))
            nodes.push_back(whole(field));
        else
          lines_.refuse("the last element lacks nodes; is the file cut off?");
      add_element(number, types_.contains(type) ? types_.at(type) : type, nodes);
      if (!mesh_.cells.empty() && mesh_.cells.back().number == number) mesh_.materials.emplace(fields[0]);
    }
    lines_.refuse("the block of elements has no end; is the file cut off?");
  }

  void add_element(long number, long type, const std::vector<long>& nodes) {
    static const std::set<long> linear = {185, 45, 285}, bricks = {186, 95}, tetrahedra = {187, 92};
    // Other solids, solid shells, fluids, gaskets and superelements.
    static const std::set<long> other_volumes = {
        5,   30,  46,  50,  58,  62,  64,  65,  69,  70,  72,  73,  80,  86,  87,  89,  90,  96,  97,  98,
        107, 117, 119, 120, 122, 123, 127, 128, 142, 147, 148, 158, 164, 168, 190, 191, 194, 195, 204, 205,
        215, 216, 217, 220, 221, 225, 226, 227, 231, 232, 236, 237, 239, 240, 272, 273, 278, 279, 291};
    static const std::map<long, std::string> masses_and_constraints = {
        {14, "COMBIN14"}, {21, "MASS21"}, {40, "COMBIN40"}, {174, "CONTA174"}, {175, "CONTA175"}, {184, "MPC184"}};
    if (linear.contains(type)) refuse_linear(lines_.number(), "SOLID" + std::to_string(type));
    if (bricks.contains(type) && nodes.size() == 20)
      mesh_.cells.push_back({number, collapsed(nodes)});
    else if (tetrahedra.contains(type) && nodes.size() == 10)
      mesh_.cells.push_back({number, nodes});
    else if (bricks.contains(type) || tetrahedra.contains(type) || other_volumes.contains(type))
      refuse_solid(
          lines_.number(),
          "an element of Ansys' type " + std::to_string(type) + " with " + std::to_string(nodes.size()) + " nodes",
          "SOLID186 (or 95) with 20 nodes and SOLID187 (or 92) with 10");
    else
      mesh_.others[number] = nodes;
    if (const auto kind = masses_and_constraints.find(type); kind != masses_and_constraints.end())
      ++mesh_.not_read[kind->second];
  }

  /// A brick whose corners coincide is a wedge (K = L, O = P), a pyramid (M = N = O = P) or a tetrahedron (both).
  static std::vector<long> collapsed(const std::vector<long>& nodes) {
    static const std::vector<std::size_t> wedge = {0, 1, 2, 4, 5, 6, 8, 9, 11, 12, 13, 15, 16, 17, 18};
    static const std::vector<std::size_t> pyramid = {0, 1, 2, 3, 4, 8, 9, 10, 11, 16, 17, 18, 19};
    static const std::vector<std::size_t> tetrahedron = {0, 1, 2, 4, 8, 9, 11, 16, 17, 18};
    const bool flat_below = nodes[2] == nodes[3], pointed = nodes[4] == nodes[5] && nodes[5] == nodes[6];
    if (!flat_below && !pointed) return nodes;
    std::vector<long> kept;
    for (const std::size_t at : flat_below&& pointed ? tetrahedron : pointed ? pyramid : wedge)
      kept.push_back(nodes[at]);
    return kept;
  }

  /// A negative number ends a range that begins with the number before it.
  void read_component(const std::vector<std::string_view>& words) {
    if (words.size() < 4) lines_.refuse("CMBLOCK takes a name, NODE or ELEM, and a count");
    constexpr long most = 10000000;  // of a range
    const std::string name(words[1]);
    const bool nodes = upper(words[2]).starts_with("NODE");
    const long count = whole(trimmed(words[3].substr(0, words[3].find('!'))));
    const Columns columns = read_columns();
    std::vector<long>& set = (nodes ? mesh_.node_sets : mesh_.cell_sets)[name];
    for (long read = 0; read < count;) {
      const auto line = lines_.next();
      if (!line) lines_.refuse("the component " + name + " lacks numbers; is the file cut off?");
      const std::vector<std::string_view> fields = column_fields(*line, columns.whole_width);
      if (fields.empty()) lines_.refuse("the component " + name + " lacks numbers");
      for (const std::string_view field : fields) {
        const long number = whole(field);
        if (number < 0 && (set.empty() || -number < set.back() || -number - set.back() > most))
          lines_.refuse("a range of the component ends before it begins, or is longer than any");
        for (long k = number < 0 ? set.back() + 1 : number; k <= std::abs(number); ++k) set.push_back(k);
        ++read;
      }
    }
  }

  std::set<std::pair<std::string, std::string>> constraints_;  // CP and CE, by their numbers
  std::string system_;          // the active coordinate system; empty or 0 is the global one
  std::map<long, long> types_;  // Ansys' number of an element type (186), by its number in the archive
};

}  // namespace

ForeignMesh read_cdb(const NamedText& file) {
  return CdbReader(file).read();
}

}  // namespace tiprub::mesh
