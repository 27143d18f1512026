// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "postprocess/analysis/contact_drift.h"
#include "postprocess/analysis/contact_map.h"
#include "postprocess/analysis/critical_speeds.h"
#include "postprocess/analysis/ridges.h"
#include "postprocess/analysis/rule_score.h"
#include "postprocess/analysis/sweep_comparison.h"

namespace tiprub {

/// All numbers that the figures, the tables and the page are drawn from. make_study() makes it whole; nothing is
/// added to it later. What full fields give stands beside it (fields/field_results.h).
struct Study {
  PostprocessParameters parameters;
  ReducedModel model;
  Response response;                  ///< the speeds that have a response, and only those
  std::vector<SpeedResponse> failed;  ///< the others, with their reasons
  SpeedRange range;
  FrequencyCurves curves;
  TipAmplitudes amplitudes{};
  InteractionMap map{};        ///< of the edge asked for: its spectra and trackings are drawn as well
  InteractionMap other_map{};  ///< of the other edge
  std::vector<Ridge> ridges{};
  ContactMap leading_edge{}, trailing_edge{};
  ContactDrift leading_drift{}, trailing_drift{};
  EdgeLag edge_lag{};
  std::vector<CriticalSpeed> critical{};
  MovingWaves moving{};  ///< the linear rules are asked for these
  std::vector<Crossing> equation_2{}, aliased{};
  RuleScore equation_2_score{}, aliasing_score{};
  std::vector<SweepComparison> sweeps{};  ///< one a speed, or none
  Eigen::Index worst = 0;                 ///< index of the speed with the largest amplitude
  /// Index of the speed whose motion and force are drawn: the one asked for, or the one with the largest amplitude
  /// among those whose motion is the same every revolution (among all, if none is).
  Eigen::Index shown = 0;

  const SpeedResponse& worst_response() const { return response.speeds[static_cast<std::size_t>(worst)]; }
  /// At the critical speed with the largest amplitude; at the largest amplitude where no speed is critical.
  const SpeedResponse& judged_response() const;
  const SpeedResponse& shown_response() const { return response.speeds[static_cast<std::size_t>(shown)]; }
};

/// Computes everything, and reads the sweeps that are to be compared; needs check_together(). Raises as
/// compare_sweeps() does.
Study make_study(const PostprocessParameters& parameters, ReducedModel model, Response response,
                 const SweepFiles& sweeps);

}  // namespace tiprub
