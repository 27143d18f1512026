// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/run_key.h"

#include <algorithm>

#include "cases/program/digest.h"
#include "reduce/model/reduced_model.h"

namespace tiprub {

namespace {

constexpr int content = 4;  // version of a speed's result: to be raised when its content or meaning changes

bool is_exempt(const std::string& key) {
  return std::any_of(exempt_keys().begin(), exempt_keys().end(),
                     [&](const ExemptKey& exempt) { return key == exempt.key; });
}

void add_settings(Digest& hash, const CaseSettings& settings) {
  for (const auto& [key, value] : settings) {
    if (is_exempt(key)) continue;
    hash.add(key);
    hash.add(value);
  }
}

}  // namespace

const std::vector<ExemptKey>& exempt_keys() {
  static const std::vector<ExemptKey> keys = {
      {"accuracy", "it sets defaults of keys that count themselves"},
      {"speed_min_rpm", "speeds are independent; a sweep that carries its state counts the speeds themselves"},
      {"speed_max_rpm", "as speed_min_rpm"},
      {"speed_count", "as speed_min_rpm"},
      {"speeds_rpm", "as speed_min_rpm"},
      {"speeds", "as speed_min_rpm"},
      {"scan_per_interval", "as speed_min_rpm"},
      {"speed_count_max", "as speed_min_rpm"},
      {"peak_prominence", "as speed_min_rpm"},
      {"examine", "a finished speed tells how deep it was looked at, and is computed again if that is not enough"},
      {"when_symmetry_breaks", "what is done afterwards, into another file"},
      {"branches", "what is done afterwards, of no speed's result"},
      {"branch_range", "as branches"},
      {"branch_steps", "as branches"},
      {"threads", "results don't depend on them"},
  };
  return keys;
}

std::string run_key(const ReducedModel& model, const SweepSettings& settings, const SimulateParameters& parameters,
                    const std::string& generator) {
  Digest hash;
  hash.add(content);
  hash.add(generator);
  hash.add(digest(model));
  add_settings(hash, settings.casing);
  add_settings(hash, settings.simulate);
  if (parameters.sweep != SweepDirection::rest)  // a speed's result depends on those before it
    for (double speed : parameters.speeds) hash.add(speed);
  return hash.digits();
}

}  // namespace tiprub
