// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/case_settings.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <numeric>
#include <utility>

#include "cases/program/text.h"
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

/// "mesh.element": at least two words of letters, digits and underscores.
bool is_table_key(const std::string& key) {
  const auto in_word = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
  };
  if (key.empty() || !in_word(key.front()) || !in_word(key.back()) || key.find('.') == std::string::npos)
    return false;
  if (key.find("..") != std::string::npos) return false;
  return std::ranges::all_of(key, [&](char letter) { return letter == '.' || in_word(letter); });
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

/// How many letters have to be changed, left out or put in to make one word of the other.
std::size_t letters_apart(std::string_view one, std::string_view other) {
  std::vector<std::size_t> row(other.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < one.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < other.size(); ++j) {
      const std::size_t changed = diagonal + (one[i] == other[j] ? 0 : 1);
      diagonal = std::exchange(row[j + 1], std::min({changed, row[j] + 1, row[j + 1] + 1}));
    }
  }
  return row.back();
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
  const std::string key(trimmed(setting.substr(0, sign), " "));
  if (sign == std::string::npos || setting.find('\n') != std::string::npos || !is_table_key(key))
    throw InputError(origin + ": must be TABLE.KEY=VALUE, in one line");
  require_short_keys(setting, origin);
  if (trimmed(setting.substr(sign + 1), " ").empty()) return remove_key(values, key, origin);
  try {
    merge(values, toml::parse(setting, origin));
  } catch (const toml::parse_error& error) {
    const std::string value(trimmed(setting.substr(sign + 1), " "));
    throw InputError(origin + ": " + value + " is no TOML value (" + std::string(error.description()) +
                     "); a text needs quotes: " + std::string(option) + "'" + key + "=\"" + value + "\"'");
  }
}

std::string place(const std::string& file, const toml::source_region& source) {
  if (source.path && source.path->starts_with(option)) return *source.path + ": ";
  return file + ":" + std::to_string(source.begin.line) + ":" + std::to_string(source.begin.column) + ": ";
}

std::string meant(std::string_view word, const std::vector<std::string>& known) {
  constexpr std::size_t few = 2;
  std::size_t least = std::min(few + 1, word.size());
  std::string text;
  for (const std::string& other : known)
    if (const std::size_t apart = letters_apart(word, other); apart < least) {
      least = apart;
      text = " (did you mean " + other + "?)";
    }
  return text;
}

std::string items_of(std::size_t columns) {
  if (columns == 1) return "numbers";
  return columns == 2 ? "[x, y] pairs" : "lists of " + std::to_string(columns) + " numbers";
}

}  // namespace tiprub
