// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/peaks.h"

#include <algorithm>
#include <cmath>

namespace tiprub {

namespace {

/// The lowest sample from `index` in direction `step`, up to the first sample that is higher than the start.
Eigen::Index valley(const Eigen::VectorXd& curve, Eigen::Index index, int step) {
  Eigen::Index lowest = index;
  for (Eigen::Index i = index + step; i >= 0 && i < curve.size() && curve[i] <= curve[index]; i += step)
    if (curve[i] < curve[lowest]) lowest = i;
  return lowest;
}

bool is_maximum(const Eigen::VectorXd& curve, Eigen::Index index) {
  if (curve[index] <= curve[index - 1]) return false;
  Eigen::Index next = index + 1;
  while (next < curve.size() && curve[next] == curve[index]) ++next;
  return next < curve.size() && curve[next] < curve[index];
}

}  // namespace

std::vector<Peak> find_peaks(const Eigen::VectorXd& curve, double share) {
  std::vector<Peak> peaks;
  for (Eigen::Index i = 1; i + 1 < curve.size(); ++i) {
    if (!is_maximum(curve, i)) continue;
    Peak peak{i, valley(curve, i, -1), valley(curve, i, +1), 0.0};
    peak.prominence = curve[i] - std::max(curve[peak.left_valley], curve[peak.right_valley]);
    if (peak.prominence >= share * curve[i]) peaks.push_back(peak);
  }
  return peaks;
}

std::vector<Peak> named_peaks(const Eigen::VectorXd& curve, const PeakMeasure& measure) {
  std::vector<Peak> peaks = find_peaks(curve, std::min(measure.prominence, measure.apart));
  const double severe = curve.size() > 0 ? measure.severe * curve.maxCoeff() : 0.0;
  std::erase_if(peaks, [&](const Peak& peak) {
    return peak.prominence < measure.prominence * curve[peak.index] && curve[peak.index] < severe;
  });
  return peaks;
}

ParabolaTop parabola_top(const std::array<double, 3>& places, const std::array<double, 3>& values) {
  const double left = places[1] - places[0], right = places[2] - places[1];
  const double rise = (values[1] - values[0]) / left, fall = (values[2] - values[1]) / right;
  const double offset = 0.5 * (rise * right + fall * left) / (rise - fall);
  return {offset, (rise - fall) / (left + right) * offset * offset};
}

double PeakTop::vertex() const {
  return top.speed +
         parabola_top({left.speed, top.speed, right.speed}, {left.amplitude, top.amplitude, right.amplitude}).offset;
}

double rise_beside(const Eigen::VectorXd& places, const Eigen::VectorXd& curve, Eigen::Index place, int step) {
  const auto slope = [&](Eigen::Index from, Eigen::Index to) {
    return (curve[to] - curve[from]) / std::abs(places[to] - places[from]);
  };
  const Eigen::Index next = place + step, after = next + step;
  const double gap = std::abs(places[next] - places[place]), rise = slope(place - step, place);
  if (after < 0 || after >= curve.size()) return rise * gap;
  const double fall = slope(after, next), top = curve[next] + fall * gap;
  if (top < curve[place] || rise + fall <= 0) return std::min(rise * gap, curve[place] - curve[next]);
  return rise * (top - curve[place]) / (rise + fall);
}

std::vector<Eigen::Index> rising_ends(const Eigen::VectorXd& curve, double share) {
  std::vector<Eigen::Index> ends;
  const Eigen::Index last = curve.size() - 1;
  if (last < 1) return ends;
  const auto rises = [&](Eigen::Index end, int inward) {
    return curve[end] > 0 && curve[end] - curve[valley(curve, end, inward)] >= share * curve[end];
  };
  if (rises(0, +1)) ends.push_back(0);
  if (rises(last, -1)) ends.push_back(last);
  return ends;
}

}  // namespace tiprub
