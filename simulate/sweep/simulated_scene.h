// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cases/program/case_file.h"
#include "reduce/model/modelled_effects.h"
#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"
#include "simulate/scene/scene.h"
#include "simulate/scene/simulate_parameters.h"

namespace tiprub::simulate {

/// Which effects on a rubbing wheel a scene models, which it simplifies, and which it leaves out.
std::vector<ModelledEffect> effects_of(const Scene& scene);

/// The origin of a scene, as text.
struct SceneOrigin {
  std::string provenance;  ///< the case, and the provenance of the model
  std::string casing;      ///< the table [casing] as the case has it (CaseTable::written())
};

/// The description of a scene in response.h5.
SimulatedScene simulated_scene(const Scene& scene, const SceneOrigin& origin);

/// The two tables of a case that a sweep reads, with defaults.
struct SweepSettings {
  CaseSettings casing, simulate;
};

/// A key of [casing] or [simulate] on which the result of a speed does not depend.
struct ExemptKey {
  const char* key;
  const char* reason;
};
const std::vector<ExemptKey>& exempt_keys();

/// A digest (16 hexadecimal digits) of everything that decides the result of a speed: the numbers of the model,
/// every setting that is not exempt, the version of the program, and the numbers of the model of the error budgets;
/// for a sweep that starts each speed from the one before, also the speeds. A new key counts unless it is listed as
/// exempt: if keys that count were listed instead, a forgotten one would make the program reuse results that no
/// longer hold.
std::string run_key(const ReducedModel& model, const SweepSettings& settings, const SimulateParameters& parameters,
                    const std::string& generator, const ReducedModel* other_model = nullptr);

}  // namespace tiprub::simulate
