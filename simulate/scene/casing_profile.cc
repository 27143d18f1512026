// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/casing_profile.h"

#include <math.h>  // isnan, which Boost 1.74's pchip takes from the global scope

#include <algorithm>
#include <array>
#include <boost/math/interpolators/pchip.hpp>
#include <cmath>
#include <cstddef>
#include <utility>

#include "cases/program/text.h"
#include "cases/program/text_file.h"
#include "cases/program/units.h"

namespace tiprub::simulate {

namespace {

std::vector<double> read_stations(const NamedText& file, const NumberLine& heading) {
  std::vector<double> stations;
  for (std::size_t word = 1; word < heading.words.size(); ++word) {
    const double station = number_in(file, heading, word, "a fraction of the arc length");
    if (station < 0 || station > 1 || (!stations.empty() && station <= stations.back()))
      refuse_line(file, heading.number,
                  "must be a word and then fractions of the arc length, increasing in 0 .. 1; \"" +
                      std::string(heading.words[word]) + "\" isn't");
    stations.push_back(station);
  }
  if (stations.empty())
    refuse_line(file, heading.number, "must be \"angle_deg\" and the fractions of the arc length of the columns");
  return stations;
}

}  // namespace

/// Slopes depend on the neighbours at both sides, so that one point of the period before and two of the period after
/// are added. This also gives pchip the four points that it needs if there is only one.
PeriodicTable::PeriodicTable(const std::vector<std::array<double, 2>>& points, double period)
    : start_(points.front()[0]), period_(period) {
  std::vector<double> xs, ys;
  const auto add = [&](const std::array<double, 2>& point, int periods) {
    xs.push_back(point[0] + periods * period);
    ys.push_back(point[1]);
  };
  add(points.back(), -1);
  for (const std::array<double, 2>& point : points) add(point, 0);
  add(points.front(), 1);
  add(points.size() > 1 ? points[1] : points.front(), points.size() > 1 ? 1 : 2);
  cubic_ = boost::math::interpolators::pchip<std::vector<double>>(std::move(xs), std::move(ys));
}

double PeriodicTable::operator()(double x) const {
  const double wrapped = x - period_ * std::floor((x - start_) / period_);
  return cubic_(wrapped >= start_ + period_ ? start_ : wrapped);  // rounding just below a whole period
}

CasingProfile::CasingProfile(std::vector<double> stations,
                             const std::vector<std::vector<std::array<double, 2>>>& columns, double period)
    : stations_(std::move(stations)) {
  for (const std::vector<std::array<double, 2>>& points : columns) {
    curves_.emplace_back(points, period);
    for (const auto& [angle, inward] : points) largest_ = std::max(largest_, std::abs(inward));
  }
}

double CasingProfile::operator()(double angle, double fraction) const {
  const auto above = std::ranges::upper_bound(stations_, fraction);
  const auto next = static_cast<std::size_t>(above - stations_.begin());
  if (next == 0) return curves_.front()(angle);
  if (next == stations_.size()) return curves_.back()(angle);
  const double share = (fraction - stations_[next - 1]) / (stations_[next] - stations_[next - 1]);
  return (1 - share) * curves_[next - 1](angle) + share * curves_[next](angle);
}

CasingProfile read_casing_profile(const NamedText& file, double period) {
  std::vector<NumberLine> lines = lines_of(file);
  std::erase_if(lines, [](const NumberLine& line) { return line.words.empty(); });
  if (lines.size() < 2)
    refuse_line(file, 1, "must hold a line of fractions of the arc length, and one for each angle");
  const std::vector<double> stations = read_stations(file, lines.front());
  std::vector<std::vector<std::array<double, 2>>> columns(stations.size());
  for (std::size_t row = 1; row < lines.size(); ++row) {
    require_words(file, lines[row], 1 + stations.size(), "an angle [deg], and for each fraction how far inward [m]");
    const double angle = radians_per_degree * number_in(file, lines[row], 0, "an angle [deg]");
    if (angle < 0 || angle >= period ||
        (row > 1 && angle <= columns.front().back()[0] + PeriodicTable::closest * period)) {
      refuse_line(file, lines[row].number,
                  text_of("angles must increase in 0 .. ", period / radians_per_degree, " deg, that end excluded; ",
                          lines[row].words[0], " doesn't"));
    }
    for (std::size_t word = 1; word <= stations.size(); ++word)
      columns[word - 1].push_back({angle, number_in(file, lines[row], word, "how far inward [m]")});
  }
  return {stations, columns, period};
}

}  // namespace tiprub::simulate
