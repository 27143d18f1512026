// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/case_settings.h"

#include <algorithm>
#include <cctype>
#include <cstring>

#include "cases/program/text_file.h"

namespace tiprub {

namespace {

constexpr std::string_view option = "--set ";

/// Moves the values, because toml++ drops the positions of what it copies.
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

/// Removes the key from its table. Raises InputError if it is not there.
void remove_key(toml::table& values, const std::string& key, const std::string& origin) {
  const std::size_t dot = key.rfind('.');
  toml::table* table = values.at_path(key.substr(0, dot)).as_table();
  if (table == nullptr || table->erase(key.substr(dot + 1)) == 0)
    throw InputError(origin + ": removes a key that the case does not have; give it a value, or leave this out");
}

/// The length of the quoted text that this begins with, quotes included. If it has no end, it takes all there is.
std::size_t quoted_length(std::string_view text) {
  const char quote = text[0];
  const bool many_lines = text.size() > 2 && text[1] == quote && text[2] == quote;
  const std::string end(many_lines ? 3 : 1, quote);
  std::size_t i = end.size();
  while (i < text.size() && text.substr(i, end.size()) != end && (many_lines || text[i] != '\n'))
    i += quote == '"' && text[i] == '\\' ? 2 : 1;
  i += end.size();
  for (int more = 0; many_lines && more < 2 && i < text.size() && text[i] == quote; ++more)
    ++i;  // these belong to the text
  return std::min(i, text.size());
}

}  // namespace

void require_short_keys(std::string_view text, const std::string& origin) {
  constexpr int most_parts = 16;
  int parts = 1;
  for (std::size_t i = 0; i < text.size();) {
    const char letter = text[i];
    if (letter == '"' || letter == '\'') {
      i += quoted_length(text.substr(i));
      continue;
    }
    if (letter == '#') i = std::min(text.find('\n', i), text.size() - 1);
    if (letter == '.' && ++parts > most_parts)
      throw InputError(origin + place_in(text, i) + "a key of more than " + std::to_string(most_parts) +
                       " parts; no case has one");
    if (std::strchr("=,[]{}#\n", letter) != nullptr) parts = 1;
    ++i;
  }
}

std::string setting_origin(const std::string& setting) {
  return std::string(option) + setting;
}

void apply_setting(toml::table& values, const std::string& setting) {
  const std::string origin = setting_origin(setting);
  const std::size_t sign = setting.find('=');
  const std::string key = without_blanks_at_ends(setting.substr(0, sign));
  if (sign == std::string::npos || setting.find('\n') != std::string::npos || !is_table_key(key))
    throw InputError(origin + ": must be TABLE.KEY=VALUE, in one line");
  require_short_keys(setting, origin);
  if (without_blanks_at_ends(setting.substr(sign + 1)).empty()) return remove_key(values, key, origin);
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
