// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "postprocess/tables/table.h"
#include "postprocess/tables/units.h"
#include "simulate/response/response.h"

namespace tiprub {

/// A column's name, and how it is read from what a row is about.
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

/// Groups of columns, one after the other.
template <class Item>
std::vector<Column<Item>> joined(const std::vector<std::vector<Column<Item>>>& groups) {
  std::vector<Column<Item>> columns;
  for (const auto& group : groups) columns.insert(columns.end(), group.begin(), group.end());
  return columns;
}

/// "yes" or "no".
std::string yes_or_no(bool value);
/// "periodic", "subharmonic 1/3", "broadband", ...
std::string motion_text(MotionClass motion, int period_beats);
/// Empty where nobody looked.
Cell optional_cell(const std::optional<double>& value);

/// Rows ascending in their first column, a number; equal ones keep their order.
void sort_by_speed(Table& table);

}  // namespace tiprub
