// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <filesystem>
#include <optional>

#include "postprocess/analysis/critical_speeds.h"

namespace tiprub {

/// How much Coriolis' terms move the frequency of the mode that makes a critical speed.
struct CoriolisShift {
  double change = 0;  ///< [1] relative
  double speed = 0;   ///< [rad/s] the critical one
  int nodal_diameter = 0;
  int family = 0;  ///< from 0
};

/// What full fields tell of the effects that are left out.
struct FieldEffects {
  Eigen::VectorXd tip_span{};               ///< [m] see tip_spans(); may be empty
  std::optional<CoriolisShift> coriolis{};  ///< the largest of all critical speeds; nothing if there are none
};

/// Nothing, if `fields_file` is empty; needs check_fields().
FieldEffects field_effects(const std::filesystem::path& fields_file, const ReducedModel& model,
                           const std::vector<CriticalSpeed>& critical);

}  // namespace tiprub
