// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "postprocess/analysis/contact_maps.h"
#include "postprocess/analysis/critical_speeds.h"
#include "postprocess/analysis/gap_terms.h"
#include "postprocess/analysis/interaction_map.h"
#include "postprocess/analysis/linear_rules.h"
#include "postprocess/analysis/other_motions.h"

namespace tiprub::postprocess {

/// All numbers of a report; figures and tables take the parts that they need. Results of the full fields are kept
/// separately (fields/field_study.h).
struct Study {
  PostprocessParameters parameters;
  ReducedModel model;
  Response response;                    ///< the speeds that have a response, and only those
  std::vector<SpeedResponse> failed{};  ///< the others, each with its reason
  SpeedRange range{};
  FrequencyCurves curves;
  TipAmplitudes amplitudes{};
  WaveMaps waves{};
  ContactMaps contact{};
  std::vector<CriticalSpeed> critical{};
  std::vector<CriticalSpeed> not_located{};  ///< peaks of the response that aren't critical speeds: see `located`
  std::vector<GapTerms> gap{};               ///< one per speed
  LinearRules rules{};
  std::vector<SweepComparison> sweeps{};  ///< one per speed, or none
  /// Index of the speed whose motion and force are drawn: the one nearest to that asked for, or the one with the
  /// largest amplitude among those whose motion is the same at every lobe (among all, if there is none).
  Eigen::Index shown = 0;

  const SpeedResponse& worst_response() const { return speed_at(amplitudes.worst()); }
  /// At the critical speed with the largest amplitude, or at the largest amplitude if no speed is critical.
  const SpeedResponse& judged_response() const;
  const SpeedResponse& shown_response() const { return speed_at(shown); }
  /// The tips stay clear of the casing's crest at every simulated speed, so that nothing excites the wheel. The
  /// running clearance goes with the square of the speed, hence they stay clear between those speeds as well.
  /// At a speed that has failed, the spin may have closed the clearance.
  bool no_tip_touches() const { return failed.empty() && interference().high <= 0; }
  /// [m] Of all contact nodes at all speeds that have a response: SimulatedScene::interference().
  LengthRange interference() const;

  const SpeedResponse& speed_at(Eigen::Index index) const { return response.speeds[static_cast<std::size_t>(index)]; }
  double excursion_at(Eigen::Index index) const {  ///< [m]
    return largest_excursion(speed_at(index).displacement, model.contact);
  }
};

/// Computes everything, and reads the sweeps to compare. Needs inputs that passed check_together(). Raises what
/// compare_sweeps() raises.
Study make_study(const PostprocessParameters& parameters, ReducedModel model, Response response,
                 const SweepFiles& sweeps);

}  // namespace tiprub::postprocess
