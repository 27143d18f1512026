// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/case_text.h"

#include <algorithm>
#include <cstring>

#include "cases/program/printable.h"

namespace tiprub {

namespace {

constexpr int most_key_parts = 16;

/// ":3:7: ".
std::string place_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return ":" + std::to_string(line) + ":" + std::to_string(offset - start + 1) + ": ";
}

/// Letters of the text in quotes that this begins with, quotes included; an unfinished one takes all there is.
std::size_t quoted_length(std::string_view text) {
  const char quote = text[0];
  const bool many_lines = text.size() > 2 && text[1] == quote && text[2] == quote;
  const std::string end(many_lines ? 3 : 1, quote);
  std::size_t i = end.size();
  while (i < text.size() && text.substr(i, end.size()) != end && (many_lines || text[i] != '\n'))
    i += quote == '"' && text[i] == '\\' ? 2 : 1;
  i += end.size();
  for (int more = 0; many_lines && more < 2 && i < text.size() && text[i] == quote; ++more)
    ++i;  // belong to the text
  return std::min(i, text.size());
}

}  // namespace

TextFault fault_of_letters(std::string_view text) {
  if (text.substr(0, 2) == "\xff\xfe" || text.substr(0, 2) == "\xfe\xff")
    return ": is written in UTF-16; save it as UTF-8";
  for (std::size_t i = 0; i < text.size();) {
    const int length = letter_length(text.substr(i, 4));
    if (length == 0 || text[i] == '\0')
      return place_of(text, i) + "not TOML: the byte " + printable(text.substr(i, 1)) +
             " is no letter of UTF-8; is this a case file, saved as UTF-8?";
    i += length;
  }
  return std::nullopt;
}

TextFault fault_of_keys(std::string_view text) {
  int parts = 1;
  for (std::size_t i = 0; i < text.size();) {
    const char letter = text[i];
    if (letter == '"' || letter == '\'') {
      i += quoted_length(text.substr(i));
      continue;
    }
    if (letter == '#') i = std::min(text.find('\n', i), text.size() - 1);
    if (letter == '.' && ++parts > most_key_parts)
      return place_of(text, i) + "a key of more than " + std::to_string(most_key_parts) + " parts; no case has one";
    if (std::strchr("=,[]{}#\n", letter) != nullptr) parts = 1;
    ++i;
  }
  return std::nullopt;
}

}  // namespace tiprub
