// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "postprocess/fields/field_study.h"

namespace tiprub {

/// What full fields tell the tables and the page, beside the study.
struct FieldResults {
  std::string scope;  ///< a line on what was recovered, or why nothing
  /// One a critical speed, at its recorded sample with the largest contact force; nothing where there are no full
  /// fields, or the response holds no state of the rotor.
  std::vector<std::optional<FieldPeak>> peaks;

  bool has_stress() const;
};

/// Without `fields`, every peak is nothing.
FieldResults field_results(const std::optional<FieldStudy>& fields, const std::vector<CriticalSpeed>& critical);

}  // namespace tiprub
