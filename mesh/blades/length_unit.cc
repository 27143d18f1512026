// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/blades/length_unit.h"

#include <optional>

namespace tiprub {

namespace {

constexpr double metres_per_inch = 0.0254;

enum class LengthUnit { m, cm, mm, in };

double metres(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::m:
      return 1.0;
    case LengthUnit::cm:
      return 1e-2;
    case LengthUnit::mm:
      return 1e-3;
    case LengthUnit::in:
      return metres_per_inch;
  }
  return 1.0;
}

}  // namespace

double read_length_unit(CaseTable& table) {
  return metres(table.choice<LengthUnit>(
      "length_unit", std::nullopt,
      {{"m", LengthUnit::m}, {"cm", LengthUnit::cm}, {"mm", LengthUnit::mm}, {"in", LengthUnit::in}}));
}

}  // namespace tiprub
