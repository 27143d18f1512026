// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/case_file.h"
#include "cases/program/text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "cases/program/case_settings.h"
#include "cases/program/digest.h"
#include "cases/program/text_file.h"

namespace tiprub {

namespace {

constexpr std::array<std::string_view, 6> program_tables = {"mesh",     "reduce",      "casing",
                                                            "simulate", "postprocess", "material"};

/// "[[0, 1], [0.5, 2]]"
template <class Row>
std::string listed_rows(const std::vector<Row>& rows) {
  return "[" + listed(rows, ", ", [](const Row& row) { return "[" + listed(row, ", ", shortest) + "]"; }) + "]";
}

toml::table parse_case(const std::string& text, const std::string& file) {
  require_short_keys(text, file);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw InputError(place(file, error.source()) + "not TOML: " + std::string(error.description()));
  }
}

}  // namespace

struct CaseTable::Node {
  std::string file;
  std::string path;  ///< dotted name of this table, for messages
  /// This is never a copy, because toml++ drops the positions of what it copies. A table inside another one keeps the
  /// whole alive.
  std::shared_ptr<const toml::table> values = std::make_shared<toml::table>();
  std::vector<std::string> asked;
  mutable std::set<std::string, std::less<>> looked_for;  ///< keys of which only the presence was asked
  struct Setting {
    std::string key, value, unit;
    std::string digest = {};  ///< of the file that the value names
  };
  std::vector<Setting> settings;                         ///< what was read, in the order of reading
  std::map<std::string, std::vector<std::string>> rows;  ///< of a list: where each of its rows stands
  /// Those that were read, also by the tables inside.
  std::shared_ptr<std::vector<std::filesystem::path>> files = std::make_shared<std::vector<std::filesystem::path>>();
  std::vector<std::pair<std::string, std::shared_ptr<Node>>> children;

  std::string where(const toml::node* node) const {
    return place(file, node != nullptr ? node->source() : values->source());
  }
  /// `at` is where the value stands ("case.toml:3:1: ").
  [[noreturn]] void refuse(const std::string& at, std::string_view key, const std::string& what) const {
    throw InputError(at + "[" + path + "] " + std::string(key) + what);
  }
  [[noreturn]] void refuse(const toml::node& node, std::string_view key, const std::string& what) const {
    refuse(where(&node), key, what);
  }
  const toml::node* ask(std::string_view key, bool required) {
    asked.emplace_back(key);
    const toml::node* node = values->get(key);
    if (node == nullptr && required)
      throw InputError(where(values.get()) + "[" + path + "] has no " + std::string(key) +
                       ", and it has no default; add it");
    return node;
  }
  void note(std::string_view key, const std::string& value, std::string_view unit) {
    settings.push_back({std::string(key), value, std::string(unit)});
  }
  double number_at(const toml::node& node, std::string_view key, const Range& range, std::string_view unit) const {
    const auto value = node.value<double>();
    if (!node.is_number() || !value) refuse(node, key, " is not a number");
    return checked(*value, where(&node), key, range, unit);
  }
  double checked(double value, const std::string& at, std::string_view key, const Range& range,
                 std::string_view unit) const {
    const std::string said = " = " + shortest(value) + " must be ";
    if (!std::isfinite(value)) refuse(at, key, said + "a finite number");
    if (!range.holds(value))
      refuse(at, key, said + range.describe() + (unit.empty() ? "" : " [" + std::string(unit) + "]"));
    return value;
  }
  std::filesystem::path path_beside(const std::string& name) const {
    return files->emplace_back(std::filesystem::path(file).parent_path() / name);
  }
  /// The file that the key which was read last names.
  NamedText noted(NamedText named) {
    Digest digest;
    digest.add(named.text);
    settings.back().digest = digest.digits();
    return named;
  }

  /// A row of a list: its numbers, and where the first and the last of them stand.
  struct Row {
    std::string at, at_last;
    std::vector<double> numbers;
  };
  std::vector<Row> rows_of_file(const std::string& name, std::size_t columns, std::string_view meaning) const {
    const NamedText text = read_named_text(path_beside(name), "a file of numbers");
    std::vector<Row> found;
    for (const NumberLine& line : lines_below_heading(text)) {
      require_words(text, line, columns, meaning);
      const std::string at = text.name + ":" + std::to_string(line.number) + ": ";
      Row row{at, at, {}};
      for (std::size_t word = 0; word < columns; ++word) row.numbers.push_back(number_in(text, line, word, meaning));
      found.push_back(std::move(row));
    }
    if (found.empty()) throw InputError(text.name + ": has no line of numbers");
    return found;
  }
  std::vector<Row> rows_of_list(const toml::array& list, std::string_view key, std::size_t columns) const {
    std::vector<Row> found;
    for (const toml::node& item : list) {
      const toml::array* pair = item.as_array();
      if (columns > 1 && (pair == nullptr || pair->size() != columns))
        refuse(item, key, " must be a list of " + items_of(columns));
      Row row{where(&item), where(columns > 1 ? pair->get(columns - 1) : &item), {}};
      for (std::size_t i = 0; i < columns; ++i)
        row.numbers.push_back(number_at(columns > 1 ? *pair->get(i) : item, key, Range::any(), ""));
      found.push_back(std::move(row));
    }
    return found;
  }
  /// The rows of a list of numbers or of [x, y] pairs, or of the file that stands in its place.
  std::vector<Row> rows_of(const toml::node& node, std::string_view key, std::size_t columns) {
    std::vector<Row> found;
    const toml::array* list = node.as_array();
    if (node.is_string())
      found = rows_of_file(*node.value<std::string>(), columns, std::string(key) + (columns == 2 ? ": x, y" : ""));
    else if (list == nullptr || list->empty())
      refuse(node, key, " must be a list of " + items_of(columns) + ", at least one, or the name of a file");
    else
      found = rows_of_list(*list, key, columns);
    std::vector<std::string>& places = rows[std::string(key)];
    for (const Row& row : found) places.push_back(row.at_last);
    return found;
  }
};

bool Range::holds(double value) const {
  return (low_end == LowEnd::included ? value >= low : value > low) && value <= high;  // false for NaN
}

std::string Range::describe() const {
  const bool has_low = low > -std::numeric_limits<double>::infinity();
  const bool has_high = high < std::numeric_limits<double>::infinity();
  std::string above = (low_end == LowEnd::included ? "at least " : "more than ") + shortest(low);
  if (has_low && has_high) return above + " and at most " + shortest(high);
  if (has_low) return above;
  return has_high ? "at most " + shortest(high) : "a finite number";
}

CaseTable::CaseTable(std::shared_ptr<Node> node) : node_(std::move(node)) {}

bool CaseTable::has(std::string_view key) const {
  node_->looked_for.emplace(key);
  return node_->values->contains(key);
}

bool CaseTable::is_one_number(std::string_view key) const {
  const toml::node* node = node_->values->get(key);
  return node == nullptr || node->is_number();
}

double CaseTable::number(std::string_view key, std::optional<double> fallback, const Range& range,
                         std::string_view unit) {
  const toml::node* node = node_->ask(key, !fallback);
  const double value = node != nullptr ? node_->number_at(*node, key, range, unit) : *fallback;
  node_->note(key, shortest(value), unit);
  return value;
}

int CaseTable::integer(std::string_view key, std::optional<int> fallback, const Range& range, std::string_view unit) {
  const toml::node* node = node_->ask(key, !fallback);
  int value = fallback.value_or(0);
  if (node != nullptr) {
    if (!node->is_integer()) node_->refuse(*node, key, " is not a whole number");
    const double wide = node_->number_at(*node, key, range, unit);
    if (std::abs(wide) > std::numeric_limits<int>::max()) node_->refuse(*node, key, " is too large");
    value = static_cast<int>(wide);
  }
  node_->note(key, std::to_string(value), unit);
  return value;
}

bool CaseTable::flag(std::string_view key, bool fallback) {
  const toml::node* node = node_->ask(key, false);
  if (node != nullptr && !node->is_boolean()) node_->refuse(*node, key, " must be true or false");
  const bool value = node != nullptr ? node->value<bool>().value() : fallback;
  node_->note(key, value ? "true" : "false", "");
  return value;
}

std::string CaseTable::text(std::string_view key, std::optional<std::string> fallback) {
  const toml::node* node = node_->ask(key, !fallback);
  if (node != nullptr && !node->is_string()) node_->refuse(*node, key, " must be a text in quotes");
  std::string value = node != nullptr ? node->value<std::string>().value() : std::move(*fallback);
  node_->note(key, in_quotes(value), "");
  return value;
}

NamedText CaseTable::file(std::string_view key, std::string_view kind) {
  return node_->noted(read_named_text(node_->path_beside(text(key, std::nullopt)), std::string(kind)));
}

NamedText CaseTable::large_file(std::string_view key, std::string_view kind) {
  return node_->noted(read_named_bytes(node_->path_beside(text(key, std::nullopt)), std::string(kind)));
}

std::vector<double> CaseTable::numbers(std::string_view key, std::optional<std::vector<double>> fallback,
                                       const Range& range, std::string_view unit) {
  const toml::node* node = node_->ask(key, !fallback);
  std::vector<double> values = node == nullptr ? std::move(*fallback) : std::vector<double>{};
  if (node != nullptr)
    for (const Node::Row& row : node_->rows_of(*node, key, 1))
      values.push_back(node_->checked(row.numbers[0], row.at, key, range, unit));
  node_->note(key, "[" + listed(values, ", ", shortest) + "]", unit);
  return values;
}

std::vector<std::array<double, 2>> CaseTable::points(std::string_view key,
                                                     std::optional<std::vector<std::array<double, 2>>> fallback,
                                                     const Range& range, std::string_view unit) {
  const toml::node* node = node_->ask(key, !fallback);
  auto values = node == nullptr ? std::move(*fallback) : std::vector<std::array<double, 2>>{};
  if (node != nullptr)
    for (const Node::Row& row : node_->rows_of(*node, key, 2)) {
      const double x = row.numbers[0];
      if (!values.empty() && x <= values.back()[0])
        node_->refuse(row.at, key,
                      " must be a list of [x, y] pairs with x increasing; " + shortest(x) + " follows " +
                          shortest(values.back()[0]));
      values.push_back({x, node_->checked(row.numbers[1], row.at_last, key, range, unit)});
    }
  node_->note(key, listed_rows(values), unit);
  return values;
}

std::vector<std::vector<double>> CaseTable::rows(std::string_view key, std::size_t columns, const Range& last,
                                                 std::string_view unit) {
  std::vector<std::vector<double>> values;
  for (const Node::Row& row : node_->rows_of(*node_->ask(key, true), key, columns)) {
    values.push_back(row.numbers);
    node_->checked(values.back().back(), row.at_last, key, last, unit);
  }
  node_->note(key, listed_rows(values), unit);
  return values;
}

std::string CaseTable::choose(std::string_view key, std::optional<std::string> fallback,
                              const std::vector<std::string>& names) {
  const toml::node* node = node_->ask(key, !fallback);
  std::string value = std::move(fallback).value_or("");
  if (node != nullptr) {
    value = node->value<std::string>().value_or("");
    if (!node->is_string() || std::ranges::find(names, value) == names.end())
      node_->refuse(*node, key,
                    (node->is_string() ? " = \"" + value + "\"" : "") + " must be one of: " + listed(names, ", "));
  }
  node_->note(key, '"' + value + '"', "one of " + listed(names, ", "));
  return value;
}

CaseTable CaseTable::table(std::string_view key) {
  const toml::node* node = node_->ask(key, false);
  auto child = std::make_shared<Node>();
  child->file = node_->file;
  child->path = node_->path + "." + std::string(key);
  child->files = node_->files;
  if (node != nullptr) {
    if (!node->is_table()) throw InputError(node_->where(node) + "[" + child->path + "] must be a table");
    child->values = {node_->values, node->as_table()};
  }
  node_->children.emplace_back(key, child);
  return CaseTable(child);
}

void CaseTable::reject(std::string_view key, const std::string& message, std::optional<std::size_t> row) const {
  const toml::node* node = node_->values->get(key);
  const auto rows = node_->rows.find(std::string(key));
  const bool is_list = rows != node_->rows.end();
  if (is_list && row) node_->refuse(rows->second.at(*row), key, " " + message);
  const bool in_file = is_list && node->is_string();
  node_->refuse(node_->where(node), key, (in_file ? " = " + in_quotes(**node->as_string()) : "") + " " + message);
}

void CaseTable::only_with(std::string_view key, std::string_view setting) const {
  if (node_->values->contains(key))
    reject(key, "belongs to " + std::string(setting) + "; set that, or remove this key");
}

void CaseTable::close() const {
  std::vector<std::string> known = node_->asked;
  for (const std::string& key : node_->looked_for)
    if (std::ranges::find(known, key) == known.end()) known.push_back(key);
  for (const auto& [key, value] : *node_->values)
    if (std::ranges::find(node_->asked, key.str()) == node_->asked.end())
      throw InputError(place(node_->file, key.source()) + "unknown key \"" + std::string(key.str()) + "\" in [" +
                       node_->path + "]" + meant(key.str(), known) + "; known: " + listed(known, ", "));
  for (const auto& [key, child] : node_->children) CaseTable(child).close();
}

const std::vector<std::filesystem::path>& CaseTable::files() const {
  return *node_->files;
}

CaseSettings CaseTable::settings() const {
  CaseSettings settings;
  for (const Node::Setting& one : node_->settings) settings.emplace_back(one.key, one.value + one.digest);
  return settings;
}

std::string CaseTable::written() const {
  return text_of(*node_->values, "\n");
}

std::string CaseTable::resolved() const {
  std::string text;
  for (const auto& [key, value, unit, digest] : node_->settings) {
    const std::string remark = digest.empty() ? unit : "digest " + digest;
    text += key + " = " + value + (remark.empty() ? "" : "  # " + remark) + "\n";
  }
  for (const auto& [key, child] : node_->children) text += "[" + child->path + "]\n" + CaseTable(child).resolved();
  return text;
}

CaseFile::CaseFile(const std::filesystem::path& path, const std::vector<std::string>& settings)
    : source_(read_named_text(path, "a case file").text), root_(std::make_shared<CaseTable::Node>()) {
  root_->file = path.string();
  toml::table values = parse_case(source_, root_->file);
  if (!settings.empty() && !source_.ends_with('\n')) source_ += '\n';
  for (const std::string& setting : settings) {
    apply_setting(values, setting);
    source_ += "# " + setting_origin(setting) + "\n";
  }
  root_->values = std::make_shared<const toml::table>(std::move(values));
  for (const auto& [key, value] : *root_->values) {
    const bool is_table = std::ranges::find(program_tables, key.str()) != program_tables.end();
    if (is_table ? value.is_table() : (key.str() == "title" && value.is_string())) continue;
    throw InputError(root_->where(&value) + "\"" + std::string(key.str()) +
                     "\" is not known here; known: title (a text), and the tables " + listed(program_tables, ", "));
  }
  title_ = (*root_->values)["title"].value_or(std::string());
}

std::string CaseFile::resolved(std::string_view name, const std::function<void(CaseTable&)>& read) const {
  CaseTable values = table(name);
  read(values);
  return "[" + std::string(name) + "]\n" + values.resolved();
}

bool CaseFile::has(std::string_view name) const {
  return root_->values->contains(name);
}

CaseTable CaseFile::table(std::string_view name) const {
  const toml::table* values = (*root_->values)[name].as_table();
  if (values == nullptr) throw InputError(root_->file + ": has no [" + std::string(name) + "] table; add it");
  auto node = std::make_shared<CaseTable::Node>();
  node->file = root_->file;
  node->path = name;
  node->values = {root_->values, values};
  return CaseTable(node);
}

void require_usual(const CaseTable& table, std::string_view key, double value, const Range& usual,
                   std::string_view unit) {
  if (usual.holds(value)) return;
  table.reject(key, text_of("= ", value, " is unusual: expected ", usual.describe(), " [", unit,
                            "]; is it in another unit? If it is meant, add unusual = true to this table"));
}

}  // namespace tiprub
