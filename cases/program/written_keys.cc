// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/case_file.h"

#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

#include "cases/program/case_settings.h"
#include "cases/program/errors.h"
#include "cases/program/text.h"

namespace tiprub {

namespace {

/// Numbers are written alike, so that 4430, 4430.0 and 4.43e3 are one value.
std::string value_of(const toml::node& node) {
  if (const toml::value<std::string>* text = node.as_string()) return in_quotes(**text);
  if (node.is_number()) return shortest(node.value<double>().value());
  if (const toml::array* list = node.as_array()) return "[" + listed(*list, ", ", value_of) + "]";
  return text_of(toml::node_view<const toml::node>(node));
}

void add_keys(const toml::table& table, const std::string& path, std::map<std::string, std::string>& keys) {
  for (const auto& [key, value] : table) {
    const std::string name = path + std::string(key.str());
    if (const toml::table* inner = value.as_table())
      add_keys(*inner, name + ".", keys);
    else
      keys[name] = value_of(value);
  }
}

}  // namespace

std::map<std::string, std::string> written_keys(const std::string& text) {
  std::map<std::string, std::string> keys;
  try {
    require_short_keys(text, "");
    toml::table values = toml::parse(text);
    const std::string setting = "# " + setting_origin("");
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with(setting)) apply_setting(values, line.substr(setting.size()));
    add_keys(values, "", keys);
  } catch (const toml::parse_error&) {
    return {};
  } catch (const InputError&) {
    return {};
  }
  return keys;
}

std::vector<DifferingKey> differing_keys(const std::string& one, const std::string& other) {
  std::map<std::string, DifferingKey> all;
  for (const auto& [key, value] : written_keys(one)) all[key].one = value;
  for (const auto& [key, value] : written_keys(other)) all[key].other = value;
  std::vector<DifferingKey> differing;
  for (const auto& [key, values] : all)
    if (values.one != values.other) differing.push_back({key, values.one, values.other});
  return differing;
}

MadeOtherwise made_otherwise(const std::string& file, const std::string& made_with, const std::string& case_text,
                             std::initializer_list<std::string_view> tables, const std::string& consequence) {
  MadeOtherwise otherwise;
  for (const auto& [key, in_file, in_case] : differing_keys(made_with, case_text)) {
    const auto is_of = [&name = key](std::string_view table) { return name.starts_with(table); };
    if (!in_file || !in_case || std::ranges::none_of(tables, is_of)) continue;
    otherwise.lines += "\n" + file + " was made with " + key + " = " + *in_file + ", and the case has " + *in_case +
                       "; " + consequence;
    otherwise.keys.emplace(key, *in_file);
  }
  return otherwise;
}

}  // namespace tiprub
