// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cases/program/case_file.h"
#include "reduce/model/reduced_model.h"
#include "simulate/scene/simulate_parameters.h"

namespace tiprub {

/// Both tables of a case that a sweep reads, resolved: defaults included.
struct SweepSettings {
  CaseSettings casing, simulate;
};

/// A key of [casing] or [simulate] that decides no speed's result.
struct ExemptKey {
  const char* key;
  const char* reason;
};
const std::vector<ExemptKey>& exempt_keys();

/// A name for all that decides the result at a speed: the model's numbers, every setting that is not exempt, and the
/// program's version; of a sweep that carries its state along, the speeds too. 16 hexadecimal digits (a Digest). A
/// key that a reader newly asks for counts by itself: a forgotten one would silently give back former results.
std::string run_key(const ReducedModel& model, const SweepSettings& settings, const SimulateParameters& parameters,
                    const std::string& generator);

}  // namespace tiprub
