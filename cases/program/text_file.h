// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cases/program/errors.h"

namespace tiprub {

/// A text file from the user.
struct NamedText {
  std::string name;  ///< its path, for messages
  std::string text;
};

/// Reads all of a file. `kind` is what it should be, for messages ("a case file"). Raises RunError if it can't be
/// read or is a folder, a device or a pipe, which might never end. Raises InputError if it is too large or not UTF-8.
NamedText read_named_text(const std::filesystem::path& path, const std::string& kind);

/// The same for a file of any size and any bytes, as a mesh may be.
NamedText read_named_bytes(const std::filesystem::path& path, const std::string& kind);

/// Raises InputError, with the place, at the first byte that is no letter of UTF-8.
void require_utf8(const NamedText& file, const std::string& kind);

/// Where something stands in a text: ":LINE:COLUMN: ".
std::string place_in(std::string_view text, std::size_t offset);

/// A line of a file of numbers: its words, and its remark after a '#'.
struct NumberLine {
  int number;  ///< from 1
  std::vector<std::string_view> words;
  std::string_view remark;  ///< from the '#' on; empty if there is none
};

/// The lines of a text that are not empty. They point into the text. Blanks, tabs and commas separate words.
std::vector<NumberLine> lines_of(const NamedText& file);

/// The lines that have words. A first line that begins with a letter is a heading, and is left out.
std::vector<NumberLine> lines_below_heading(const NamedText& file);

/// Raises InputError unless the line has `count` words; `meaning` is what these should be ("angle, inward").
void require_words(const NamedText& file, const NumberLine& line, std::size_t count, std::string_view meaning);

/// Raises InputError: "FILE:LINE: message".
[[noreturn]] void refuse_line(const NamedText& file, int line, const std::string& message);

/// The word as a finite number; `meaning` is what it should be ("r"). Raises InputError.
double number_in(const NamedText& file, const NumberLine& line, std::size_t word, std::string_view meaning);

/// The word as an angle in units of `unit` [rad], converted to radians. Raises InputError above a hundred turns.
double angle_in(const NamedText& file, const NumberLine& line, std::size_t word, std::string_view meaning,
                double unit);

/// The word as a whole number from `least` to `most`. Raises InputError.
int count_in(const NamedText& file, const NumberLine& line, std::size_t word, std::string_view meaning, int least,
             int most);

}  // namespace tiprub
