// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/speed/followed_peak.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <vector>

#include "simulate/motion/attempt.h"

namespace tiprub::simulate {

namespace {

constexpr int first_steps[] = {-4, -2, -1, 0, 1, 2, 4};  // half-widths from the old top
constexpr double stride = 2;                             // half-widths, beyond an end that is not the foot
constexpr double foot = 0.5;                             // of the largest amplitude: less is beside the peak
constexpr double farthest = 0.1;                         // of the speed
constexpr double fineness = 0.2;                         // of a half-width: the gaps beside a located top
constexpr double fallen = 0.8;                           // of the top: less beside it is another motion

class SampledResponse {
 public:
  SampledResponse(const PeakOrigin& origin, const AmplitudeAt& amplitude_at)
      : origin_(origin), amplitude_at_(amplitude_at) {
    for (const int steps : first_steps) look(origin.speed + steps * origin.half_width);
    while (reach_beyond(curve_.begin(), -stride) || reach_beyond(curve_.rbegin(), stride)) continue;
  }

  /// Each maximum that may be the highest is sampled at every half-width around it, then the highest of them is
  /// located.
  PeakTop located() {
    for (bool all = false; !all;) {
      all = true;
      for (const double speed : maxima()) all = narrow(speed, origin_.half_width) && all;
    }
    for (;;) {
      const double speed = highest();
      if (!narrow(speed, fineness * origin_.half_width)) continue;
      const PeakTop top = at(speed);
      if (!goes_on_as_another(top)) return top;
      no_tops_.insert(speed);
    }
  }

 private:
  using Curve = std::map<double, double>;

  PeakTop at(double speed) const {
    const auto top = curve_.find(speed);
    const auto sample = [](Curve::const_iterator i) { return SampledSpeed{i->first, i->second}; };
    return {sample(std::prev(top)), sample(top), sample(std::next(top))};
  }

  /// Looks into the middle of the wider gap beside a maximum, unless both are narrow enough. Returns whether they
  /// are.
  bool narrow(double speed, double enough) {
    const PeakTop found = at(speed);
    if (std::max(found.left_gap(), found.right_gap()) <= enough) return true;
    const bool on_left = found.left_gap() > found.right_gap();
    if (!look(on_left ? speed - found.left_gap() / 2 : speed + found.right_gap() / 2))
      throw NoMotion("the motion beside the peak could not be computed");
    return false;
  }

  bool look(double speed) {
    const std::optional<double> amplitude = amplitude_at_(speed);
    if (!amplitude) return false;
    curve_[speed] = std::max(*amplitude, 0.0);
    if (*amplitude < 0) others_[speed] = -*amplitude;
    return true;
  }

  /// Beside the top of a peak the response may also jump to another motion.
  bool goes_on_as_another(const PeakTop& found) const {
    const auto goes_on = [&](const SampledSpeed& beside) {
      const auto other = others_.find(beside.speed);
      return other != others_.end() && other->second >= fallen * found.top.amplitude;
    };
    return goes_on(found.left) || goes_on(found.right);
  }

  /// Looks beyond an end of the range that may not be the foot of the peak. Returns whether there was anything to
  /// look at.
  template <class End>
  bool reach_beyond(End end, double half_widths) {
    return curve_.size() > 1 && goes_on(end->second, std::next(end)->second) &&
           reach(end->first + half_widths * origin_.half_width);
  }
  bool goes_on(double end, double before) const { return end > before || end > foot * largest(); }
  bool reach(double speed) { return std::abs(speed / origin_.speed - 1) <= farthest && look(speed); }

  double largest() const { return std::ranges::max_element(curve_, {}, &Curve::value_type::second)->second; }

  /// The speeds of the maxima that have more than half of the amplitude of the highest, which is not at an end.
  std::vector<double> maxima() const {
    std::vector<double> speeds;
    for (auto i = curve_.begin(); i != curve_.end(); ++i) {
      if (i == curve_.begin() || std::next(i) == curve_.end() || no_tops_.contains(i->first)) continue;
      if (i->second > std::prev(i)->second && i->second >= std::next(i)->second) speeds.push_back(i->first);
    }
    if (!speeds.empty()) {
      const double enough = foot * curve_.at(highest_of(speeds));
      std::erase_if(speeds, [&](double speed) { return curve_.at(speed) <= enough; });
    }
    return speeds;
  }

  double highest() const {
    const std::vector<double> tops = maxima();
    if (tops.empty()) throw NoMotion("no peak of the same engine order within a tenth of the speed");
    return highest_of(tops);
  }
  double highest_of(const std::vector<double>& speeds) const {
    return *std::ranges::max_element(speeds, {}, [this](double speed) { return curve_.at(speed); });
  }

  const PeakOrigin& origin_;
  const AmplitudeAt& amplitude_at_;
  Curve curve_;               ///< zero where the motion belongs to another peak
  Curve others_;              ///< the amplitude there
  std::set<double> no_tops_;  ///< maxima of the curve at its ends towards another peak
};

}  // namespace

bool jumps(const PeakTop& peak) {
  return std::min(peak.left.amplitude, peak.right.amplitude) < fallen * peak.top.amplitude;
}

PeakTop follow_peak(const PeakOrigin& origin, const AmplitudeAt& amplitude_at) {
  return SampledResponse(origin, amplitude_at).located();
}

}  // namespace tiprub::simulate
