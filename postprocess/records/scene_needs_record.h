// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/records/left_out_effects.h"
#include "postprocess/tables/table.h"
#include "reduce/model/modelled_effects.h"

namespace tiprub::postprocess {

/// How much an effect matters for a scene.
enum class NeedVerdict {
  none,           ///< it is modelled
  negligible,     ///< its size is at most the tolerance
  matters,        ///< its size is above the tolerance
  undecided,      ///< it was examined without a clear answer
  not_estimated,  ///< it was not examined
};

/// One effect as model.h5 and response.h5 describe it, with the size that is estimated here.
struct SceneNeed {
  ModelledEffect effect;
  NeedVerdict verdict = NeedVerdict::not_estimated;
  std::string how = {};  ///< how the size was estimated, or how it could be measured

  double over_tolerance() const;  ///< [1] of the size; infinite if nothing is allowed
};

/// Every effect that the model or the response names, or that is estimated here, in the order of Effect. Estimates
/// that depend on the motion are those at the judged speed; sizes that tiprub-simulate measured are the largest
/// over all speeds.
std::vector<SceneNeed> scene_needs(const Study& study, const FieldEffects& fields);

/// "negligible", "matters", "undecided" or "not estimated"; empty for what is modelled.
std::string name_of(NeedVerdict verdict);

/// "left out: friction at the tips, Coriolis terms, ...": all effects of one treatment; empty if there are none.
std::string effects_in_words(const std::vector<SceneNeed>& needs, Treatment treatment);

/// The damping of the simulation: "ratio 0.01 of critical; 0.02 above 12000 Hz".
std::string damping_text(const SimulatedScene& scene);

/// "Coriolis terms: relative change of a frequency [1]".
std::string name_with_unit(Effect effect);

/// A row for each effect, what matters most first: scene_needs.csv.
Table scene_needs_record(std::vector<SceneNeed> needs);

}  // namespace tiprub::postprocess
