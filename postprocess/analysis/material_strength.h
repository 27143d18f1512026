// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "cases/program/case_file.h"

namespace tiprub {

/// The [material] table of a case: what the wheel's material bears. There are no default strengths: they depend on
/// heat treatment, surface and size of a part, so that no number would be right without being asked for.
struct MaterialStrength {
  double ultimate = 0;          ///< [Pa] in tension
  double endurance = 0;         ///< [Pa] amplitude that it bears fully reversed, for as many cycles as are asked for
  std::optional<double> yield;  ///< [Pa]
};

/// Raises InputError at a key that is unknown, missing or out of its range.
MaterialStrength read_strength(CaseTable& table);
/// Nothing without the table.
std::optional<MaterialStrength> read_material_strength(const CaseFile& file);

/// [1] Goodman: alternating / endurance + mean / ultimate; 1 is the limit.
double goodman_utilisation(const MaterialStrength& strength, double alternating, double mean);

}  // namespace tiprub
