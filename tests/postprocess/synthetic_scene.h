// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub::postprocess::synthetic {

/// A made rotor and a made response, whose every number is known in closed form.

/// [Hz^2] f^2 = rest^2 + stiffening (Omega/(2 pi))^2 of every mode below.
inline constexpr double stiffening = 0.4;

/// [Hz] at rest: families 0 and 1 clustered around 1500 and 2300, the others far above.
double rest_frequency(int nodal_diameter, int family);
/// [Hz] at a speed in rad/s.
double frequency(int nodal_diameter, int family, double speed);

/// [rad/s] where that mode meets an engine order k: sqrt(f0^2 + b r^2) = k r with r the rotation frequency, so r =
/// f0/sqrt(k^2 - b).
double crossing_speed(int nodal_diameter, int family, int engine_order);

/// N = 10 (or another number of sectors), four contact nodes on a tip line that turns from radial to axial.
ReducedModel model(int sector_count = 10);

/// Its natural frequencies over 0 .. 2500 rad/s.
FrequencyTable frequencies(const ReducedModel& model);

/// One travelling wave: sector j moves as amplitude cos(k (Omega t) + n j alpha + phase) along the normal.
struct Wave {
  double engine_order = 0;
  int signed_nodal_diameter = 0;
  double amplitude = 0;  ///< [m] along the normal
  double phase = 0;      ///< [rad]
  /// [1] of the amplitude at the four contact nodes, from the leading edge on
  Eigen::Vector4d shape = {1.0, 0.8, 0.6, 0.4};
};

/// A speed whose motion is a sum of waves; all sectors must repeat after `independent` ones. The counts and forces
/// follow from a two-lobed casing.
SpeedResponse speed(const SimulatedScene& scene, const ContactLine& contact, double speed,
                    const std::vector<Wave>& waves, int recorded_revolutions = 4);

/// A two-lobed scene of ten sectors, five of them independent.
SimulatedScene two_lobes();

/// What a linear wheel of these modes would do under the harmonics 2, 4, .. 12 of a two-lobed casing, each on the
/// signed nodal diameter of eq. 17: resonances of families 0 and 1. 48 speeds over 10,500 .. 18,500 rpm, one of them
/// failed, one irregular, one subharmonic.
Response resonant_sweep(const ReducedModel& model);

/// Writes case.toml, model.h5, fields.h5 and response.h5.
void write_scene(const std::filesystem::path& folder);

}  // namespace tiprub::postprocess::synthetic
