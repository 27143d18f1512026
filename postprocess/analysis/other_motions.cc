// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/other_motions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include "cases/program/case_file.h"
#include "cases/program/errors.h"
#include "cases/program/text.h"
#include "postprocess/analysis/critical_speeds.h"
#include "postprocess/analysis/input_check.h"
#include "postprocess/waves/travelling_spectrum.h"
#include "simulate/response/response_file.h"

namespace tiprub::postprocess {

namespace {

constexpr double same_speed = 1e-9;        // of the speed
constexpr double clear_difference = 0.01;  // for settled motions: a hundred times the default tolerance of settling

/// Amplitudes of the whole engine orders 0 .. last.
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

/// What of that which decides a motion, beside its start, differs between two scenes; empty if nothing does.
std::string difference(const SimulatedScene& one, const SimulatedScene& other) {
  if (one.model_digest != other.model_digest || one.sector_count != other.sector_count) return "rotor";
  for (const DifferingKey& differing : differing_keys(one.casing, other.casing)) return "[casing] " + differing.key;
  if (one.lobes != other.lobes || one.clearance.size() != other.clearance.size() ||
      one.casing_distortion.size() != other.casing_distortion.size() ||
      one.casing_distortion != other.casing_distortion || one.clearance != other.clearance ||
      one.node_distortion.size() != other.node_distortion.size() || one.node_distortion != other.node_distortion)
    return "casing";
  if (one.damping != other.damping) return "damping";
  if (one.scheme != other.scheme || one.contact != other.contact) return "scheme or contact law";
  const auto treatment = [](const ModelledEffect& effect) { return std::pair(effect.effect, effect.treatment); };
  return std::ranges::equal(one.effects, other.effects, {}, treatment, treatment) ? "" : "choice of what is modelled";
}

void require_sweep_of(const SimulatedScene& scene, const SimulatedScene& swept, const std::string& direction,
                      const std::filesystem::path& path) {
  if (const std::string differing = difference(scene, swept); !differing.empty())
    throw InputError(path.string() + ": is of another " + differing + " than the response; sweep this case");
  const std::map<std::string, std::string> keys = written_keys(swept.swept_case());
  const auto sweep = keys.find("simulate.sweep");
  if (!keys.empty() && (sweep == keys.end() || sweep->second != in_quotes(direction)))
    throw InputError(path.string() + ": is no sweep " + direction +
                     "; run tiprub-simulate with --set 'simulate.sweep=\"" + direction + "\"'");
}

void add(std::vector<SweepComparison>& comparisons, std::optional<SweptSpeed> SweepComparison::*direction,
         const Response& response, const ContactLine& contact, int node, Component component,
         const std::filesystem::path& path) {
  Response swept = read_response(path);
  require_sweep_of(response.scene, swept.scene, direction == &SweepComparison::up ? "up" : "down", path);
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
      const bool repeat = repeats(here.motion) && repeats(there.motion);
      found.differs = found.difference > (repeat ? clear_difference : clear_irregular_difference);
      comparison.*direction = found;
    }
  }
}

constexpr double flip_angle = 0.98 * std::numbers::pi;  // beyond it a multiplier counts as negative
constexpr double fold_angle = 0.02 * std::numbers::pi;  // below it, as positive

/// Speeds at which the number of orbits may change: where branches end, turn back or change their stability.
std::set<double> limits_of(const std::vector<OrbitBranch>& branches) {
  std::set<double> limits;
  for (const OrbitBranch& branch : branches)
    for (Eigen::Index i = 0; i < branch.speed.size(); ++i) {
      const bool is_end = i == 0 || i + 1 == branch.speed.size();
      const bool turns =
          !is_end && (branch.speed[i] - branch.speed[i - 1]) * (branch.speed[i + 1] - branch.speed[i]) < 0;
      const bool changes = i > 0 && branch.attracts(i) != branch.attracts(i - 1);
      if (is_end || turns || changes) limits.insert(branch.speed[i]);
    }
  return limits;
}

OrbitRange count(const std::vector<OrbitBranch>& branches, double low, double high) {
  OrbitRange range{low, high, 0, 0};
  const double speed = 0.5 * (low + high);
  for (const OrbitBranch& branch : branches)
    for (Eigen::Index i = 1; i < branch.speed.size(); ++i) {
      const double from = branch.speed[i - 1], to = branch.speed[i];
      if ((from < speed) == (to < speed)) continue;
      ++range.orbits;
      if (branch.attracts(i) && branch.attracts(i - 1)) ++range.attracting;
    }
  return range;
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

Instability instability(double angle) {
  if (angle > flip_angle) return Instability::flip;
  return angle < fold_angle ? Instability::fold : Instability::torus;
}

const char* name_of(Instability kind) {
  constexpr std::array names = {"fold", "flip", "torus"};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<StabilityChange> stability_changes(const std::vector<OrbitBranch>& branches) {
  std::vector<StabilityChange> changes;
  for (const OrbitBranch& branch : branches)
    for (Eigen::Index i = 1; i < branch.speed.size(); ++i) {
      if (branch.attracts(i) == branch.attracts(i - 1)) continue;
      const double before = std::log(branch.multiplier[i - 1]), after = std::log(branch.multiplier[i]);
      const double along = std::isfinite(before) && std::isfinite(after) ? before / (before - after) : 0.5;
      const Eigen::Index repels = branch.attracts(i) ? i - 1 : i;
      changes.push_back({branch.speed[i - 1] + along * (branch.speed[i] - branch.speed[i - 1]),
                         instability(branch.multiplier_angle[repels])});
    }
  std::ranges::sort(changes, {}, &StabilityChange::speed);
  return changes;
}

std::vector<OrbitRange> ranges_of_many_orbits(const std::vector<OrbitBranch>& branches) {
  const std::set<double> limits = limits_of(branches);
  std::vector<OrbitRange> ranges;
  for (auto low = limits.begin(); low != limits.end(); ++low) {
    const auto high = std::next(low);
    if (high == limits.end()) break;
    const OrbitRange range = count(branches, *low, *high);
    const bool goes_on = !ranges.empty() && ranges.back().high == range.low && ranges.back().orbits == range.orbits &&
                         ranges.back().attracting == range.attracting;
    if (goes_on)
      ranges.back().high = range.high;
    else if (range.orbits > 1)
      ranges.push_back(range);
  }
  return ranges;
}

}  // namespace tiprub::postprocess
