// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/written_keys.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

namespace tiprub {

std::map<std::string, std::string> written_keys(const std::string& text) {
  std::map<std::string, std::string> keys;
  std::string table, key;
  int open = 0;  // brackets of a value that goes on
  std::istringstream lines(text);
  constexpr std::string_view setting = "# --set ";
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(setting)) {
      line.erase(0, setting.size());
      table.clear();
    }
    bool quoted = false;
    std::string bare;
    for (const char letter : line) {
      if (letter == '"') quoted = !quoted;
      if (letter == '#' && !quoted) break;
      if (quoted || std::isspace(static_cast<unsigned char>(letter)) == 0) bare += letter;
      if (!quoted) open += letter == '[' ? 1 : letter == ']' ? -1 : 0;
    }
    const std::size_t equals = bare.find('=');
    if (!key.empty()) {
      keys[key] += bare;
    } else if (equals != std::string::npos) {
      key = table + bare.substr(0, equals);
      keys[key] = bare.substr(equals + 1);
    } else if (bare.size() > 2 && bare.front() == '[') {
      table = bare.substr(1, bare.size() - 2) + ".";
    }
    if (open == 0) key.clear();
  }
  return keys;
}

DifferingKeys differing_keys(const std::string& file, const std::string& made_with, const std::string& case_text,
                             std::initializer_list<std::string_view> tables, const std::string& consequence) {
  DifferingKeys differing;
  const auto of_file = written_keys(made_with);
  for (const auto& in_case : written_keys(case_text)) {
    const auto& [key, value] = in_case;
    const auto there = of_file.find(key);
    const auto is_of = [&](std::string_view table) { return in_case.first.starts_with(table); };
    if (std::none_of(tables.begin(), tables.end(), is_of) || there == of_file.end() || there->second == value)
      continue;
    differing.lines += "\n" + file + " was made with " + key + " = " + there->second + ", and the case has " + value +
                       "; " + consequence;
    differing.made_with.insert(*there);
  }
  return differing;
}

}  // namespace tiprub
