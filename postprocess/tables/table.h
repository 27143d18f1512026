// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace tiprub {

/// Where a table has no number: empty in text, NaN in files.
struct NoNumber {};

/// A value of a table. A number must be finite; one that is not says that something before it went wrong.
using Cell = std::variant<double, int, std::string, NoNumber>;

/// Of a number that is NaN where there is none.
Cell number_if_any(double value);

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

/// A cell as files have it.
std::string csv_cell(const Cell& cell);

/// Comma-separated, the header first; texts with a comma or quote in quotes. Raises RunError if it can't be written,
/// or if a number is not finite, with its column and its row.
void write_csv(const Table& table, const std::filesystem::path& path);

/// Columns side by side, two spaces apart, numbers to the right.
std::string aligned_text(const Table& table);

/// The whole of a file. Raises RunError if it can't be read.
std::string read_text(const std::filesystem::path& path);
/// Raises RunError if it can't be written.
void write_text(const std::string& text, const std::filesystem::path& path);

}  // namespace tiprub
