// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/contact_maps.h"

#include <algorithm>
#include <boost/math/statistics/linear_regression.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "postprocess/waves/travelling_spectrum.h"
#include "simulate/motion/casing_areas.h"

namespace tiprub::postprocess {

namespace {

/// One speed's column of a contact node's map, for sector 0. If an area is so narrow that no step begins over it,
/// it gets the share of the area in which the step that crosses it began.
Eigen::VectorXd contact_shares(const SpeedResponse& speed, int sector_count, const ContactLine& contact, int node) {
  const auto areas = static_cast<int>(speed.contact_count.cols());
  const CasingSteps way{contact.position(node, 1), 0, sector_count, speed.steps_per_revolution};
  const Eigen::VectorXi steps = steps_over_areas(way, areas);
  Eigen::VectorXd share(areas);
  int last = areas - 1;  // area over which a step began
  while (last > 0 && steps[last] == 0) --last;
  for (int area = 0; area < areas; ++area) {
    if (steps[area] > 0) last = area;
    share[area] = static_cast<double>(speed.contact_count(node, last)) / (steps[last] * speed.recorded_revolutions);
  }
  return share;
}

constexpr double turn = 2 * std::numbers::pi;
constexpr std::size_t fewest = 3;  // speeds that make a line

/// N_l times the middle of the contact; NaN if the column is empty or has no middle.
double folded_phase(const Eigen::VectorXd& column, int lobes) {
  constexpr double no_middle = 1e-6;  // of the column's sum
  std::complex<double> sum = 0;
  const auto areas = static_cast<double>(column.size());
  for (Eigen::Index area = 0; area < column.size(); ++area)
    sum += column[area] * std::polar(1.0, lobes * turn * (static_cast<double>(area) + 0.5) / areas);
  return std::abs(sum) > no_middle * column.sum() ? std::arg(sum) : unknown;
}

/// The middle of each column's contact [rad], NaN without contact. Of the equal places on all lobes, each is the one
/// nearest to the middle before.
Eigen::VectorXd followed_angles(const ContactMap& map, int lobes) {
  Eigen::VectorXd angles = Eigen::VectorXd::Constant(map.share.cols(), unknown);
  double previous = 0;
  for (Eigen::Index i = 0; i < angles.size(); ++i) {
    const double phase = folded_phase(map.share.col(i), lobes);
    if (std::isnan(phase)) continue;
    previous = phase + turn * std::round((previous - phase) / turn);
    angles[i] = previous / lobes;
  }
  return angles;
}

/// Sum over the sectors of sum_t late(t + shift) early(t), the samples of whole revolutions.
double correlation(const Eigen::MatrixXd& late, const Eigen::MatrixXd& early, Eigen::Index shift) {
  const Eigen::Index samples = early.rows(), start = ((shift % samples) + samples) % samples;
  const Eigen::Index rest = samples - start;
  return late.bottomRows(rest).cwiseProduct(early.topRows(rest)).sum() +
         late.topRows(start).cwiseProduct(early.bottomRows(start)).sum();
}

/// None where x or y has no variance.
FittedLine fitted_line(const std::vector<double>& x, const std::vector<double>& y) try {
  const auto [intercept, slope, determination] =
      boost::math::statistics::simple_ordinary_least_squares_with_R_squared(x, y);
  const bool found = std::isfinite(intercept) && std::isfinite(slope) && std::isfinite(determination);
  return found ? FittedLine{intercept, slope, determination} : FittedLine{};
} catch (const std::domain_error&) {  // no variance
  return {};
}

/// Where the parabola through three values at -1, 0, 1, of which the middle one is the largest, has its top.
double top_of_parabola(double before, double here, double after) {
  const double bend = before - 2 * here + after;
  return bend < 0 ? 0.5 * (before - after) / bend : 0.0;
}

/// The shift [samples] within `reach` of `expected` at which `late` is most like `early`, and their likeness there.
std::pair<double, double> most_alike(const Eigen::MatrixXd& late, const Eigen::MatrixXd& early, double expected,
                                     double reach) {
  const auto first = static_cast<Eigen::Index>(std::ceil(expected - reach));
  const auto last = static_cast<Eigen::Index>(std::floor(expected + reach));
  Eigen::Index best = first;
  double largest = -1;
  for (Eigen::Index shift = first; shift <= last; ++shift)
    if (const double here = correlation(late, early, shift); here > largest) {
      largest = here;
      best = shift;
    }
  const double top = top_of_parabola(correlation(late, early, best - 1), largest, correlation(late, early, best + 1));
  return {static_cast<double>(best) + top, largest / (late.norm() * early.norm())};
}

/// The lag [s] and the likeness; NaN and 0 unless both edges touch.
std::pair<double, double> lag_at(const SpeedResponse& speed, const SimulatedScene& scene,
                                 const ContactLine& contact) {
  const int last = contact.trailing_edge();
  const Eigen::MatrixXd leading = tip_force(speed, scene, 0), trailing = tip_force(speed, scene, last);
  if (leading.norm() == 0 || trailing.norm() == 0) return {unknown, 0.0};
  const double samples_per_radian = speed.samples_per_revolution / turn;
  // A place of the casing meets the node that is ahead first.
  const double expected = samples_per_radian * (contact.position(last, 1) - contact.position(0, 1));
  const double half_a_beat = 0.5 * speed.samples_per_revolution / std::max(scene.lobes, 1);
  const auto [shift, likeness] = most_alike(leading, trailing, expected, half_a_beat);
  return {(shift - expected) / (samples_per_radian * speed.speed), likeness};
}

/// The value below which that share of the values lies, linear between neighbours; needs ascending values.
double quantile(const std::vector<double>& values, double share) {
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

}  // namespace

double contact_contrast(const Eigen::VectorXd& column) {
  const double sum = column.sum();
  if (sum <= 0) return 0.0;
  return 1 - sum * sum / (static_cast<double>(column.size()) * column.squaredNorm());
}

int contact_clusters(const Eigen::VectorXd& column) {
  constexpr double cluster_level = 0.5;
  if (column.size() == 0 || column.maxCoeff() <= 0) return 0;
  const double level = cluster_level * column.maxCoeff();
  const Eigen::Index areas = column.size();
  const auto dark = [&](Eigen::Index area) { return column[(area + areas) % areas] >= level; };
  int starts = 0;  // a dark area after two light ones
  for (Eigen::Index area = 0; area < areas; ++area) starts += dark(area) && !dark(area - 1) && !dark(area - 2);
  return std::max(starts, 1);
}

ContactMap contact_map(const Response& response, const ContactLine& contact, int node) {
  const auto speeds = static_cast<Eigen::Index>(response.speeds.size());
  const Eigen::Index areas = speeds == 0 ? 0 : response.speeds.front().contact_count.cols();
  ContactMap map{Eigen::MatrixXd(areas, speeds), Eigen::VectorXd(speeds), Eigen::VectorXi(speeds)};
  for (Eigen::Index i = 0; i < speeds; ++i) {
    map.share.col(i) =
        contact_shares(response.speeds[static_cast<std::size_t>(i)], response.scene.sector_count, contact, node);
    map.contrast[i] = contact_contrast(map.share.col(i));
    map.clusters[i] = contact_clusters(map.share.col(i));
  }
  return map;
}

ContactDrift contact_drift(const ContactMap& map, const Eigen::VectorXd& speeds, int lobes,
                           const ContactLine& contact) {
  ContactDrift drift;
  drift.angle = followed_angles(map, lobes);
  std::vector<double> x, y;
  for (Eigen::Index i = 0; i < speeds.size(); ++i) {
    if (std::isnan(drift.angle[i])) continue;
    x.push_back(speeds[i]);
    y.push_back(drift.angle[i]);
  }
  if (x.size() < fewest) return drift;
  drift.line = fitted_line(x, y);
  const Eigen::VectorXd& arc = contact.arc_length;
  if (drift.line.slope != 0)
    drift.implied_wave_speed = (arc[contact.trailing_edge()] - arc[0]) / std::abs(drift.line.slope);
  return drift;
}

EdgeLag edge_lag(const Response& response, const ContactLine& contact) {
  const auto speeds = static_cast<Eigen::Index>(response.speeds.size());
  EdgeLag lag{.time = Eigen::VectorXd(speeds), .likeness = Eigen::VectorXd(speeds)};
  std::vector<double> times, x, y;
  for (Eigen::Index i = 0; i < speeds; ++i) {
    const SpeedResponse& speed = response.speeds[static_cast<std::size_t>(i)];
    std::tie(lag.time[i], lag.likeness[i]) = lag_at(speed, response.scene, contact);
    if (std::isnan(lag.time[i])) continue;
    times.push_back(lag.time[i]);
    x.push_back(speed.speed);
    y.push_back(speed.speed * lag.time[i]);
  }
  if (times.size() < fewest) return lag;
  std::ranges::sort(times);
  lag.median = quantile(times, 0.5);
  lag.lower_quartile = quantile(times, 0.25);
  lag.upper_quartile = quantile(times, 0.75);
  lag.line = fitted_line(x, y);
  return lag;
}

ContactMaps contact_maps(const Response& response, const ContactLine& contact) {
  const int lobes = std::max(response.scene.lobes, 1);
  Eigen::VectorXd speeds(static_cast<Eigen::Index>(response.speeds.size()));
  for (Eigen::Index i = 0; i < speeds.size(); ++i) speeds[i] = response.speeds[static_cast<std::size_t>(i)].speed;
  ContactMaps maps{contact_map(response, contact, 0),
                   contact_map(response, contact, contact.trailing_edge()),
                   {},
                   {},
                   edge_lag(response, contact)};
  maps.leading_drift = contact_drift(maps.leading, speeds, lobes, contact);
  maps.trailing_drift = contact_drift(maps.trailing, speeds, lobes, contact);
  return maps;
}

}  // namespace tiprub::postprocess
