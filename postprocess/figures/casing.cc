// SPDX-License-Identifier: GPL-3.0-or-later
// The casing, and where it is rubbed.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "postprocess/figures/study_figures.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

constexpr double degrees = 360.0;
constexpr double microseconds = 1e6;

Table contact_table(const Eigen::VectorXd& rpm, const ContactMap& map) {
  Table table{{"speed [rpm]", "contrast [1]", "clusters"}, {}};
  for (Eigen::Index area = 0; area < map.share.rows(); ++area)
    table.header.push_back(
        "share at " + fixed(degrees * (static_cast<double>(area) + 0.5) / static_cast<double>(map.share.rows()), 1) +
        " deg [1]");
  for (Eigen::Index i = 0; i < rpm.size(); ++i) {
    std::vector<Cell> row = {rpm[i], map.contrast[i], map.clusters[i]};
    for (Eigen::Index area = 0; area < map.share.rows(); ++area) row.emplace_back(map.share(area, i));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// The area at which the map is cut open: the one with the least contact, summed over the speeds, and of several the
/// one in the middle of the longest run, so that the picture tears no place of contact.
Eigen::Index cut_area(const ContactMap& map) {
  const Eigen::VectorXd contact = map.share.rowwise().sum();
  const Eigen::Index areas = contact.size();
  const double least = contact.minCoeff();
  Eigen::Index cut = 0, longest = 0, run = 0;
  for (Eigen::Index k = 0; k < 2 * areas && longest < areas; ++k) {  // a run may pass 0 degrees
    run = contact[k % areas] > least ? 0 : run + 1;
    if (run <= longest) continue;
    longest = run;
    cut = (k - run / 2 + areas) % areas;
  }
  return longest >= areas ? 0 : cut;
}

/// From the area `cut` upwards. Each area is several pixels high, so that a viewer that smooths the picture keeps the
/// areas' edges. Of more areas than can be told apart, a pixel shows the one with the most contact.
Eigen::MatrixXf contact_pixels(const SpeedFrame& frame, const ContactMap& map, Eigen::Index cut) {
  constexpr int columns = 700, pixels_per_area = 4;
  constexpr Eigen::Index most_rows = 4000;
  const Eigen::VectorXi nearest = nearest_speeds(frame.speeds, frame.failed, frame.axis, columns);
  const Eigen::Index areas = map.share.rows(), rows = std::min(pixels_per_area * areas, most_rows);
  Eigen::MatrixXf pixels = Eigen::MatrixXf::Constant(rows, columns, std::nanf(""));
  Eigen::MatrixXd share(areas, map.share.cols());
  share << map.share.bottomRows(areas - cut), map.share.topRows(cut);
  for (int x = 0; x < columns; ++x)
    if (nearest[x] >= 0)
      for (Eigen::Index y = 0; y < rows; ++y) {
        const Eigen::Index first = y * areas / rows, last = ((y + 1) * areas - 1) / rows;
        pixels(y, x) = static_cast<float>(
            share.col(nearest[x]).segment(first, std::max<Eigen::Index>(1, last - first + 1)).maxCoeff());
      }
  return pixels;
}

/// Whether a line describes the drift: it explains at least half of the variance.
bool is_line(const ContactDrift& drift) {
  return drift.line.determination >= 0.5;
}

std::string drift_sentence(const ContactDrift& drift) {
  if (std::isnan(drift.line.determination)) return "";
  if (!is_line(drift))
    return " The middle of the contact follows no line over speed (R\xC2\xB2 = " +
           fixed(drift.line.determination, 2) + "). Where the response resonates, it jumps.";
  return " Red: the line through the middle of the contact, folded onto one lobe: " +
         fixed(microseconds * drift.line.slope, 1) + " \xC2\xB5s (R\xC2\xB2 = " + fixed(drift.line.determination, 3) +
         "); a wave that takes so long along the tip would run at " + fixed(drift.implied_wave_speed, 0) +
         " m/s. Where the response resonates, the middle jumps.";
}

std::string lag_sentence(const EdgeLag& lag) {
  if (std::isnan(lag.median)) return "";
  const auto time = [](double seconds) { return fixed(microseconds * seconds, 1); };
  return " The leading edge's force comes " + time(lag.median) +
         " \xC2\xB5s after the trailing edge's, as the casing passes (median; half of the speeds between " +
         time(lag.lower_quartile) + " and " + time(lag.upper_quartile) + " \xC2\xB5s).";
}

/// The drift's line, one on each lobe, if there is a line.
void set_drift(Drawing& drawing, int casing_lobes, const ContactDrift& drift) {
  constexpr double degrees_per_radian = degrees / (2 * std::numbers::pi);
  const bool found = is_line(drift);
  drawing.values.insert(drawing.values.end(),
                        {{"drift_lobes", found ? std::max(casing_lobes, 1) : 0},
                         {"drift_start", found ? drift.line.intercept * degrees_per_radian : 0},
                         {"drift_slope", found ? drift.line.slope * degrees_per_radian / rpm_per_rad_s : 0}});
}

/// How far the casing is from a node of the rotor that spins and doesn't vibrate, around the casing [mm].
Eigen::VectorXd gap(const SpeedResponse& response, const SimulatedScene& scene, int node) {
  return ((response.clearance[node] - scene.distortion_over(node).array()) * mm_per_m).matrix();
}

}  // namespace

Figure contact_map_figure(const SpeedFrame& frame, TipEdge edge, const ContactMaps& maps,
                          const std::string& of_blade) {
  const bool leading = edge == TipEdge::leading;
  const ContactMap& map = leading ? maps.leading : maps.trailing;
  const ContactDrift drift = leading ? maps.leading_drift : ContactDrift{};  // as in the paper
  const int places = map.clusters.maxCoeff();
  Figure figure = listed_figure(
      "contact_map", {{"edge", name_of(edge)}, {"of_blade", of_blade}, {"areas", std::to_string(map.share.rows())}});
  figure.drawing.name += leading ? "_leading_edge" : "_trailing_edge";
  figure.drawing.values = {{"speed", frame.axis},
                           {"places", DrawnRange{0, std::max(1.0, 1.1 * places)}},
                           {"places_tics", std::max(1, (places + 3) / 4)}};
  figure.data = contact_table(frame.speeds, map);
  if (leading) figure.caption += drift_sentence(drift) + lag_sentence(maps.lag);
  set_drift(figure.drawing, frame.lobes, drift);
  const Eigen::Index cut = cut_area(map);
  figure.drawing.values.emplace_back("cut",
                                     degrees * static_cast<double>(cut) / static_cast<double>(map.share.rows()));
  set_pixels(figure, contact_pixels(frame, map, cut));
  return figure;
}

Figure casing_figure(const SimulatedScene& scene, const SpeedResponse& shown, const ContactLine& contact) {
  constexpr double smallest_distortion = 1e-12;  // [m] of a round casing
  const double largest = std::max(scene.casing_distortion.cwiseAbs().maxCoeff(), smallest_distortion);
  Figure figure = listed_figure("casing", {{"largest", fixed(largest * mm_per_m, 3)},
                                           {"of_blade", of_main_blade(contact)},
                                           {"speed", rpm_text(shown.speed)}});
  figure.drawing.values = {{"largest_distortion", largest * mm_per_m}};
  figure.data = {{"angle [deg]", "gap at leading edge [mm]", "gap at trailing edge [mm]", "distortion [mm]"}, {}};
  const Eigen::VectorXd leading = gap(shown, scene, 0), trailing = gap(shown, scene, contact.trailing_edge());
  for (Eigen::Index i = 0; i < scene.casing_angle.size(); ++i)
    figure.data.rows.push_back({scene.casing_angle[i] * 360.0 / (2 * std::numbers::pi), leading[i], trailing[i],
                                scene.casing_distortion[i] * mm_per_m});
  return figure;
}

}  // namespace tiprub::postprocess
