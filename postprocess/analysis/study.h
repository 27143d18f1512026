// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "postprocess/analysis/contact_drift.h"
#include "postprocess/analysis/critical_speeds.h"
#include "postprocess/analysis/rule_score.h"
#include "postprocess/analysis/sweep_comparison.h"
#include "postprocess/analysis/wave_maps.h"

namespace tiprub {

/// All numbers of a report, to be handed out in parts. What full fields give stands beside it
/// (fields/field_results.h).
struct Study {
  PostprocessParameters parameters;
  ReducedModel model;
  Response response;                  ///< the speeds that have a response, and only those
  std::vector<SpeedResponse> failed;  ///< the others, with their reasons
  SpeedRange range;
  FrequencyCurves curves;
  TipAmplitudes amplitudes;
  WaveMaps waves;
  ContactMaps contact;
  std::vector<CriticalSpeed> critical;
  LinearRules rules;
  std::vector<SweepComparison> sweeps;  ///< one a speed, or none
  Eigen::Index shown;                   ///< index of the speed whose motion and force are drawn: see shown_speed()

  const SpeedResponse& worst_response() const { return speed_at(amplitudes.worst()); }
  /// At the critical speed with the largest amplitude; at the largest amplitude where no speed is critical.
  const SpeedResponse& judged_response() const;
  const SpeedResponse& shown_response() const { return speed_at(shown); }

  const SpeedResponse& speed_at(Eigen::Index index) const { return response.speeds[static_cast<std::size_t>(index)]; }
};

/// The speed asked for, or the one with the largest amplitude among those whose motion is the same every revolution
/// (among all, if none is).
Eigen::Index shown_speed(const Response& response, const TipAmplitudes& amplitudes, double asked_rpm);

/// Computes everything, and reads the sweeps that are to be compared; needs check_together(). Raises as
/// compare_sweeps() does.
Study make_study(const PostprocessParameters& parameters, ReducedModel model, Response response,
                 const SweepFiles& sweeps);

}  // namespace tiprub
