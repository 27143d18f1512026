// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/program/errors.h"
#include "cases/program/text_file.h"

namespace tiprub {

/// The values a number in a case file may take, ends included unless said.
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

/// Keys and values, these as TOML writes them.
using CaseSettings = std::vector<std::pair<std::string, std::string>>;

/// One table of a case file, read as a closed world: every key is asked for by name, with its default, range and
/// unit, and close() refuses whatever was never asked for. All readers raise InputError with file:line:column, or
/// with the setting that gave the value.
/// A key without a default (std::nullopt) must be present.
class CaseTable {
 public:
  struct Node;  ///< the toml node behind it; only the .cc files here know toml++
  explicit CaseTable(std::shared_ptr<Node> node);

  bool has(std::string_view key) const;
  double number(std::string_view key, std::optional<double> fallback, const Range& range, std::string_view unit);
  int integer(std::string_view key, std::optional<int> fallback, const Range& range, std::string_view unit);
  bool flag(std::string_view key, bool fallback);
  std::string text(std::string_view key, std::optional<std::string> fallback);
  /// What is in the file that the key names, beside the case file if its path is relative; `kind` is what it should
  /// be ("a blade file"). Its digest is noted, so that what is made of it is out of date when it changes. Raises
  /// RunError if it can't be read.
  NamedText file(std::string_view key, std::string_view kind);
  /// An array of numbers, or the name of a file beside the case with one a line, below a heading if there is one.
  std::vector<double> numbers(std::string_view key, std::optional<std::vector<double>> fallback, const Range& range,
                              std::string_view unit);
  /// An array of [x, y] pairs with x strictly increasing, or the name of such a file; the range and the unit are
  /// those of y.
  std::vector<std::array<double, 2>> points(std::string_view key,
                                            std::optional<std::vector<std::array<double, 2>>> fallback,
                                            const Range& range, std::string_view unit);
  template <class Enum>
  Enum choice(std::string_view key, std::optional<Enum> fallback,
              std::initializer_list<std::pair<std::string_view, Enum>> names);
  /// A table inside this one; an absent one reads as an empty one.
  CaseTable table(std::string_view key);

  /// Raises InputError at a key whose value is allowed by itself and wrong beside another one.
  [[noreturn]] void reject(std::string_view key, const std::string& message) const;
  /// Raises InputError at the first key that nobody asked for, and lists the known ones.
  void close() const;
  /// What was read, defaults included: one "key = value  # unit" a line, in the order of reading.
  std::string resolved() const;
  /// What the case itself says in it, defaults left out: TOML, keys sorted, without comments.
  std::string written() const;
  /// What was read as keys and values, without the tables inside this one.
  CaseSettings settings() const;

 private:
  std::string choose(std::string_view key, std::optional<std::string> fallback,
                     const std::vector<std::string>& names);

  std::shared_ptr<Node> node_;
};

/// A scene: one rotor, one casing, one range of speeds, in one TOML file. Each program reads only its own table of
/// it.
class CaseFile {
 public:
  /// Each setting is "TABLE.KEY=VALUE" with a value as TOML writes it; it takes the place of the file's key, or joins
  /// it. Raises RunError if the file can't be read, InputError if it or a setting is not TOML or has a top-level
  /// table that no program knows (the known ones: mesh, reduce, casing, simulate, postprocess, material, and the text
  /// `title`).
  explicit CaseFile(const std::filesystem::path& path, const std::vector<std::string>& settings = {});

  const std::string& title() const { return title_; }
  /// The whole file as it was read, and a comment for each setting after it: for provenance.
  const std::string& source() const { return source_; }
  bool has(std::string_view name) const;
  /// Raises InputError if the table is absent.
  CaseTable table(std::string_view name) const;
  std::string resolved_title() const;
  /// What a reader takes from a table, as CaseTable::resolved() gives it, headed by the table's name: the same text
  /// for whatever spelling of the same values.
  std::string resolved(std::string_view name, const std::function<void(CaseTable&)>& read) const;

 private:
  std::string title_;
  std::string source_;
  std::shared_ptr<CaseTable::Node> root_;
};

template <class Enum>
Enum CaseTable::choice(std::string_view key, std::optional<Enum> fallback,
                       std::initializer_list<std::pair<std::string_view, Enum>> names) {
  std::vector<std::string> known;
  std::optional<std::string> fallback_name;
  for (const auto& [name, value] : names) {
    known.emplace_back(name);
    if (fallback && *fallback == value) fallback_name = name;
  }
  const std::string chosen = choose(key, fallback_name, known);
  for (const auto& [name, value] : names)
    if (name == chosen) return value;
  return names.begin()->second;  // not reached: choose() returns one of the known names
}

}  // namespace tiprub
