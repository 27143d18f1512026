// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "postprocess/analysis/linear_criterion.h"
#include "postprocess/analysis/postprocess_parameters.h"
#include "postprocess/waves/wave_label.h"
#include "reduce/model/reduced_model.h"
#include "simulate/response/peaks.h"
#include "simulate/response/response.h"

namespace tiprub {

/// How much the tip line moves, over speed.
struct TipAmplitudes {
  Eigen::MatrixXd by_node;  ///< [m] half of the peak-to-peak, the largest over the sectors; nodes x speeds
  Eigen::VectorXd largest;  ///< [m] over the nodes; speeds
  Eigen::VectorXi node;     ///< where it is the largest; speeds
  int trailing_edge = 0;    ///< row of by_node; the leading edge is the first

  /// Index of the speed with the largest of all.
  Eigen::Index worst() const;
};

TipAmplitudes tip_amplitudes(const Response& response, const ContactLine& contact, Component component);

/// A peak of the largest tip amplitude over speed (see find_peaks()), and why it is there.
struct CriticalSpeed {
  Eigen::Index index = 0;  ///< in the response's speeds
  double speed = 0;        ///< [rad/s]
  double amplitude = 0;    ///< [m]
  double prominence = 0;   ///< [m]
  /// [rad/s] where the response has fallen by 2 % and what the step changes, on the lines between its samples: a
  /// ragged or flat top lies somewhere between them.
  double speed_low = 0, speed_high = 0;
  /// [m] the amplitude less and more what the last halving of the step changed; more, also what the parabola through
  /// the peak's three samples adds.
  double amplitude_low = 0, amplitude_high = 0;
  int node = 0;  ///< contact node that moves most
  /// The wave that makes the peak: of all lines above frequency zero, at that node and of the component of the
  /// amplitude, the one that rises most above the higher of its values at the two valleys. The largest line need not
  /// be it: the casing pushes every wheel through N_l Omega at every speed.
  WaveLabel rising;
  /// The other waves there with at least a fifth of the largest one's amplitude, the largest first, four at most.
  std::vector<WaveLabel> others;
  MotionClass motion = MotionClass::not_settled;
  int period_beats = 0;
  bool by_equation_2 = false;  ///< predicted by the linear rule
  bool by_aliasing = false;    ///< predicted by the rule with aliasing

  /// [1] of the amplitude that the rising wave has. Several waves add up to more than 1 where their crests don't
  /// meet.
  double wave_share() const { return amplitude > 0 ? rising.amplitude / amplitude : 0.0; }
};

/// All peaks, ascending in speed, without the predictions. Needs a response at every speed.
std::vector<CriticalSpeed> critical_speeds(const Response& response, const ContactLine& contact,
                                           const TipAmplitudes& amplitudes, const FrequencyCurves& curves,
                                           const PostprocessParameters& parameters);

/// How far an end of the operating range is from the nearest critical speed outside it.
struct SpeedMargin {
  double speed = 0;   ///< [rad/s] the critical one
  double margin = 0;  ///< [1] of the speed at that end of the range
};

/// Critical speeds and the speeds at which a wheel is to run.
struct OperatingMargin {
  std::vector<double> inside;               ///< [rad/s] critical speeds in the range, its ends included
  std::optional<SpeedMargin> below, above;  ///< the nearest outside; nothing if there is none
};

/// Critical speeds with less than `smallest_amplitude` [m] don't count.
OperatingMargin operating_margin(const std::vector<CriticalSpeed>& critical, const SpeedRange& operating,
                                 double smallest_amplitude);

}  // namespace tiprub
