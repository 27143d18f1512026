// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace tiprub {

/// A value of a table; a number that is not finite prints as an empty cell in text and as NaN in files.
using Cell = std::variant<double, int, std::string>;

/// A small table; every row is as long as the header. Units are part of a column's name: "speed [rpm]".
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<Cell>> rows;
};

/// "1234.5": `digits` after the point, nothing if the value is not finite.
std::string fixed(double value, int digits);
/// "1.2e-05": likewise, with an exponent.
std::string scientific(double value, int digits);
/// "0.025": so many digits that count.
std::string significant(double value, int digits);

/// Comma-separated, the header first; texts with a comma or quote in quotes. Raises RunError if it can't be written.
void write_csv(const Table& table, const std::filesystem::path& path);

/// Columns side by side, two spaces apart, numbers to the right.
std::string aligned_text(const Table& table);

/// The whole of a file. Raises RunError if it can't be read.
std::string read_text(const std::filesystem::path& path);
/// Raises RunError if it can't be written.
void write_text(const std::string& text, const std::filesystem::path& path);

}  // namespace tiprub
