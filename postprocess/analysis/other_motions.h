// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "postprocess/analysis/postprocess_parameters.h"
#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub::postprocess {

/// [1] Differences of irregular motions below this are chance. Two stretches of one random motion, whose amplitudes
/// are Rayleigh-distributed, differ by sqrt(2 - pi/2) = 0.655 in the mean square.
inline constexpr double clear_irregular_difference = 0.7;

/// Responses of the same case swept up and down; an empty path means that there is none.
struct SweepFiles {
  std::filesystem::path up, down;
};

/// One speed as a sweep reached it, starting from the motion at the speed before.
struct SweptSpeed {
  double amplitude = 0;  ///< [m] half of the peak-to-peak, the largest over sectors and nodes
  MotionClass motion = MotionClass::not_settled;
  int period_beats = 0;
  /// [1] Norm of the difference between this two-way spectrum and that of the response from rest over the larger of
  /// their norms, at whole engine orders and at the maps' contact node. Spectra are compared because irregular
  /// motions never repeat sample by sample.
  double difference = 0;
  bool differs = false;  ///< clearly above the settling tolerance, and for irregular motions above chance
};

/// A speed of the response and what the sweeps up and down reached there; nothing where a sweep has no such speed.
struct SweepComparison {
  Eigen::Index index = 0;  ///< in the response's speeds
  std::optional<SweptSpeed> up, down;

  bool differs() const { return (up && up->differs) || (down && down->differs); }
};

/// One entry per speed of `response`, or none if neither sweep is given. Raises RunError as read_response() does, and
/// InputError if a sweep is of another rotor, casing or physics, or does not go in its direction.
std::vector<SweepComparison> compare_sweeps(const Response& response, const ContactLine& contact, int node,
                                            Component component, const SweepFiles& files);

/// A range of speeds in which the number of known orbits does not change.
struct OrbitRange {
  double low, high;  ///< [rad/s]
  int orbits;        ///< of all branches together, at any speed inside
  int attracting;    ///< how many of them attract
};

/// How an orbit loses its stability: where its largest multiplier leaves the unit circle.
enum class Instability {
  fold,   ///< at 1: it merges with another orbit
  flip,   ///< at -1: one of twice the period branches off
  torus,  ///< elsewhere: a second frequency appears
};
/// `angle`: of the largest multiplier [rad], 0 .. pi.
Instability instability(double angle);
const char* name_of(Instability kind);

/// Where the magnitude of an orbit's largest multiplier passes 1.
struct StabilityChange {
  double speed;  ///< [rad/s] interpolated between two orbits in the logarithms of their multipliers
  Instability kind;
};
/// Ascending in speed.
std::vector<StabilityChange> stability_changes(const std::vector<OrbitBranch>& branches);

/// Ranges with two orbits or more, ascending; adjacent ranges differ in the number of orbits or of attracting
/// orbits.
std::vector<OrbitRange> ranges_of_many_orbits(const std::vector<OrbitBranch>& branches);

}  // namespace tiprub::postprocess
