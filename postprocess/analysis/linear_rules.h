// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "postprocess/analysis/critical_speeds.h"
#include "postprocess/waves/aliasing.h"
#include "postprocess/waves/travelling_spectrum.h"
#include "postprocess/waves/wave_label.h"

namespace tiprub::postprocess {

/// A speed at which a rule predicts an interaction.
struct Crossing {
  double speed = 0;               ///< [rad/s]
  double frequency = 0;           ///< [Hz] in the rotor frame
  int engine_order = 0;           ///< multiple of the rotation frequency
  int signed_nodal_diameter = 0;  ///< see aliasing.h
  int family = 0;                 ///< 0 is the lowest
  double amplitude = 0;           ///< [m] of that wave in the response there; linear between its speeds
};

/// Speeds [rad/s] in the range with f(Omega) = |-f_c + k Omega/(2 pi)| (paper, eq. 2 with n_d = k; all in Hz),
/// ascending. Eq. 2 is eq. 1, f = +-f_c +- n_d Omega, without the waves that contact cannot excite. Roots are
/// found as sign changes on `root_intervals` equal intervals and refined by bisection. Two roots inside one
/// interval are missed; for f_c = 0 a curve would have to cross an engine order twice within 1/400 of the range.
std::vector<double> criterion_speeds(const std::function<double(double)>& frequency, int engine_order,
                                     double casing_frequency, const SpeedRange& range);

/// Eq. 2 at f_c = 0: all crossings of these families of nodal diameters 1 .. N/2 with the engine order of the same
/// number. Eq. 2 excludes forward waves.
std::vector<Crossing> equation_2_crossings(const FrequencyCurves& curves, int sector_count,
                                           const std::vector<int>& families, const SpeedRange& range);

/// All crossings of these families with those of the engine orders that a casing with N_l lobes excites: N_l
/// (paper, eq. 16) and its multiples, each on the nodal diameter of eq. 17. Ascending in speed; none for
/// lobes = 0.
std::vector<Crossing> aliased_crossings(const FrequencyCurves& curves, int sector_count,
                                        const std::vector<int>& families, int lobes,
                                        const std::vector<int>& engine_orders, const SpeedRange& range);

/// Families and engine orders that move, ascending: those of the waves, on whole engine orders, that reach a tenth
/// of the largest amplitude of all speeds at some speed, and those of the waves that make the critical speeds. The
/// linear rules are applied to these. With fewer, they would miss peaks that they can predict; with more, they
/// would give hundreds of false alarms for waves that do not move.
struct MovingWaves {
  std::vector<int> families;
  std::vector<int> engine_orders;
};

/// How well a linear rule predicted the critical speeds: counted, and weighted by amplitude, because a rule that
/// predicts the large ones is more useful than one that predicts many small ones.
struct RuleScore {
  int hits = 0;                  ///< critical speeds that it predicted
  int misses = 0;                ///< critical speeds that it did not
  int false_alarms = 0;          ///< crossings on nodal diameters that can move, without a critical speed there
  double predicted_share = 0;    ///< [1] summed amplitudes of its hits over those of all critical speeds
  double alarm_amplitude = 0;    ///< [m] largest wave amplitude at a false alarm
  double summed_amplitudes = 0;  ///< [m] of all critical speeds
  double summed_alarms = 0;      ///< [m] wave amplitudes at the false alarms
};

/// A crossing predicts a critical speed if engine order, signed nodal diameter, family and, within `tolerance` of the
/// critical speed, the speed agree with those of the wave that makes the peak.
bool predicts(const Crossing& crossing, const CriticalSpeed& critical, double tolerance);
/// Whether one of the crossings predicts it.
bool predicts(const std::vector<Crossing>& crossings, const CriticalSpeed& critical, double tolerance);

RuleScore score(const std::vector<Crossing>& crossings, const std::vector<int>& moving, double tolerance,
                const std::vector<CriticalSpeed>& critical);

/// What the linear rules list for the waves that move, and how well that predicted the critical speeds.
struct LinearRules {
  MovingWaves moving{};  ///< what they are applied to
  std::vector<Crossing>
      equation_2{};                 ///< f_i^n(Omega) = n Omega: the paper's eq. 2 at f_c = 0, the engine order is n
  std::vector<Crossing> aliased{};  ///< f_i^n(Omega) = k N_l Omega for every k that eq. 17 allows on n
  RuleScore equation_2_score{}, aliasing_score{};
};
/// Covers all waves that move, drawn or not, so that a score does not depend on the figures.
LinearRules linear_rules(const Response& response, const ContactLine& contact, const FrequencyCurves& curves,
                         const TipAmplitudes& amplitudes, const std::vector<CriticalSpeed>& critical,
                         const PostprocessParameters& parameters);

/// The critical speeds, each marked with the rules that predict it.
std::vector<CriticalSpeed> with_predictions(std::vector<CriticalSpeed> critical, const LinearRules& rules,
                                            double tolerance);

}  // namespace tiprub::postprocess
