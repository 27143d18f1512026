// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "postprocess/analysis/contact_drift.h"
#include "postprocess/analysis/contact_map.h"
#include "postprocess/analysis/critical_speeds.h"
#include "postprocess/analysis/interaction_map.h"
#include "postprocess/analysis/sweep_comparison.h"

namespace tiprub {

/// A travelling wave's peak over speed, on one line of the interaction map.
struct Ridge {
  double speed = 0;  ///< [rad/s]
  WaveLabel wave;
};

/// All that the figures, the tables and the page are drawn from.
struct Study {
  PostprocessParameters parameters;
  ReducedModel model;
  Response response;                  ///< the speeds that have a response, and only those
  std::vector<SpeedResponse> failed;  ///< the others, with their reasons
  SpeedRange range;
  FrequencyCurves curves;
  TipAmplitudes amplitudes{};
  int map_node = 0;
  InteractionMap map{};
  std::vector<Ridge> ridges{};  ///< engine orders 1 .. engine_order_max
  ContactMap leading_edge{}, trailing_edge{};
  ContactDrift leading_drift{}, trailing_drift{};
  std::vector<CriticalSpeed> critical{};
  std::vector<Crossing> equation_2{}, aliased{};
  RuleScore equation_2_score{}, aliasing_score{};
  std::vector<SweepComparison> sweeps{};  ///< one a speed, or none
  Eigen::Index worst = 0;                 ///< index of the speed with the largest amplitude
  /// Index of the speed whose motion and force are drawn: the one asked for, or the one with the largest amplitude
  /// among those whose motion is the same every revolution (among all, if none is).
  Eigen::Index shown = 0;

  const SpeedResponse& worst_response() const { return response.speeds[static_cast<std::size_t>(worst)]; }
  const SpeedResponse& shown_response() const { return response.speeds[static_cast<std::size_t>(shown)]; }
};

/// Raises InputError if the model and the response are of different rotors, RunError if no speed has a usable
/// response. `name` is the response's, for messages.
void check_together(const ReducedModel& model, const Response& response, const std::string& name);

/// Computes everything; needs check_together().
Study make_study(const PostprocessParameters& parameters, ReducedModel model, Response response);

}  // namespace tiprub
