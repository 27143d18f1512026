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
  /// One a critical speed; nothing where there are no full fields, or the response holds no state of the rotor.
  std::vector<std::optional<FieldPeak>> peaks;
  double tip_patch = 0, clamp_rim = 0;  ///< [m] how far from tip line and clamp stress isn't read; see StressZones

  bool has_stress() const;
  /// Whether a critical speed's stress is that of a whole cycle.
  bool has_cycles() const;
};

/// Without `fields`, every peak is nothing.
FieldResults field_results(const std::optional<FieldStudy>& fields, const std::vector<CriticalSpeed>& critical);

}  // namespace tiprub
