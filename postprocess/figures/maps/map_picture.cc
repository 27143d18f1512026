// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/maps/map_picture.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "postprocess/figures/axes.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

constexpr double widest_half_line = 0.1;     // of an engine order: how thick a spectral line is drawn at most
constexpr double above_modes = 2;            // how far a map reaches above the highest drawn mode
constexpr double smallest_amplitude = 1e-6;  // [mm] of a map without motion
constexpr double seconds_per_minute = 60;    // EO k is the line f = k rpm / 60

struct Scale {
  double low, high;  // [mm]
};

Scale colour_scale(const Study& study) {
  const double given = study.parameters.amplitude_max_mm;
  const double high = given > 0 ? given : map_amplitude_high(study);
  return {high * std::pow(10.0, -study.parameters.amplitude_decades), high};
}

/// The line of a spectrum that is drawn at a frequency, or -1 between lines.
int line_at(const TravellingSpectrum& spectrum, double engine_order) {
  const double line = engine_order * spectrum.revolutions;
  const int nearest = static_cast<int>(std::lround(line));
  const double half_width = line_half_width(spectrum) * spectrum.revolutions;
  return nearest > 0 && nearest < spectrum.lines() && std::abs(line - nearest) <= half_width ? nearest : -1;
}

MapFrame frame_of(const Study& study) {
  return {speed_axis(study), map_frequency_high(study), colour_scale(study).low};
}

Eigen::VectorXd speeds_of(const InteractionMap& map) {
  Eigen::VectorXd rpm(static_cast<Eigen::Index>(map.columns.size()));
  for (Eigen::Index i = 0; i < rpm.size(); ++i)
    rpm[i] = map.columns[static_cast<std::size_t>(i)].speed * rpm_per_rad_s;
  return rpm;
}

/// `amplitude` [m] of a column's line on a grid [mm].
Eigen::MatrixXf gridded(const InteractionMap& map, const Eigen::VectorXd& failed, const MapFrame& frame, int columns,
                        int rows, const std::function<double(const MapColumn&, int line)>& amplitude) {
  const Eigen::VectorXi nearest = nearest_speeds(speeds_of(map), failed, frame.speed, columns);
  Eigen::MatrixXf pixels = Eigen::MatrixXf::Constant(rows, columns, static_cast<float>(frame.amplitude_low));
  for (int x = 0; x < columns; ++x) {
    if (nearest[x] < 0) {
      pixels.col(x).setConstant(std::nanf(""));
      continue;
    }
    const MapColumn& column = map.columns[static_cast<std::size_t>(nearest[x])];
    const double revolutions_per_second =
        (frame.speed.low + (frame.speed.high - frame.speed.low) * (x + 0.5) / columns) / seconds_per_minute;
    for (int y = 0; y < rows; ++y) {
      const double frequency = frame.frequency_high * (y + 0.5) / rows;
      const int line = line_at(column.spectrum, frequency / revolutions_per_second);
      if (line >= 0)
        pixels(y, x) = static_cast<float>(std::max(amplitude(column, line) * mm_per_m, frame.amplitude_low));
    }
  }
  return pixels;
}

}  // namespace

double map_frequency_high(const Study& study) {
  double modes = 0;
  for (int n = 0; n <= study.model.nodal_diameter_max(); ++n)
    modes = std::max(modes, study.curves.frequency(n, drawn_families(study, n) - 1, study.range.high));
  const double engine_order = study.parameters.engine_order_max * speed_axis(study).high / seconds_per_minute;
  return modes > 0 ? std::min(engine_order, above_modes * modes) : engine_order;
}

double map_amplitude_high(const Study& study) {
  return std::max({study.map.largest() * mm_per_m, study.other_map.largest() * mm_per_m, smallest_amplitude});
}

double line_half_width(const TravellingSpectrum& spectrum) {
  return std::min(0.5 / spectrum.revolutions, widest_half_line);
}

void set_map_axes(Drawing& drawing, const Study& study) {
  const Scale scale = colour_scale(study);
  set_speed_axis(drawing, speed_axis(study));
  set_engine_orders(drawing, study);
  set_critical_speeds(drawing, study, map_frequency_high(study));
  set_modes(drawing, study, speed_axis(study));
  drawing.values.insert(drawing.values.end(), {{"frequency", DrawnRange{0, map_frequency_high(study)}},
                                               {"amplitude", DrawnRange{scale.low, scale.high}}});
}

Eigen::MatrixXf map_pixels(const InteractionMap& map, const Eigen::VectorXd& failed, const MapFrame& frame,
                           int columns, int rows) {
  return gridded(map, failed, frame, columns, rows,
                 [](const MapColumn& column, int line) { return column.total[line]; });
}

Eigen::MatrixXf map_pixels(const Study& study, const InteractionMap& map, int columns, int rows) {
  return map_pixels(map, rpm_of(study.failed), frame_of(study), columns, rows);
}

Eigen::MatrixXf part_pixels(const Study& study, int nodal_diameter, int columns, int rows) {
  return gridded(study.map, rpm_of(study.failed), frame_of(study), columns, rows,
                 [&](const MapColumn& column, int line) { return column.parts(line, nodal_diameter); });
}

}  // namespace tiprub
