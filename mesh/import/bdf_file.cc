// SPDX-License-Identifier: GPL-3.0-or-later
// Nastran's bulk data: free, small and large fields. Properties become cell sets "PID 3", constraints and sets of the
// case control node sets "SPC 1", "SET 1".
#include <algorithm>
#include <map>
#include <set>

#include "cases/program/text.h"
#include "mesh/cells/cell_kind.h"
#include "mesh/import/foreign_mesh.h"

namespace tiprub::mesh {

namespace {

constexpr std::size_t small_width = 8, large_width = 16;

/// An entry with its continuation lines.
struct Card {
  std::string name;
  std::vector<std::string> fields;  ///< after the name
  int line = 0;
};

class BdfReader : MeshReader {
 public:
  explicit BdfReader(const NamedText& file) : MeshReader(file) {}

  ForeignMesh read() {
    Card card;
    while (const auto line = lines_.next()) {
      const std::string_view text = line->substr(0, line->find('$'));
      if (trimmed(text).empty()) continue;
      require_one_section(text);
      const std::vector<std::string> fields = fields_of(text);
      const bool goes_on = fields[0].empty() || fields[0][0] == '+' || fields[0][0] == '*';
      if (goes_on && !card.name.empty()) {
        card.fields.insert(card.fields.end(), fields.begin() + 1, fields.end());
        continue;
      }
      take(card);
      card = {upper(fields[0]), {fields.begin() + 1, fields.end()}, lines_.number()};
      if (card.name.ends_with('*')) card.name.pop_back();
      require_written_out(card.name);
      if (card.name == "ENDDATA") break;
      if (card.name.starts_with("SET ")) read_case_set(text, card);
    }
    take(card);
    return std::move(mesh_);
  }

 private:
  /// A superelement or a module has node numbers of its own, and a place that other entries give.
  void require_one_section(std::string_view text) const {
    const std::vector<std::string_view> words = words_of(text);
    const std::string first = upper(words[0]);
    if (first.starts_with("INCLUDE")) refuse_other_file("INCLUDE");
    if (first == "BEGIN" && (words.size() > 2 || (words.size() == 2 && upper(words[1]) != "BULK")))
      lines_.refuse(upper(trimmed(text)) +
                    " begins a part of its own; write the model as one part, after BEGIN BULK");
  }

  /// "=" repeats the fields of the entry before.
  void require_written_out(const std::string& name) const {
    static const std::set<std::string> rules = {"CGEN", "CSUPER", "EGRID", "GRIDG", "SEBULK"};
    if (rules.contains(name) || name.starts_with('=')) refuse_rule(name);
  }

  /// The name and eight fields (or four large ones); those that the line lacks are empty.
  std::vector<std::string> fields_of(std::string_view line) const {
    std::vector<std::string> fields;
    const bool free = line.find(',') != std::string_view::npos;
    const std::string_view name = line.substr(0, free ? line.find(',') : small_width);
    const bool large = name.find('*') != std::string_view::npos;
    const std::size_t data = large ? 4 : 8;  // a further field names the next line
    if (free) {
      for (const std::string_view field : comma_fields(line)) fields.emplace_back(field);
    } else {
      fields.emplace_back(trimmed(name));
      const std::string_view rest = line.substr(std::min(small_width, line.size()));
      for (const std::string_view field : column_fields(rest, large ? large_width : small_width))
        fields.emplace_back(field);
    }
    fields.resize(data + 1);
    return fields;
  }

  void take(const Card& card) {
    static const std::map<std::string, int> solids = {{"CTETRA", 4}, {"CPYRAM", 5}, {"CPENTA", 6}, {"CHEXA", 8}};
    if (card.name == "GRID") add_grid(card);
    if (card.name == "GRDSET") require_basic_system(card);
    if (const auto known = solids.find(card.name); known != solids.end())
      add_solid(card, known->second);
    else if (is_volume(card.name))
      refuse_solid(card.line, card.name, "CTETRA, CPYRAM, CPENTA and CHEXA");
    if (card.name == "CTRIA6" || card.name == "CQUAD8" || card.name == "CTRIA3" || card.name == "CQUAD4")
      add_shell(card);
    if (card.name == "PSOLID") mesh_.materials.insert(field(card, 1));
    if (is_mass_or_constraint(card)) ++mesh_.not_read[card.name];
    if (card.name == "SPC1") add_set("SPC " + field(card, 0), card.fields, 2);
    if (card.name == "SPC")
      for (const std::size_t at : {1, 4})
        if (!field(card, at).empty()) mesh_.node_sets["SPC " + field(card, 0)].push_back(whole(card, at, "a node"));
  }

  /// Older, composite and interface solids, and those of other programs (CHEX20, CPYRA, CWEDGE).
  static bool is_volume(const std::string& name) {
    for (const char* first : {"CTETR", "CPYRA", "CPENT", "CHEX", "CIHEX", "CIFHEX", "CIFPENT", "CWEDGE"})
      if (name.starts_with(first)) return true;
    return false;
  }

  /// The case control has lines such as "MPC     = 5", too.
  static bool is_mass_or_constraint(const Card& card) {
    static const std::set<std::string> names = {"CONM1", "CONM2", "CMASS1", "CMASS2", "CMASS3",  "CMASS4", "MPC",
                                                "RBAR",  "RBAR1", "RROD",   "RTRPLT", "RSPLINE", "RBE1",   "RBE2",
                                                "RBE3",  "CBUSH", "CELAS1", "CELAS2", "CELAS3",  "CELAS4"};
    const std::string number = field(card, 0);
    return names.contains(card.name) && !number.empty() && number.front() >= '0' && number.front() <= '9';
  }

  static std::string field(const Card& card, std::size_t at) {
    return at < card.fields.size() ? card.fields[at] : "";
  }
  long whole(const Card& card, std::size_t at, const char* meaning) const {
    return lines_.whole_in(field(card, at), meaning);
  }

  void require_basic_system(const Card& card) const {
    if (const std::string system = field(card, 1); !system.empty() && system != "0")
      refuse_line(
          lines_.file(), card.line,
          card.name + " gives places in coordinate system " + system + "; write the file in the basic system, 0");
  }

  void add_grid(const Card& card) {
    require_basic_system(card);
    const Eigen::Vector3d at = point_in(card.fields, 2);
    add_node(card.line, whole(card, 0, "a node's number"), at);
  }

  /// Nastran lists the mid-side nodes of a brick's or a wedge's upright edges before those of the upper face.
  void add_solid(const Card& card, int corners) {
    static const std::map<int, std::vector<std::size_t>> order = {
        {4, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}},
        {5, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}},
        {6, {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11}},
        {8, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15}}};
    ForeignCell cell{whole(card, 0, "an element's number"), {}};
    for (const std::size_t at : order.at(corners)) {
      if (field(card, at + 2).empty()) refuse_linear(card.line, card.name + " without mid-side nodes");
      cell.nodes.push_back(whole(card, at + 2, "a node"));
    }
    mesh_.cell_sets["PID " + field(card, 1)].push_back(cell.number);
    mesh_.cells.push_back(std::move(cell));
  }

  void add_shell(const Card& card) {
    const long number = whole(card, 0, "an element's number");
    const std::size_t count = card.name == "CQUAD8" ? 8 : card.name == "CTRIA6" ? 6 : card.name == "CQUAD4" ? 4 : 3;
    for (std::size_t at = 2; at < count + 2; ++at)
      if (!field(card, at).empty()) mesh_.others[number].push_back(whole(card, at, "a node"));
    mesh_.cell_sets["PID " + field(card, 1)].push_back(number);
  }

  /// Adds numbers, and ranges "first THRU last". EXCEPT takes numbers out of the range before it, up to a number
  /// beyond its end, which is a member again.
  void add_set(const std::string& name, const std::vector<std::string>& words, std::size_t first) {
    constexpr long most = 10000000;
    std::vector<long>& set = mesh_.node_sets[name];
    long last = 0;  // of the latest range
    bool excepting = false;
    for (std::size_t at = first; at < words.size(); ++at) {
      if (words[at].empty()) continue;
      if (upper(words[at]) == "EXCEPT") {
        if (last == 0) lines_.refuse("EXCEPT stands after a range, first THRU last");
        excepting = true;
        continue;
      }
      if (upper(words[at]) != "THRU") {
        const long number = lines_.whole_in(words[at], "a node");
        excepting = excepting && number <= last;
        if (excepting)
          std::erase(set, number);
        else
          set.push_back(number);
        continue;
      }
      last = at + 1 < words.size() ? lines_.whole_in(words[++at], "a node") : -1;
      if (set.empty() || last < set.back() || last - set.back() > most)
        lines_.refuse("THRU stands between a number and a larger one");
      for (long number = set.back() + 1; number <= last; ++number) set.push_back(number);
    }
  }

  static bool is_word_of_numbers(const std::string& word) {
    const std::string name = upper(word);
    return name == "THRU" || name == "EXCEPT" || name.find_first_not_of("0123456789") == std::string::npos;
  }

  /// Reads a set such as "SET 3 = 1, 2, THRU, 9". A comma at the end of a line continues it on the next. Sets of all
  /// nodes, of frequencies or of names are not of use here.
  void read_case_set(std::string_view text, Card& card) {
    std::string all(text);
    while (trimmed(all).ends_with(','))
      if (const auto more = lines_.next())
        all += more->substr(0, more->find('$'));
      else
        break;
    const std::size_t equals = all.find('=');
    card = {};
    if (equals == std::string::npos) return;
    std::vector<std::string> words;
    for (const std::string_view part : comma_fields(std::string_view(all).substr(equals + 1)))
      for (const std::string_view word : words_of(part)) words.emplace_back(word);
    if (!std::ranges::all_of(words, is_word_of_numbers)) return;
    add_set(upper(trimmed(std::string_view(all).substr(0, equals))), words, 0);
  }
};

}  // namespace

ForeignMesh read_bdf(const NamedText& file) {
  return BdfReader(file).read();
}

}  // namespace tiprub::mesh
