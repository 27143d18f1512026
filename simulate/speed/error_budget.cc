// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/speed/error_budget.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <iterator>
#include <map>
#include <numbers>
#include <string>

#include "simulate/motion/attempt.h"
#include "simulate/response/peaks.h"
#include "simulate/scene/friction_limit.h"
#include "simulate/speed/settled_march.h"

namespace tiprub::simulate {

namespace {

constexpr double least_half_width = 2e-3, most_half_width = 1e-2;  // of the speed
constexpr int first_steps[] = {-4, -2, -1, 0, 1, 2, 4};            // half-widths from the critical speed
constexpr double stride = 2;                                       // half-widths, where the response still rises
constexpr double farthest = 0.1;  // of the speed: a peak beyond is taken for another one
constexpr double fineness = 0.2;  // of a half-width: the gaps beside a located top
constexpr double fallen = 0.8;    // of the scanned height: the motion at the top is another one, beyond a jump
constexpr int retreats = 3;       // from a jump

/// The top of a scanned curve and its neighbours.
struct Top {
  SampledSpeed left, top, right;

  double left_gap() const { return top.speed - left.speed; }
  double right_gap() const { return right.speed - top.speed; }
  bool jumps() const { return std::min(left.amplitude, right.amplitude) < fallen * top.amplitude; }
};

/// The engine order with the largest mean square, over all contact nodes and directions.
int largest_order(const Recorded& motion) {
  const Eigen::Index samples = motion.displacement.rows();
  const int orders = (motion.samples_per_revolution - 1) / 2;
  const double angle = 2 * std::numbers::pi / motion.samples_per_revolution;
  Eigen::MatrixXcd waves(orders, samples);
  for (Eigen::Index s = 0; s < samples; ++s)
    for (int order = 1; order <= orders; ++order)
      waves(order - 1, s) = std::polar(1.0, -angle * static_cast<double>(order * s % motion.samples_per_revolution));
  Eigen::Index largest = 0;
  (waves * motion.displacement).rowwise().squaredNorm().maxCoeff(&largest);
  return static_cast<int>(largest) + 1;
}

/// The critical speed from which a peak is followed.
struct Origin {
  double speed;  ///< [rad/s]
  int order;     ///< the largest engine order there
};

/// Climbs a response from a speed to a peak near it, with a coarse step. Where another engine order is the largest,
/// the response belongs to another peak and counts as zero.
class Climb {
 public:
  Climb(const Scene& scene, const Origin& origin) : scene_(scene), origin_(origin) {
    const double damping = scene.parameters.damping.smallest();
    half_width_ = origin.speed * std::clamp(damping, least_half_width, most_half_width);
    for (const int steps : first_steps) look(origin.speed + steps * half_width_);
    while (reach_out()) continue;
  }

  /// Raises NoMotion if the response rises to the end of what was looked at.
  Top located() {
    while (true) {
      const auto top = highest();
      if (curve_.empty() || top == curve_.begin() || std::next(top) == curve_.end() || !(top->second > 0))
        throw NoMotion("no peak of engine order " + std::to_string(origin_.order) + " within a tenth of the speed");
      const Top found{sample(std::prev(top)), sample(top), sample(std::next(top))};
      if (std::max(found.left_gap(), found.right_gap()) <= fineness * half_width_) return found;
      look(found.left_gap() > found.right_gap() ? found.top.speed - found.left_gap() / 2
                                                : found.top.speed + found.right_gap() / 2);
    }
  }

 private:
  using Curve = std::map<double, double>;  // [m] over [rad/s]

  static SampledSpeed sample(Curve::const_iterator at) { return {at->first, at->second}; }
  Curve::const_iterator highest() const {
    return std::max_element(curve_.begin(), curve_.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; });
  }

  void look(double speed) {
    if (speed <= 0 || speed > scene_.model.speed_max) return;
    const auto motion =
        attempt([&] { return settle_roughly(scene_, rotor_of(scene_, speed, OtherDiameters::unknown)); });
    if (!motion.result) return;
    const Recorded& recorded = motion.result->recorded;
    curve_[speed] = largest_order(recorded) == origin_.order ? recorded.amplitude : 0;
  }

  /// Looks beyond the end towards which the response rises. Returns whether there was anything to look at.
  bool reach_out() {
    const std::size_t before = curve_.size();
    if (before == 0) return false;
    const auto top = highest();
    const bool at_low_end = top == curve_.begin();
    if (!at_low_end && std::next(top) != curve_.end()) return false;
    const double next = top->first + (at_low_end ? -stride : stride) * half_width_;
    if (std::abs(next / origin_.speed - 1) <= farthest) look(next);
    return curve_.size() > before;
  }

  const Scene& scene_;
  Origin origin_;
  double half_width_ = 0;
  Curve curve_;
};

/// The vertex of the parabola through the top and its neighbours.
double vertex(const Top& top) {
  return top.top.speed + parabola_top({top.left.speed, top.top.speed, top.right.speed},
                                      {top.left.amplitude, top.top.amplitude, top.right.amplitude})
                             .offset;
}

/// The peak near a speed, marched within the tolerances. Where the response jumps beside the top, the finer step may
/// have jumped already; a speed a little farther from the jump is taken then.
PeakVariation peak_near(const Scene& scene, const Origin& origin) {
  const Top top = Climb(scene, origin).located();
  const double away = top.left.amplitude < top.right.amplitude ? top.right_gap() : -top.left_gap();
  PeakVariation peak;
  for (int i = 0; i <= (top.jumps() ? retreats : 0); ++i) {
    const double speed = top.jumps() ? top.top.speed + i * away : vertex(top);
    const RefinedMotion found = settle_within_tolerance(scene, rotor_of(scene, speed), {}, CycleChoice::left);
    const Recorded& recorded = found.motion.recorded;
    if (recorded.amplitude > peak.amplitude)
      peak = {peak.what,
              0,
              "",
              speed,
              recorded.amplitude,
              largest_excursion(recorded.displacement),
              found.motion.reading.motion,
              found.motion.reading.period_beats};
    if (peak.amplitude >= fallen * top.top.amplitude) break;
  }
  return peak;
}

PeakVariation varied(Variation what, double setting, const Scene& scene, const Origin& origin) {
  const auto found = attempt([&] { return peak_near(scene, origin); });
  PeakVariation variation = found.result.value_or(PeakVariation{});
  variation.what = what;
  variation.setting = setting;
  variation.failure = found.failure;
  return variation;
}

PeakVariation with_friction(const Scene& scene, double coefficient, const Origin& origin) {
  if (const FrictionLimit limit = friction_limit(scene.model); coefficient >= limit.coefficient)
    return {Variation::friction, coefficient, limit.text()};
  Casing casing = scene.casing;
  casing.friction = coefficient;
  return varied(Variation::friction, coefficient, {scene.model, casing, scene.parameters, scene.scope}, origin);
}

PeakVariation with_damping(const Scene& scene, double ratio, const Origin& origin) {
  SimulateParameters parameters = scene.parameters;
  parameters.damping = Damping{ratio};
  parameters.damping.set_beyond(parameters.resolved_frequency, scene.parameters.damping.ratios().beyond);
  return varied(Variation::damping, ratio, {scene.model, scene.casing, parameters, scene.scope}, origin);
}

PeakVariation with_clearance(const Scene& scene, double change, const Origin& origin) {
  Casing casing = scene.casing;
  for (auto& [place, clearance] : casing.clearance) clearance += change;
  return varied(Variation::clearance, change, {scene.model, casing, scene.parameters, scene.scope}, origin);
}

}  // namespace

std::vector<PeakVariation> error_budget(const Scene& scene, double speed, const Recorded& motion) {
  const Origin origin{speed, largest_order(motion)};
  std::vector<PeakVariation> rows;
  if (const double coefficient = scene.parameters.budget_friction; coefficient != scene.casing.friction)
    rows.push_back(with_friction(scene, coefficient, origin));
  for (const double ratio : scene.parameters.budget_damping) rows.push_back(with_damping(scene, ratio, origin));
  for (const double sign : {-1.0, 1.0})
    rows.push_back(with_clearance(scene, sign * scene.parameters.budget_clearance, origin));
  return rows;
}

}  // namespace tiprub::simulate
