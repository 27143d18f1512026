// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/sweep_comparison.h"

#include <algorithm>
#include <cmath>

#include "cases/program/errors.h"
#include "postprocess/analysis/critical_speeds.h"
#include "postprocess/analysis/input_check.h"
#include "postprocess/waves/travelling_spectrum.h"
#include "simulate/response/response_file.h"

namespace tiprub {

namespace {

constexpr double same_speed = 1e-9;        // of the speed
constexpr double clear_difference = 0.01;  // of settled motions: a hundred times what settling leaves open by default
// Of irregular ones. Two stretches of one random motion, whose amplitudes are Rayleigh-distributed, differ by
// sqrt(2 - pi/2) = 0.655 in the mean square.
constexpr double clear_irregular_difference = 0.7;

/// Amplitudes of the whole engine orders, as far as both spectra reach.
Eigen::MatrixXd whole_orders(const TravellingSpectrum& spectrum, int last) {
  Eigen::MatrixXd orders(last + 1, spectrum.amplitude.cols());
  for (Eigen::Index order = 0; order <= last; ++order)
    orders.row(order) = spectrum.amplitude.row(order * spectrum.revolutions);
  return orders;
}

double relative_difference(const TravellingSpectrum& a, const TravellingSpectrum& b) {
  const int last = std::min((a.lines() - 1) / a.revolutions, (b.lines() - 1) / b.revolutions);
  const Eigen::MatrixXd one = whole_orders(a, last), other = whole_orders(b, last);
  const double scale = std::max(one.norm(), other.norm());
  return scale > 0 ? (one - other).norm() / scale : 0.0;
}

void require_same_scene(const SimulatedScene& one, const SimulatedScene& other, const std::filesystem::path& path) {
  if (one.model_digest != other.model_digest || one.sector_count != other.sector_count || one.lobes != other.lobes ||
      one.clearance.size() != other.clearance.size() ||
      one.casing_distortion.size() != other.casing_distortion.size() ||
      one.casing_distortion != other.casing_distortion || one.clearance != other.clearance)
    throw InputError(path.string() + ": is of another rotor or casing than the response; sweep this case");
}

void add(std::vector<SweepComparison>& comparisons, std::optional<SweptSpeed> SweepComparison::*direction,
         const Response& response, const ContactLine& contact, int node, Component component,
         const std::filesystem::path& path) {
  Response swept = read_response(path);
  require_same_scene(response.scene, swept.scene, path);
  check_measures(swept, path.string());
  std::erase_if(swept.speeds,
                [](const SpeedResponse& speed) { return !speed.failure.empty(); });  // they have no motion
  const TipAmplitudes amplitudes = tip_amplitudes(swept, contact, component);
  for (SweepComparison& comparison : comparisons) {
    const SpeedResponse& here = response.speeds[static_cast<std::size_t>(comparison.index)];
    for (std::size_t i = 0; i < swept.speeds.size(); ++i) {
      const SpeedResponse& there = swept.speeds[i];
      if (std::abs(there.speed - here.speed) > same_speed * here.speed) continue;
      const auto spectrum = [&](const SpeedResponse& speed, const SimulatedScene& scene) {
        return travelling_spectrum(tip_motion(speed, scene, contact, node, component), speed.recorded_revolutions);
      };
      SweptSpeed found{
          .amplitude = amplitudes.largest[static_cast<Eigen::Index>(i)],
          .motion = there.motion,
          .period_beats = there.period_beats,
          .difference = relative_difference(spectrum(here, response.scene), spectrum(there, swept.scene))};
      const bool settle = here.settled() && there.settled();
      found.differs = found.difference > (settle ? clear_difference : clear_irregular_difference);
      comparison.*direction = found;
    }
  }
}

}  // namespace

std::vector<SweepComparison> compare_sweeps(const Response& response, const ContactLine& contact, int node,
                                            Component component, const SweepFiles& files) {
  std::vector<SweepComparison> comparisons;
  if (files.up.empty() && files.down.empty()) return comparisons;
  for (std::size_t i = 0; i < response.speeds.size(); ++i)
    comparisons.push_back({.index = static_cast<Eigen::Index>(i), .up = {}, .down = {}});
  if (!files.up.empty()) add(comparisons, &SweepComparison::up, response, contact, node, component, files.up);
  if (!files.down.empty()) add(comparisons, &SweepComparison::down, response, contact, node, component, files.down);
  return comparisons;
}

}  // namespace tiprub
