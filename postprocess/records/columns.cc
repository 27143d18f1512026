// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/columns.h"

#include <algorithm>

namespace tiprub {

std::string yes_or_no(bool value) {
  return value ? "yes" : "no";
}

std::string motion_text(MotionClass motion, int period_beats) {
  return name_of(motion) + (motion == MotionClass::subharmonic ? " 1/" + std::to_string(period_beats) : "");
}

Cell optional_cell(const std::optional<double>& value) {
  return value ? Cell(*value) : Cell(std::string());
}

void sort_by_speed(Table& table) {
  std::stable_sort(table.rows.begin(), table.rows.end(), [](const auto& a, const auto& b) {
    return std::get<double>(a.front()) < std::get<double>(b.front());
  });
}

}  // namespace tiprub
