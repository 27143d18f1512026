// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/effects/field_effects.h"
#include "postprocess/tables/table.h"
#include "reduce/model/modelled_effects.h"

namespace tiprub {

/// How much an effect weighs on a scene.
enum class NeedVerdict {
  none,           ///< it is modelled
  negligible,     ///< at most the tolerance
  matters,        ///< above it
  undecided,      ///< looked at, without an answer
  not_estimated,  ///< not looked at
};

/// One effect as model.h5 and response.h5 tell it, with the size that is estimated here.
struct SceneNeed {
  ModelledEffect effect;
  NeedVerdict verdict = NeedVerdict::not_estimated;
  std::string how = {};  ///< the size was estimated; or could be measured
};

/// Every effect that the model or the response tells of, or that has an estimate, in the order of Effect: at the
/// judged speed what depends on the motion there; over all speeds what simulate measured.
std::vector<SceneNeed> scene_needs(const Study& study, const FieldEffects& fields);

/// "negligible", "matters", "undecided", "not estimated"; empty for what is modelled.
std::string name_of(NeedVerdict verdict);

/// "left out: friction at the tips, Coriolis terms, ...": of one treatment, or empty.
std::string effects_in_words(const std::vector<SceneNeed>& needs, Treatment treatment);

/// "ratio 0.01 of critical; 0.02 above 12000 Hz": as it was marched.
std::string damping_text(const SimulatedScene& scene);

/// "Coriolis terms: relative change of a frequency [1]".
std::string name_with_unit(Effect effect);

/// A row each: scene_needs.csv.
Table scene_needs_record(const std::vector<SceneNeed>& needs);

}  // namespace tiprub
