// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/text.h"

#include <algorithm>
#include <array>

namespace tiprub {

namespace {

/// Whether a letter makes a terminal show something else than the text: control characters (C0, DEL, C1), letters
/// that change the direction of writing, and letters without any width.
bool misleads(std::string_view letter) {
  char32_t code = letter.size() == 1 ? letter[0] : letter[0] & (0x7f >> letter.size());
  for (const char byte : letter.substr(1)) code = code << 6 | (byte & 0x3f);
  const auto within = [&](char32_t first, char32_t last) { return first <= code && code <= last; };
  return code < 0x20 || within(0x7f, 0x9f) || code == 0x61c || within(0x200b, 0x200f) || within(0x2028, 0x202e) ||
         within(0x2060, 0x206f) || code == 0xfeff || within(0xe0000, 0xe0fff);
}

std::string escaped(char byte) {
  constexpr std::string_view digits = "0123456789abcdef";
  switch (byte) {
    case '\n':
      return "\\n";
    case '\t':
      return "\\t";
    case '\r':
      return "\\r";
    default:
      const auto value = static_cast<unsigned char>(byte);
      return {'\\', 'x', digits[value / 16], digits[value % 16]};
  }
}

}  // namespace

std::string_view trimmed(std::string_view text, std::string_view blanks) {
  text.remove_prefix(std::min(text.size(), text.find_first_not_of(blanks)));
  return text.substr(0, text.find_last_not_of(blanks) + 1);  // npos + 1 is 0
}

std::vector<std::string_view> words_of(std::string_view text, std::string_view blanks) {
  std::vector<std::string_view> words;
  for (text = trimmed(text, blanks); !text.empty(); text = trimmed(text, blanks)) {
    words.push_back(text.substr(0, text.find_first_of(blanks)));
    text.remove_prefix(words.back().size());
  }
  return words;
}

int letter_length(std::string_view text) {
  struct Form {
    unsigned char first, last;                ///< of the first byte
    unsigned char second_first, second_last;  ///< of the second one
    int length;
  };
  // Unicode 15, table 3-7.
  static constexpr std::array<Form, 9> forms = {{{0x00, 0x7f, 0, 0, 1},
                                                 {0xc2, 0xdf, 0x80, 0xbf, 2},
                                                 {0xe0, 0xe0, 0xa0, 0xbf, 3},
                                                 {0xe1, 0xec, 0x80, 0xbf, 3},
                                                 {0xed, 0xed, 0x80, 0x9f, 3},
                                                 {0xee, 0xef, 0x80, 0xbf, 3},
                                                 {0xf0, 0xf0, 0x90, 0xbf, 4},
                                                 {0xf1, 0xf3, 0x80, 0xbf, 4},
                                                 {0xf4, 0xf4, 0x80, 0x8f, 4}}};
  const auto within = [&](std::size_t i, unsigned char first, unsigned char last) {
    return i < text.size() && static_cast<unsigned char>(text[i]) >= first &&
           static_cast<unsigned char>(text[i]) <= last;
  };
  for (const Form& form : forms) {
    if (!within(0, form.first, form.last)) continue;
    bool whole = form.length == 1 || within(1, form.second_first, form.second_last);
    for (int i = 2; i < form.length; ++i) whole = whole && within(i, 0x80, 0xbf);
    return whole ? form.length : 0;
  }
  return 0;
}

std::string printable(std::string_view text, LineBreaks line_breaks) {
  std::string shown;
  while (!text.empty()) {
    const int length = letter_length(text);
    const std::string_view letter = text.substr(0, std::max(length, 1));
    if (length > 0 && (!misleads(letter) || (letter == "\n" && line_breaks == LineBreaks::kept)))
      shown += letter;
    else
      for (const char byte : letter) shown += escaped(byte);
    text.remove_prefix(letter.size());
  }
  return shown;
}

std::string shortened(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  const auto begins_letter = [&](std::size_t at) { return (text[at] & 0xc0) != 0x80; };
  std::size_t head = most / 2, tail = text.size() - most / 2;
  while (!begins_letter(head)) --head;
  while (tail < text.size() && !begins_letter(tail)) ++tail;
  return text.substr(0, head) + " ... " + text.substr(tail);
}

std::string in_quotes(std::string_view text) {
  std::string marked;
  for (const char byte : text) {
    if (byte == '"' || byte == '\\') marked += '\\';
    marked += byte;
  }
  return '"' + printable(marked) + '"';
}

}  // namespace tiprub
