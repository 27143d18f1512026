// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/effects/field_effects.h"
#include "postprocess/tables/table.h"

namespace tiprub {

/// How much an effect weighs on a scene.
enum class NeedVerdict {
  negligible,     ///< at most the tolerance
  matters,        ///< above it
  undecided,      ///< looked at, without an answer
  not_estimated,  ///< not looked at
};

/// One effect that is left out or simplified.
struct SceneNeed {
  std::string effect;            ///< and the unit of its size: "round casing [mm]"
  std::optional<double> size{};  ///< on this scene
  std::optional<double> tolerance{};
  NeedVerdict verdict = NeedVerdict::not_estimated;
  std::string how;  ///< the size was estimated; or could be measured
};

/// At the judged speed what depends on the motion there; over all speeds what simulate measured.
std::vector<SceneNeed> scene_needs(const Study& study, const FieldEffects& fields);

/// "negligible", "matters", "undecided", "not estimated".
std::string name_of(NeedVerdict verdict);

/// A row each: scene_needs.csv.
Table scene_needs_record(const std::vector<SceneNeed>& needs);

}  // namespace tiprub
