// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tiprub {

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
