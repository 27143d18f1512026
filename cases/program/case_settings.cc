// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/case_settings.h"

#include <algorithm>
#include <cctype>

#include "cases/program/case_text.h"
#include "cases/program/errors.h"

namespace tiprub {

namespace {

constexpr std::string_view option = "--set ";

/// Moves, for toml++ drops the positions of what it copies.
void merge(toml::table& into, toml::table&& from) {
  for (auto&& [key, value] : from) {
    toml::table* inner = into[key.str()].as_table();
    if (inner != nullptr && value.is_table())
      merge(*inner, std::move(*value.as_table()));
    else
      into.insert_or_assign(key, std::move(value));
  }
}

std::string without_blanks_at_ends(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// "mesh.element": at least two words of letters, digits and underscores.
bool is_table_key(const std::string& key) {
  const auto in_word = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
  };
  if (key.empty() || !in_word(key.front()) || !in_word(key.back()) || key.find('.') == std::string::npos)
    return false;
  if (key.find("..") != std::string::npos) return false;
  return std::all_of(key.begin(), key.end(), [&](char letter) { return letter == '.' || in_word(letter); });
}

}  // namespace

std::string setting_origin(const std::string& setting) {
  return std::string(option) + setting;
}

void apply_setting(toml::table& values, const std::string& setting) {
  const std::string origin = setting_origin(setting);
  const std::size_t sign = setting.find('=');
  const std::string key = without_blanks_at_ends(setting.substr(0, sign));
  if (sign == std::string::npos || setting.find('\n') != std::string::npos || !is_table_key(key))
    throw InputError(origin + ": must be TABLE.KEY=VALUE, in one line");
  if (const TextFault fault = fault_of_keys(setting)) throw InputError(origin + *fault);
  try {
    merge(values, toml::parse(setting, origin));
  } catch (const toml::parse_error& error) {
    const std::string value = without_blanks_at_ends(setting.substr(sign + 1));
    throw InputError(origin + ": " + value + " is no TOML value (" + std::string(error.description()) +
                     "); a text needs quotes: " + std::string(option) + "'" + key + "=\"" + value + "\"'");
  }
}

std::string place(const std::string& file, const toml::source_region& source) {
  if (source.path && source.path->starts_with(option)) return *source.path + ": ";
  return file + ":" + std::to_string(source.begin.line) + ":" + std::to_string(source.begin.column) + ": ";
}

}  // namespace tiprub
