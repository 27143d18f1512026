// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "postprocess/analysis/critical_speeds.h"
#include "postprocess/analysis/linear_criterion.h"
#include "postprocess/waves/tip_motion.h"
#include "postprocess/waves/travelling_spectrum.h"

namespace tiprub {

/// Every travelling wave of a response at the contact node where it is the largest; a spectrum a speed. Needs a
/// response at every speed.
std::vector<TravellingSpectrum> largest_waves(const Response& response, const ContactLine& contact,
                                              Component component);

/// Families and engine orders that move, ascending: those of the waves, on whole engine orders, that reach a tenth of
/// `largest_amplitude`, that of all speeds, at some speed, and those of the waves that make the critical speeds. A
/// linear rule is asked for these. If it were asked for fewer, its misses would be the asker's; for more, it would be
/// blamed for hundreds of meetings that nobody would look for.
struct MovingWaves {
  std::vector<int> families;
  std::vector<int> engine_orders;
};
MovingWaves moving_waves(const Response& response, const std::vector<TravellingSpectrum>& waves,
                         const FrequencyCurves& curves, const std::vector<CriticalSpeed>& critical,
                         double largest_amplitude);

/// Gives each crossing the amplitude that its wave has in the response at its speed, linear between neighbouring
/// speeds.
void read_amplitudes(std::vector<Crossing>& crossings, const Response& response,
                     const std::vector<TravellingSpectrum>& waves);

/// What a linear rule was worth: counted, and weighted by amplitude, since a rule that names the large ones serves
/// better than one that names many.
struct RuleScore {
  int hits = 0;                  ///< critical speeds that it predicted
  int misses = 0;                ///< critical speeds that it did not
  int false_alarms = 0;          ///< its speeds, on nodal diameters that can move, without such a critical speed
  double predicted_share = 0;    ///< [1] of the critical speeds' summed amplitudes: what its hits have
  double alarm_amplitude = 0;    ///< [m] largest wave amplitude at a false alarm
  double summed_amplitudes = 0;  ///< [m] of all critical speeds
  double summed_alarms = 0;      ///< [m] wave amplitudes at the false alarms
};

/// A crossing predicts a critical speed if engine order, signed nodal diameter, family and, within `tolerance` of the
/// critical speed, the speed agree with those of the wave that makes the peak.
bool predicts(const Crossing& crossing, const CriticalSpeed& critical, double tolerance);
/// Whether one of them does.
bool predicts(const std::vector<Crossing>& crossings, const CriticalSpeed& critical, double tolerance);

RuleScore score(const std::vector<Crossing>& crossings, const std::vector<int>& moving, double tolerance,
                const std::vector<CriticalSpeed>& critical);

/// What the linear rules list for all that moves, and what that was worth.
struct LinearRules {
  MovingWaves moving{};  ///< that they are asked for
  std::vector<Crossing>
      equation_2{};                 ///< f_i^n(Omega) = n Omega: the paper's eq. 2 at f_c = 0, the engine order is n
  std::vector<Crossing> aliased{};  ///< f_i^n(Omega) = k N_l Omega for every k that eq. 17 allows on n
  RuleScore equation_2_score{}, aliasing_score{};
};
/// Over all that moves, not what is drawn: a score must not depend on the drawing.
LinearRules linear_rules(const Response& response, const ContactLine& contact, const FrequencyCurves& curves,
                         const TipAmplitudes& amplitudes, const std::vector<CriticalSpeed>& critical,
                         const PostprocessParameters& parameters);

/// The critical speeds with what each rule predicts of them.
std::vector<CriticalSpeed> with_predictions(std::vector<CriticalSpeed> critical, const LinearRules& rules,
                                            double tolerance);

}  // namespace tiprub
