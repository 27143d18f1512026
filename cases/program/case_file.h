// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "cases/program/errors.h"
#include "cases/program/named_values.h"
#include "cases/program/text_file.h"

namespace tiprub {

/// The values that a number in a case file may take. The ends are included unless `low_end` says otherwise.
struct Range {
  enum class LowEnd { included, excluded };

  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  LowEnd low_end = LowEnd::included;

  static Range any() { return {}; }
  static Range positive() { return {0.0, std::numeric_limits<double>::infinity(), LowEnd::excluded}; }
  static Range at_least(double low) { return {low, std::numeric_limits<double>::infinity(), LowEnd::included}; }
  static Range between(double low, double high) { return {low, high, LowEnd::included}; }
  bool holds(double value) const;
  std::string describe() const;
};

/// Keys, and their values as TOML writes them.
using CaseSettings = std::vector<std::pair<std::string, std::string>>;

/// One table of a case file. Every key is asked for by name, with its default, range and unit, and close() refuses
/// all other keys. All readers raise InputError with file:line:column, or with the setting that gave the value. A key
/// without a default (std::nullopt) must be present.
class CaseTable {
 public:
  struct Node;  ///< the toml node behind it; only the .cc files here know toml++
  explicit CaseTable(std::shared_ptr<Node> node);

  bool has(std::string_view key) const;
  /// Whether the key is absent or has one number, where it may also have a list.
  bool is_one_number(std::string_view key) const;
  double number(std::string_view key, std::optional<double> fallback, const Range& range, std::string_view unit);
  int integer(std::string_view key, std::optional<int> fallback, const Range& range, std::string_view unit);
  bool flag(std::string_view key, bool fallback);
  std::string text(std::string_view key, std::optional<std::string> fallback);
  /// The contents of the file that the key names. A relative path begins in the folder of the case; `kind` is what
  /// the file should be ("a blade file"). The digest of the file is noted among the settings, so that results become
  /// out of date when the file changes. Raises RunError if it can't be read.
  NamedText file(std::string_view key, std::string_view kind);
  /// The same for a file of any size and any bytes.
  NamedText large_file(std::string_view key, std::string_view kind);
  /// An array of numbers, or the name of a file beside the case with one number a line. It may begin with a heading.
  std::vector<double> numbers(std::string_view key, std::optional<std::vector<double>> fallback, const Range& range,
                              std::string_view unit);
  /// An array of [x, y] pairs with x strictly increasing, or the name of such a file; the range and the unit are
  /// those of y.
  std::vector<std::array<double, 2>> points(std::string_view key,
                                            std::optional<std::vector<std::array<double, 2>>> fallback,
                                            const Range& range, std::string_view unit);
  /// An array of rows of `columns` numbers each, or the name of such a file; the range is that of the last one. It
  /// has no default.
  std::vector<std::vector<double>> rows(std::string_view key, std::size_t columns, const Range& last,
                                        std::string_view unit);
  template <class Value>
  Value choice(std::string_view key, Value fallback,
               std::initializer_list<std::type_identity_t<NamedValue<Value>>> names) {
    return chosen<Value>(key, fallback, names);
  }
  template <class Value, std::size_t count>
  Value choice(std::string_view key, Value fallback, const NamedValues<Value, count>& names) {
    return chosen<Value>(key, fallback, names);
  }
  template <class Value>
  Value choice(std::string_view key, std::optional<Value> fallback, std::initializer_list<NamedValue<Value>> names) {
    return chosen<Value>(key, fallback, names);
  }
  /// A table inside this one. If it is absent, it reads as an empty one.
  CaseTable table(std::string_view key);

  /// Raises InputError at a key whose value does not fit to the other values; of a list that was read, at one of its
  /// rows, which may stand in a file of its own.
  [[noreturn]] void reject(std::string_view key, const std::string& message,
                           std::optional<std::size_t> row = std::nullopt) const;
  /// Raises InputError if the table has a key that means something only with another setting ("shape = \"bumps\"").
  void only_with(std::string_view key, std::string_view setting) const;
  /// Raises InputError at the first key that was not asked for, and lists the known ones.
  void close() const;
  /// All values that were read, defaults included: lines "key = value  # unit" in the order of reading.
  std::string resolved() const;
  /// The values that the case itself gives: TOML with sorted keys, without defaults and comments.
  std::string written() const;
  /// The files that were read because a key names them, for refuse_overwriting().
  const std::vector<std::filesystem::path>& files() const;
  /// The keys and values that were read, without the tables inside this one.
  CaseSettings settings() const;

 private:
  template <class Value, class Names>
  Value chosen(std::string_view key, std::optional<Value> fallback, const Names& names);
  std::string choose(std::string_view key, std::optional<std::string> fallback,
                     const std::vector<std::string>& names);

  std::shared_ptr<Node> node_;
};

/// A scene in one TOML file: one rotor, one casing and one range of speeds. Each program reads only its own tables.
class CaseFile {
 public:
  /// Each setting is "TABLE.KEY=VALUE" with a value as TOML writes it. It replaces the key of the file or adds it;
  /// without a value it removes the key. Raises RunError if the file can't be read. Raises InputError if the file or
  /// a setting is not TOML, or if it has a table at the top that no program knows.
  explicit CaseFile(const std::filesystem::path& path, const std::vector<std::string>& settings = {});

  const std::string& title() const { return title_; }
  /// The whole file as it was read, followed by a comment for each setting. Outputs keep it as their provenance.
  const std::string& source() const { return source_; }
  bool has(std::string_view name) const;
  /// Raises InputError if the table is absent.
  CaseTable table(std::string_view name) const;
  /// What a reader takes from a table, as CaseTable::resolved() gives it, below the name of the table. The text is
  /// the same for every spelling of the same values.
  std::string resolved(std::string_view name, const std::function<void(CaseTable&)>& read) const;

 private:
  std::string title_;
  std::string source_;
  std::shared_ptr<CaseTable::Node> root_;
};

template <class Value, class Names>
Value CaseTable::chosen(std::string_view key, std::optional<Value> fallback, const Names& names) {
  std::vector<std::string> known;
  std::optional<std::string> fallback_name;
  for (const auto& [value, name] : names) {
    known.emplace_back(name);
    if (fallback && *fallback == value) fallback_name = name;
  }
  const std::string name = choose(key, fallback_name, known);
  return names.begin()[std::ranges::find(known, name) - known.begin()].first;
}

/// Raises InputError at a key whose value is possible, but outside of what is usual for matter and machines: such
/// values are mostly numbers in another unit. A table that is read so has the key `unusual`, and is not checked if
/// that is true.
void require_usual(const CaseTable& table, std::string_view key, double value, const Range& usual,
                   std::string_view unit);

/// The keys of a case's text, "mesh.density", with their values as TOML writes them, the same for every spelling of a
/// value. The copy that an output keeps has the keys of the command line behind "# --set ". A text that is no case
/// has none.
std::map<std::string, std::string> written_keys(const std::string& text);

/// A key whose values in two texts differ; empty where a text lacks it.
struct DifferingKey {
  std::string key;
  std::optional<std::string> one, other;
};
std::vector<DifferingKey> differing_keys(const std::string& one, const std::string& other);

/// The keys of some tables, such as "mesh.", that both the case and a file have, with different values.
struct MadeOtherwise {
  /// For each of them, after a line break: "sector.msh was made with mesh.blade_count = 6, and the case has 8; " and
  /// the consequence.
  std::string lines;
  std::map<std::string, std::string> keys;  ///< their values in the file
};
MadeOtherwise made_otherwise(const std::string& file, const std::string& made_with, const std::string& case_text,
                             std::initializer_list<std::string_view> tables, const std::string& consequence);

}  // namespace tiprub
