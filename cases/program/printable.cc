// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/printable.h"

#include <algorithm>
#include <array>

namespace tiprub {

namespace {

/// C0, DEL, and C1 (U+0080 to U+009F), which a terminal obeys too.
bool controls(std::string_view letter) {
  const auto first = static_cast<unsigned char>(letter[0]);
  if (letter.size() == 1) return first < 0x20 || first == 0x7f;
  return letter.size() == 2 && first == 0xc2 && static_cast<unsigned char>(letter[1]) < 0xa0;
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
    if (length > 0 && (!controls(letter) || (letter == "\n" && line_breaks == LineBreaks::kept)))
      shown += letter;
    else
      for (const char byte : letter) shown += escaped(byte);
    text.remove_prefix(letter.size());
  }
  return shown;
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
