// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/speed/followed_peak.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "simulate/motion/attempt.h"

namespace tiprub::simulate {

namespace {

constexpr int first_steps[] = {-4, -2, -1, 0, 1, 2, 4};  // half-widths from the old top
constexpr double stride = 2;                             // half-widths, where the response still rises
constexpr double farthest = 0.1;                         // of the speed
constexpr double fineness = 0.2;                         // of a half-width: the gaps beside a located top
constexpr double fallen = 0.8;                           // of the top: less beside it is another motion

class SampledResponse {
 public:
  SampledResponse(const PeakOrigin& origin, const AmplitudeAt& amplitude_at)
      : origin_(origin), amplitude_at_(amplitude_at) {
    for (const int steps : first_steps) look(origin.speed + steps * origin.half_width);
    while (reach_down() || reach_up()) continue;
  }

  PeakTop located() {
    auto top = highest();
    while (true) {
      const PeakTop found{sample(std::prev(top)), sample(top), sample(std::next(top))};
      if (std::max(found.left_gap(), found.right_gap()) <= fineness * origin_.half_width) return found;
      const double between = found.left_gap() > found.right_gap() ? found.top.speed - found.left_gap() / 2
                                                                  : found.top.speed + found.right_gap() / 2;
      if (!look(between)) throw NoMotion("the motion beside the peak could not be computed");
      const auto inserted = curve_.find(between);
      if (inserted->second > top->second) top = inserted;
    }
  }

 private:
  using Curve = std::map<double, double>;

  static SampledSpeed sample(Curve::const_iterator at) { return {at->first, at->second}; }

  bool look(double speed) {
    const std::optional<double> amplitude = amplitude_at_(speed);
    if (amplitude) curve_[speed] = *amplitude;
    return amplitude.has_value();
  }

  /// Looks beyond an end towards which the response rises. Returns whether there was anything to look at.
  bool reach_down() {
    return curve_.size() > 1 && curve_.begin()->second > std::next(curve_.begin())->second &&
           reach(curve_.begin()->first - stride * origin_.half_width);
  }
  bool reach_up() {
    return curve_.size() > 1 && curve_.rbegin()->second > std::next(curve_.rbegin())->second &&
           reach(curve_.rbegin()->first + stride * origin_.half_width);
  }
  bool reach(double speed) { return std::abs(speed / origin_.speed - 1) <= farthest && look(speed); }

  Curve::const_iterator highest() const {
    auto best = curve_.end();
    for (auto at = curve_.begin(); at != curve_.end(); ++at) {
      if (at == curve_.begin() || std::next(at) == curve_.end()) continue;
      const bool is_top = at->second > std::prev(at)->second && at->second >= std::next(at)->second;
      if (is_top && (best == curve_.end() || at->second > best->second)) best = at;
    }
    if (best == curve_.end()) throw NoMotion("no peak of the same engine order within a tenth of the speed");
    return best;
  }

  const PeakOrigin& origin_;
  const AmplitudeAt& amplitude_at_;
  Curve curve_;
};

}  // namespace

bool PeakTop::jumps() const {
  return std::min(left.amplitude, right.amplitude) < fallen * top.amplitude;
}

double PeakTop::vertex() const {
  return top.speed +
         parabola_top({left.speed, top.speed, right.speed}, {left.amplitude, top.amplitude, right.amplitude}).offset;
}

PeakTop follow_peak(const PeakOrigin& origin, const AmplitudeAt& amplitude_at) {
  return SampledResponse(origin, amplitude_at).located();
}

}  // namespace tiprub::simulate
