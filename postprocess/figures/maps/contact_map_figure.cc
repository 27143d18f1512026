// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "postprocess/figures/axes.h"
#include "postprocess/figures/study_figures.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

constexpr double degrees = 360.0;
constexpr double microseconds = 1e6;

Table contact_table(const Study& study, const ContactMap& map) {
  Table table{{"speed [rpm]", "contrast [1]", "clusters"}, {}};
  for (Eigen::Index area = 0; area < map.share.rows(); ++area)
    table.header.push_back(
        "share at " + fixed(degrees * (static_cast<double>(area) + 0.5) / static_cast<double>(map.share.rows()), 1) +
        " deg [1]");
  const Eigen::VectorXd rpm = speeds_rpm(study);
  for (Eigen::Index i = 0; i < rpm.size(); ++i) {
    std::vector<Cell> row = {rpm[i], map.contrast[i], map.clusters[i]};
    for (Eigen::Index area = 0; area < map.share.rows(); ++area) row.emplace_back(map.share(area, i));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Each area is several pixels high, so that a viewer that smooths the picture keeps the areas' edges. Of more areas
/// than can be told apart, a pixel shows the one with the most contact.
Eigen::MatrixXf contact_pixels(const Study& study, const ContactMap& map) {
  constexpr int columns = 700, pixels_per_area = 4;
  constexpr Eigen::Index most_rows = 4000;
  const Eigen::VectorXi nearest = nearest_speeds(study, columns);
  const Eigen::Index areas = map.share.rows(), rows = std::min(pixels_per_area * areas, most_rows);
  Eigen::MatrixXf pixels = Eigen::MatrixXf::Constant(rows, columns, std::nanf(""));
  for (int x = 0; x < columns; ++x)
    if (nearest[x] >= 0)
      for (Eigen::Index y = 0; y < rows; ++y) {
        const Eigen::Index first = y * areas / rows, last = ((y + 1) * areas - 1) / rows;
        pixels(y, x) = static_cast<float>(
            map.share.col(nearest[x]).segment(first, std::max<Eigen::Index>(1, last - first + 1)).maxCoeff());
      }
  return pixels;
}

std::string drift_sentence(const ContactDrift& drift) {
  return " Red: the line through the middle of the contact, folded onto one lobe: " +
         fixed(microseconds * drift.slope, 1) + " \xC2\xB5s (R\xC2\xB2 = " + fixed(drift.determination, 3) +
         "); a wave that takes so long along the tip would run at " + fixed(drift.implied_wave_speed, 0) + " m/s.";
}

std::string lag_sentence(const EdgeLag& lag) {
  const auto time = [](double seconds) { return fixed(microseconds * seconds, 1); };
  return " Where the response resonates the middle jumps. The leading edge's force comes " + time(lag.median) +
         " \xC2\xB5s after the trailing edge's, as the casing passes (median; half of the speeds between " +
         time(lag.lower_quartile) + " and " + time(lag.upper_quartile) + " \xC2\xB5s).";
}

/// The drift's line, one on each lobe, if there is a line.
void set_drift(Drawing& drawing, const Study& study, const ContactDrift& drift) {
  constexpr double degrees_per_radian = degrees / (2 * std::numbers::pi);
  const int lobes = drift.determination > 0 ? std::max(study.response.scene.lobes, 1) : 0;
  drawing.values.insert(drawing.values.end(), {{"drift_lobes", lobes},
                                               {"drift_start", drift.intercept * degrees_per_radian},
                                               {"drift_slope", drift.slope * degrees_per_radian / rpm_per_rad_s}});
}

}  // namespace

Figure contact_map_figure(const Study& study, TipEdge edge) {
  const ContactMap& map = edge == TipEdge::leading ? study.leading_edge : study.trailing_edge;
  const ContactDrift drift = edge == TipEdge::leading ? study.leading_drift : ContactDrift{};  // as in the paper
  const std::string where = edge == TipEdge::leading ? "leading" : "trailing";
  const int places = map.clusters.maxCoeff();
  Figure figure{.drawing = {.name = "contact_map_" + where + "_edge",
                            .width = 1000,
                            .height = 560,
                            .script = "contact_map",
                            .values = {{"places", DrawnRange{0, std::max(1.0, 1.1 * places)}},
                                       {"places_tics", std::max(1, (places + 3) / 4)}}},
                .title = "Contact map, " + where + " edge" + of_main_blade(study),
                .caption = "Where the " + where + " edge" + of_main_blade(study) +
                           " of sector 0 rubs: the casing in " + std::to_string(map.share.rows()) +
                           " areas, each coloured by the share of the steps over it that are in contact, from white "
                           "(never) to dark blue (always). Below: contrast, near 1 where the contact keeps to few "
                           "places, and the number of separate places. Grey: speeds without a response.",
                .data = contact_table(study, map)};
  if (drift.determination > 0) figure.caption += drift_sentence(drift) + lag_sentence(study.edge_lag);
  set_speed_axis(figure.drawing, speed_axis(study));
  set_drift(figure.drawing, study, drift);
  set_pixels(figure, contact_pixels(study, map));
  return figure;
}

}  // namespace tiprub
