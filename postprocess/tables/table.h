// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cases/program/text.h"
#include "cases/program/units.h"

namespace tiprub::postprocess {

/// Stands where a table has no number: empty in text, NaN in files.
struct NoNumber {};

/// A value of a table. A number must be finite: one that is not is the sign of an earlier error.
using Cell = std::variant<double, int, std::string, NoNumber>;

/// The number, or NoNumber for NaN.
Cell number_if_any(double value);

/// A small table; every row is as long as the header. Units are part of a column's name: "speed [rpm]".
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<Cell>> rows;
};

/// "1234.5", with `digits` after the point; empty if the value is not finite.
std::string fixed(double value, int digits);
/// "1.2e-05", likewise.
std::string scientific(double value, int digits);
/// "0.025", with so many significant digits.
std::string significant(double value, int digits);

/// A cell as it stands in a file.
std::string csv_cell(const Cell& cell);

/// Writes comma-separated values, the header first; texts with a comma or a quote stand in quotes. Raises RunError if
/// the file can't be written, or with column and row if a number is not finite.
void write_csv(const Table& table, const std::filesystem::path& path);

/// Columns side by side, two spaces apart, numbers to the right.
std::string aligned_text(const Table& table);

/// The whole of a file. Raises RunError if it can't be read.
std::string read_text(const std::filesystem::path& path);
/// Raises RunError if it can't be written.
void write_text(const std::string& text, const std::filesystem::path& path);

/// The template with every {{name}} replaced by its value; names inside values are left as they are. Every name must
/// have a value, and every value must be used.
std::string filled(std::string_view page, const std::map<std::string, std::string>& values);

inline constexpr double percent = 100.0;

/// "12300 rpm" for a speed in rad/s.
std::string rpm_text(double speed);
/// "1 speed", "3 speeds".
std::string counted(std::size_t count, const std::string& what);
/// "0.265 mm" for a length in metres.
std::string mm_text(double length);
/// "583 MPa" for a stress in Pa.
std::string mpa_text(double stress);

/// A column's name, and how its cell is made from the item that the row shows.
template <class Item>
struct Column {
  const char* name;
  std::function<Cell(const Item&)> cell;
};

template <class Item>
Table table_of(const std::vector<Column<Item>>& columns, const std::vector<Item>& items) {
  Table table;
  for (const Column<Item>& column : columns) table.header.emplace_back(column.name);
  for (const Item& item : items) {
    table.rows.emplace_back();
    for (const Column<Item>& column : columns) table.rows.back().push_back(column.cell(item));
  }
  return table;
}

/// Lists one after the other.
template <class Item>
std::vector<Item> joined(std::vector<std::vector<Item>> lists) {
  std::vector<Item> all;
  for (auto& list : lists) std::move(list.begin(), list.end(), std::back_inserter(all));
  return all;
}

/// "yes" or "no".
std::string yes_or_no(bool value);
/// The number in another unit, or an empty text where there is none.
Cell optional_cell(const std::optional<double>& value, double factor = 1);

/// Sorts the rows by their first column, a number; equal ones keep their order.
void sort_by_speed(Table& table);

}  // namespace tiprub::postprocess
