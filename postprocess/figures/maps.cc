// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/maps.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

constexpr double widest_half_line = 0.1;   // of an engine order: how thick a spectral line is drawn at most
constexpr double above_modes = 2;          // how far a map reaches above the highest drawn mode
constexpr double smallest_map = 1e-6;      // [mm] of a map without motion
constexpr double seconds_per_minute = 60;  // EO k is the line f = k rpm / 60

/// Half of the width of a spectral line as it is drawn, in engine orders.
double line_half_width(const TravellingSpectrum& spectrum) {
  return std::min(0.5 / spectrum.revolutions, widest_half_line);
}

/// The line of a spectrum that is drawn at an engine order, or -1 between lines.
int line_at(const TravellingSpectrum& spectrum, double engine_order) {
  const double line = engine_order * spectrum.revolutions;
  const int nearest = static_cast<int>(std::lround(line));
  const double half_width = line_half_width(spectrum) * spectrum.revolutions;
  return nearest > 0 && nearest < spectrum.lines() && std::abs(line - nearest) <= half_width ? nearest : -1;
}

Eigen::VectorXd speeds_of(const InteractionMap& map) {
  Eigen::VectorXd rpm(static_cast<Eigen::Index>(map.columns.size()));
  for (Eigen::Index i = 0; i < rpm.size(); ++i)
    rpm[i] = map.columns[static_cast<std::size_t>(i)].speed * rpm_per_rad_s;
  return rpm;
}

/// `amplitude` [m] of a column's line, drawn on a grid [mm].
Eigen::MatrixXf gridded(const InteractionMap& map, const Eigen::VectorXd& failed, const MapFrame& frame, int columns,
                        int rows, const std::function<double(const MapColumn&, int line)>& amplitude) {
  const Eigen::VectorXi nearest = nearest_speeds(speeds_of(map), failed, frame.speed, columns);
  Eigen::MatrixXf pixels = Eigen::MatrixXf::Constant(rows, columns, static_cast<float>(frame.amplitude.low));
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
        pixels(y, x) = static_cast<float>(std::max(amplitude(column, line) * mm_per_m, frame.amplitude.low));
    }
  }
  return pixels;
}

Table map_table(const SpeedFrame& frame, const InteractionMap& map) {
  Table table{{"speed [rpm]", "frequency [Hz]", "engine order", "total [mm]"}, {}};
  for (int n = 0; n < frame.nodal_diameters(); ++n)
    table.header.push_back("nodal diameter " + std::to_string(n) + " [mm]");
  for (const MapColumn& column : map.columns)
    for (int line = 0; line < column.spectrum.lines(); ++line) {
      const double order = column.spectrum.engine_order(line);
      if (order > frame.engine_order_max) break;
      std::vector<Cell> row = {column.speed * rpm_per_rad_s, order * column.speed * hz_per_rad_s, order,
                               column.total[line] * mm_per_m};
      for (Eigen::Index n = 0; n < column.parts.cols(); ++n) row.emplace_back(column.parts(line, n) * mm_per_m);
      table.rows.push_back(std::move(row));
    }
  return table;
}

/// "node 9, the trailing edge", "node 4 of 0 .. 9".
std::string node_name(const ContactLine& contact, int node) {
  const std::string place = contact.place_of(node);
  return name_of(contact.kind) + (" " + std::to_string(node)) +
         (place.empty() ? " of 0 .. " + std::to_string(contact.size() - 1) : ", the " + place);
}

/// Where families of nodal diameter 0 enter the map [Hz].
ScriptTable family_labels(const SpeedFrame& frame) {
  const double speed = frame.axis.low / rpm_per_rad_s;
  std::vector<double> frequencies;
  for (int family = 0; family < frame.families_at(0); ++family)
    if (const double frequency = frame.curves.frequency(0, family, speed); frequency < map_frequency_high(frame))
      frequencies.push_back(frequency);
  return {"family_labels", {as_column(frequencies)}};
}

/// Speeds [rpm] for which a property holds.
ScriptTable speeds_where(const std::vector<SpeedResponse>& speeds, const char* name,
                         const std::function<bool(const SpeedResponse&)>& holds) {
  std::vector<double> found;
  for (const SpeedResponse& response : speeds)
    if (holds(response)) found.push_back(response.speed * rpm_per_rad_s);
  return {name, {as_column(found)}};
}

std::vector<ScriptTable> unusual_motion(const std::vector<SpeedResponse>& speeds) {
  return {speeds_where(speeds, "irregular", [](const SpeedResponse& response) { return !repeats(response.motion); }),
          speeds_where(speeds, "subharmonic",
                       [](const SpeedResponse& response) { return response.motion == MotionClass::subharmonic; }),
          speeds_where(speeds, "breaking", [](const SpeedResponse& response) {
            return response.audit.symmetry == SymmetryVerdict::breaking;
          })};
}

/// The lowest of the nodal diameters that can move, as many as there is room for.
std::vector<int> panel_nodal_diameters(std::vector<int> moving) {
  constexpr std::size_t most = 12;
  std::ranges::sort(moving);
  if (moving.size() > most) moving.resize(most);
  return moving;
}

Table ridge_table(const std::vector<Ridge>& ridges) {
  Table table{{"speed [rpm]", "engine order", "signed nodal diameter", "direction", "amplitude [mm]", "family",
               "natural frequency [Hz]", "detuning [%]"},
              {}};
  for (const Ridge& ridge : ridges)
    table.rows.push_back({ridge.speed * rpm_per_rad_s, ridge.wave.engine_order, ridge.wave.signed_nodal_diameter,
                          name_of(ridge.wave.direction), ridge.wave.amplitude * mm_per_m, ridge.wave.family + 1,
                          ridge.wave.natural_frequency, 100 * ridge.wave.detuning});
  return table;
}

int drawn_lines(const SpeedFrame& frame, const MapColumn& column) {
  return std::min(column.spectrum.lines() - 1, frame.engine_order_max * column.spectrum.revolutions);
}

/// Frequency [Hz], amplitude [mm]: each line of the spectrum that can be seen, as a narrow triangle.
Eigen::MatrixXd outline(const SpeedFrame& frame, const MapColumn& column, double largest) {
  constexpr double seen = 2e-3;  // of the largest amplitude; a fifth of a pixel
  const double hz_per_order = column.speed * hz_per_rad_s;
  const double half_width = line_half_width(column.spectrum) * hz_per_order;
  std::vector<double> frequencies = {0}, amplitudes = {0};
  for (int line = 1; line <= drawn_lines(frame, column); ++line) {
    if (column.total[line] < seen * largest) continue;
    const double frequency = column.spectrum.engine_order(line) * hz_per_order;
    frequencies.insert(frequencies.end(), {frequency - half_width, frequency, frequency + half_width});
    amplitudes.insert(amplitudes.end(), {0, column.total[line] * mm_per_m, 0});
  }
  frequencies.push_back(map_frequency_high(frame));
  amplitudes.push_back(0);
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(frequencies.size()), 2);
  rows << as_column(frequencies), as_column(amplitudes);
  return rows;
}

/// The columns that the waterfall shows, the lowest speed first: of all in one of `slots` equal ranges of speed, the
/// one with the largest line. Where speeds lie close together, spectra would only hide each other.
std::vector<const MapColumn*> apart(const SpeedFrame& frame, const InteractionMap& map, int slots) {
  std::vector<const MapColumn*> chosen(static_cast<std::size_t>(slots), nullptr);
  for (const MapColumn& column : map.columns) {
    const double place = (column.speed * rpm_per_rad_s - frame.axis.low) / (frame.axis.high - frame.axis.low);
    const long slot = std::lround(std::clamp(place, 0.0, 1.0) * (slots - 1));
    const MapColumn*& best = chosen[static_cast<std::size_t>(slot)];
    if (best == nullptr || column.total.maxCoeff() > best->total.maxCoeff()) best = &column;
  }
  std::erase(chosen, nullptr);
  return chosen;
}

}  // namespace

double map_frequency_high(const SpeedFrame& frame) {
  double modes = 0;
  for (int n = 0; n < frame.nodal_diameters(); ++n)
    modes = std::max(modes, frame.curves.frequency(n, frame.families_at(n) - 1, frame.range.high));
  const double engine_order = frame.engine_order_max * frame.axis.high / seconds_per_minute;
  return modes > 0 ? std::min(engine_order, above_modes * modes) : engine_order;
}

double map_amplitude_high(const WaveMaps& waves) {
  return std::max({waves.leading.largest() * mm_per_m, waves.trailing.largest() * mm_per_m, smallest_map});
}

MapFrame map_frame(const SpeedFrame& frame, const WaveMaps& waves, const PostprocessParameters& parameters) {
  const double given = parameters.amplitude_max_mm, high = given > 0 ? given : map_amplitude_high(waves);
  return {frame.axis, map_frequency_high(frame), {high * std::pow(10.0, -parameters.amplitude_decades), high}};
}

void set_map_axes(Drawing& drawing, const SpeedFrame& frame, const MapFrame& map) {
  set_engine_orders(drawing, frame);
  set_critical_speeds(drawing, frame, map.frequency_high);
  set_modes(drawing, frame, frame.axis);
  drawing.values.insert(
      drawing.values.end(),
      {{"speed", map.speed}, {"frequency", DrawnRange{0, map.frequency_high}}, {"amplitude", map.amplitude}});
}

Eigen::MatrixXf map_pixels(const InteractionMap& map, const Eigen::VectorXd& failed, const MapFrame& frame,
                           int columns, int rows) {
  return gridded(map, failed, frame, columns, rows,
                 [](const MapColumn& column, int line) { return column.total[line]; });
}

std::string largest_place(const TipAmplitudes& amplitudes, const ContactLine& contact) {
  return "The largest amplitude of all speeds is at " + node_name(contact, amplitudes.node[amplitudes.worst()]) + ".";
}

Figure interaction_map_figure(const SpeedFrame& frame, const MapFrame& axes, const EdgeMap& edge,
                              const std::vector<SpeedResponse>& speeds) {
  constexpr int columns = 700, rows = 480;
  Figure figure = listed_figure("interaction_map", {{"edge", name_of(edge.edge)},
                                                    {"of_blade", edge.of_blade},
                                                    {"component", edge.component},
                                                    {"remark", edge.remark}});
  figure.drawing.name += edge.edge == TipEdge::leading ? "_leading_edge" : "_trailing_edge";
  figure.data = map_table(frame, edge.map);
  set_map_axes(figure.drawing, frame, axes);
  figure.drawing.tables.push_back(family_labels(frame));
  figure.drawing.tables.push_back({"outside", {frame.outside}});
  for (ScriptTable& marks : unusual_motion(speeds)) figure.drawing.tables.push_back(std::move(marks));
  set_pixels(figure, map_pixels(edge.map, frame.failed, axes, columns, rows));
  return figure;
}

Figure interaction_map_parts_figure(const SpeedFrame& frame, const MapFrame& axes, const WaveMaps& waves,
                                    const std::vector<int>& moving) {
  constexpr int width = 330, height = 260, columns = 3;
  const std::vector<int> panels = panel_nodal_diameters(moving);
  const int count = static_cast<int>(panels.size()), rows = (count + columns - 1) / columns;
  Figure figure = listed_figure("interaction_map_parts", {{"edge", name_of(waves.asked)}});
  figure.drawing.height = 100 + 330 * rows;
  figure.data = ridge_table(waves.ridges);
  set_map_axes(figure.drawing, frame, axes);
  std::vector<std::string> titles;
  for (const int n : panels) {
    titles.push_back("nodal diameter " + std::to_string(n));
    figure.pixels.push_back({figure.drawing.name + "_" + std::to_string(n) + ".pixels",
                             gridded(waves.first(), frame.failed, axes, width, height,
                                     [&](const MapColumn& column, int line) { return column.parts(line, n); })});
  }
  figure.drawing.values.insert(figure.drawing.values.end(),
                               {{"pixel_columns", width},
                                {"pixel_rows", height},
                                {"panel_columns", columns},
                                {"panel_rows", rows},
                                {"panels", count},
                                {"panel_nodal_diameter", std::vector<double>(panels.begin(), panels.end())},
                                {"panel_title", titles}});
  return figure;
}

Figure waterfall_figure(const SpeedFrame& frame, const InteractionMap& map) {
  constexpr int slots = 48;
  const std::vector<const MapColumn*> drawn = apart(frame, map, slots);
  Figure figure = listed_figure("waterfall", {{"largest", fixed(map.largest() * mm_per_m, 3)},
                                              {"drawn", std::to_string(drawn.size())},
                                              {"speeds", std::to_string(map.columns.size())}});
  figure.data = {{"speed [rpm]", "frequency [Hz]", "total [mm]"}, {}};
  std::vector<double> speeds;
  ScriptTable spectra{"spectra", {}};
  for (auto column = map.columns.rbegin(); column != map.columns.rend(); ++column)
    for (int line = 1; line <= drawn_lines(frame, *column); ++line)
      figure.data.rows.push_back({column->speed * rpm_per_rad_s,
                                  column->spectrum.engine_order(line) * column->speed * hz_per_rad_s,
                                  column->total[line] * mm_per_m});
  for (auto column = drawn.rbegin(); column != drawn.rend(); ++column) {
    speeds.push_back((*column)->speed * rpm_per_rad_s);
    spectra.sheets.push_back(outline(frame, **column, map.largest()));
  }
  set_engine_orders(figure.drawing, frame);
  figure.drawing.values.insert(figure.drawing.values.end(),
                               {{"speed", frame.axis},
                                {"frequency", DrawnRange{0, map_frequency_high(frame)}},
                                {"amplitude", DrawnRange{0, std::max(map.largest() * mm_per_m, smallest_map)}},
                                {"speeds", static_cast<int>(speeds.size())},
                                {"speed", speeds}});
  figure.drawing.tables.push_back(std::move(spectra));
  return figure;
}

}  // namespace tiprub::postprocess
