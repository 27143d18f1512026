// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "postprocess/waves/aliasing.h"
#include "postprocess/waves/frequency_curves.h"

namespace tiprub {

/// [rad/s] the simulated speeds, ends included.
struct SpeedRange {
  double low = 0;
  double high = 0;
};

/// A speed at which a rule predicts an interaction.
struct Crossing {
  double speed = 0;               ///< [rad/s]
  double frequency = 0;           ///< [Hz] in the rotor frame
  int engine_order = 0;           ///< multiple of the rotation frequency
  int signed_nodal_diameter = 0;  ///< see aliasing.h
  int family = 0;                 ///< 0 is the lowest
  double amplitude = 0;           ///< [m] of that wave in the response there; see read_amplitudes()
};

/// Speeds [rad/s] in the range with f(Omega) = |-f_c + k Omega/(2 pi)| (paper, eq. 2 with n_d = k; all in Hz),
/// ascending. Eq. 2 is what is left of eq. 1, f = +-f_c +- n_d Omega, without the waves that contact can't drive.
/// Sign changes on `root_intervals` equal intervals, then bisection: two roots inside one interval are missed, which
/// for f_c = 0 would need a curve that crosses an engine order twice within 1/400 of the range.
std::vector<double> criterion_speeds(const std::function<double(double)>& frequency, int engine_order,
                                     double casing_frequency, const SpeedRange& range);

/// Eq. 2 at f_c = 0: all crossings of some families of nodal diameters 1 .. N/2 with their own engine order. Forward
/// waves are not among them: eq. 2 excludes them.
std::vector<Crossing> equation_2_crossings(const FrequencyCurves& curves, int sector_count,
                                           const std::vector<int>& families, const SpeedRange& range);

/// All crossings of some families with those of some engine orders that a casing with N_l lobes drives: the
/// fundamental f = N_l Omega (paper, eq. 16) and its multiples, each on the nodal diameter of eq. 17; ascending in
/// speed. None for lobes = 0.
std::vector<Crossing> aliased_crossings(const FrequencyCurves& curves, int sector_count,
                                        const std::vector<int>& families, int lobes,
                                        const std::vector<int>& engine_orders, const SpeedRange& range);

}  // namespace tiprub
