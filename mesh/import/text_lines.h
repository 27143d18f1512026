// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cases/program/case_file.h"

namespace tiprub {

/// A text line by line, for formats in which a line's place says what it means.
class TextLines {
 public:
  explicit TextLines(const NamedText& file) : file_(file), rest_(file.text) {}

  const NamedText& file() const { return file_; }
  /// The next line without its end, or nothing after the last.
  std::optional<std::string_view> next();
  /// The line that next() will give.
  std::optional<std::string_view> peek() const;
  int number() const { return number_; }  ///< of the line that next() gave last, from 1
  /// Raises InputError: "FILE:LINE: message", of that line.
  [[noreturn]] void refuse(const std::string& message) const;

  /// A word as a finite number, as Fortran writes them too: 1.5D-3, 1.5-3. Raises InputError.
  double number_in(std::string_view word, const char* meaning) const;
  /// A word as a whole number of magnitude up to 2e9. Raises InputError.
  long whole_in(std::string_view word, const char* meaning) const;

 private:
  const NamedText& file_;
  std::string_view rest_;
  int number_ = 0;
};

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);
std::string upper(std::string_view text);
/// Between commas, trimmed; an empty one after the last comma is none.
std::vector<std::string_view> comma_fields(std::string_view line);
/// Between blanks.
std::vector<std::string_view> blank_fields(std::string_view line);
/// In columns of this width, trimmed.
std::vector<std::string_view> column_fields(std::string_view line, std::size_t width);

}  // namespace tiprub
