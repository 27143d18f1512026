// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "postprocess/analysis/postprocess_parameters.h"
#include "postprocess/waves/wave_label.h"
#include "reduce/model/reduced_model.h"
#include "simulate/response/peaks.h"
#include "simulate/response/response.h"

namespace tiprub::postprocess {

/// A range of speeds [rad/s], its ends included.
struct SpeedRange {
  double low = 0;
  double high = 0;
};

/// How much the tip line moves at each speed.
struct TipAmplitudes {
  Eigen::MatrixXd by_node;  ///< [m] half of the peak-to-peak, the largest over the sectors; nodes x speeds
  Eigen::VectorXd largest;  ///< [m] over the nodes; speeds
  Eigen::VectorXi node;     ///< where it is the largest; speeds
  int trailing_edge = 0;    ///< row of by_node; the leading edge is the first

  /// Index of the speed with the largest of all.
  Eigen::Index worst() const;
};

TipAmplitudes tip_amplitudes(const Response& response, const ContactLine& contact, Component component);

/// A peak of the largest tip amplitude over speed (see named_peaks()), and its cause.
struct CriticalSpeed {
  Eigen::Index index = 0;  ///< in the response's speeds
  double speed = 0;        ///< [rad/s]
  double amplitude = 0;    ///< [m]
  double prominence = 0;   ///< [m]
  /// [rad/s] The nearest simulated speeds at which the response has fallen by 2 % plus the change by the last
  /// halving of the step. The top lies between the two.
  double speed_low = 0, speed_high = 0;
  /// [m] The amplitude minus and plus the change by the last halving of the step, here and at speeds with nearly
  /// the same amplitude. The upper one also contains the possible rise between the speeds (see rise_beside()).
  double amplitude_low = 0, amplitude_high = 0;
  double spacing = 0;  ///< [rad/s] to the farther one of its two neighbours
  /// Whether the response falls on both sides before it rises higher or the range ends, within most of the range.
  bool located = false;
  int node = 0;  ///< contact node that moves most
  /// The wave that makes the peak: among all spectral lines above frequency zero, at that node and of the
  /// component of the amplitude, the one that rises most above the higher of its values at the two valleys. This
  /// need not be the largest line, because the casing excites N_l Omega at every speed.
  WaveLabel rising;
  WaveLabel largest;  ///< the largest wave there; often the same
  /// At most four other waves there, the largest first, each with at least a fifth of the largest one's amplitude.
  std::vector<WaveLabel> others;
  bool by_equation_2 = false;  ///< predicted by the linear rule
  bool by_aliasing = false;    ///< predicted by the rule with aliasing

  /// [1] How uncertain the amplitude is by step and distance of the speeds, relative to it.
  double amplitude_slack() const;
  /// The wave after which the motion is called: the largest if only that has at least half of the amplitude, or else
  /// the one that makes the peak.
  const WaveLabel& naming_wave() const {
    const double half = 0.5 * amplitude;
    return rising.amplitude < half && largest.amplitude >= half ? largest : rising;
  }
  /// [1] Its amplitude over the peak's. The shares of several waves add up to more than 1 if their crests do not
  /// coincide.
  double wave_share() const { return amplitude > 0 ? naming_wave().amplitude / amplitude : 0.0; }
  /// Whether no wave has half of the amplitude.
  bool is_mixed() const { return naming_wave().amplitude < 0.5 * amplitude; }
  /// All named waves but naming_wave(), the largest first.
  std::vector<WaveLabel> waves_beside() const;
  /// Whether another wave is larger than the one that makes the peak.
  bool has_larger_wave() const { return largest.amplitude > rising.amplitude; }
  /// [1] the spacing over the half-width of the narrowest resonance among the peak's large waves; nothing if the
  /// response does not state the damping.
  std::optional<double> spacing_over_half_width() const;
};

/// "EO 20 ND 0": naming_wave(). Of a mixed motion, "mixed: EO 10 ND 0 48 %, EO 6 ND -4 30 %, EO 2 ND +2 21 %": the
/// wave that makes the peak and the two largest others, the largest first.
std::string wave_names(const CriticalSpeed& critical);

/// All peaks (named_peaks()), located or not, ascending in speed; with_predictions() adds what the rules predict.
/// Needs a response at every speed.
std::vector<CriticalSpeed> critical_speeds(const Response& response, const ContactLine& contact,
                                           const TipAmplitudes& amplitudes, const FrequencyCurves& curves,
                                           const PostprocessParameters& parameters);

/// Index of the one with the largest amplitude; nothing if there is none.
std::optional<std::size_t> largest_critical(const std::vector<CriticalSpeed>& critical);

/// How far an end of the operating range is from the nearest critical speed outside it.
struct SpeedMargin {
  double speed = 0;   ///< [rad/s] the critical one
  double margin = 0;  ///< [1] to the nearer end of its interval, of the speed at that end of the range
};

/// Where the critical speeds lie relative to the operating range of a wheel.
struct OperatingMargin {
  std::vector<CriticalSpeed> inside;        ///< those whose interval reaches into the range, its ends included
  std::optional<SpeedMargin> below, above;  ///< the nearest outside; nothing if there is none
};

/// `critical`: ascending in speed.
OperatingMargin operating_margin(const std::vector<CriticalSpeed>& critical, const SpeedRange& operating);

}  // namespace tiprub::postprocess
