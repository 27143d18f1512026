// SPDX-License-Identifier: GPL-3.0-or-later
// Motion and force of all sectors at one speed.
#include <algorithm>
#include <cmath>
#include <functional>

#include "postprocess/figures/study_figures.h"
#include "postprocess/tables/table.h"
#include "postprocess/waves/aliasing.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub::postprocess {

namespace {

/// Engine order, then the amplitude of each signal.
Eigen::MatrixXd line_spectra(const Eigen::VectorXd& leading, const Eigen::VectorXd& trailing, int revolutions,
                             int engine_order_max) {
  const Eigen::VectorXd leading_lines = line_spectrum(leading), trailing_lines = line_spectrum(trailing);
  const int last = std::min(static_cast<int>(leading_lines.size()) - 1, engine_order_max * revolutions);
  Eigen::MatrixXd rows(last + 1, 3);
  for (int line = 0; line <= last; ++line)
    rows.row(line) << static_cast<double>(line) / revolutions, leading_lines[line], trailing_lines[line];
  return rows;
}

/// Engine order, nodal diameter, both directions of that wave [mm].
std::vector<Cell> bar_row(const TravellingSpectrum& spectrum, int engine_order, int nodal_diameter) {
  const double forward =
      is_standing(nodal_diameter, spectrum.sector_count) ? 0 : spectrum.at(engine_order, -nodal_diameter);
  return {engine_order, nodal_diameter, spectrum.at(engine_order, nodal_diameter) * mm_per_m, forward * mm_per_m};
}

/// One period of the motion is drawn, or all that is recorded if there is none.
int drawn_revolutions(const SpeedResponse& response) {
  const int period = response.period_revolutions;
  return std::clamp(period == 0 ? response.recorded_revolutions : period, 1, response.recorded_revolutions);
}

Table signal_table(const SectorSignal& signal, Eigen::Index samples, int samples_per_revolution) {
  Table table{{"rotor angle [deg]"}, {}};
  for (Eigen::Index j = 0; j < signal.values.cols(); ++j)
    table.header.push_back("sector " + std::to_string(j) + " [" + signal.unit + "]");
  for (Eigen::Index s = 0; s < samples; ++s) {
    table.rows.push_back({360.0 * static_cast<double>(s) / samples_per_revolution});
    for (Eigen::Index j = 0; j < signal.values.cols(); ++j) table.rows.back().emplace_back(signal.values(s, j));
  }
  return table;
}

std::vector<double> middles(const Eigen::MatrixXd& values) {
  const Eigen::RowVectorXd middle = 0.5 * (values.colwise().maxCoeff() + values.colwise().minCoeff());
  return {middle.begin(), middle.end()};
}

/// The part of a spectrum that is drawn: lines 1 .. last, nodal diameters lowest .. lowest + N - 1, colours low ..
/// high.
struct Drawn {
  int last, lowest;
  double low, high;
};

Drawn drawn_part(const TravellingSpectrum& spectrum, int engine_order_max, double decades) {
  constexpr double smallest = 1e-9;  // of a scale, where nothing moves
  const int last = std::min(spectrum.lines() - 1, engine_order_max * spectrum.revolutions);
  const double high = std::max(spectrum.amplitude.bottomRows(spectrum.lines() - 1).maxCoeff(), smallest);
  return {last, -((spectrum.sector_count - 1) / 2), high * std::pow(10.0, -decades), high};
}

/// Where eq. 17 puts the casing's harmonics: engine order, signed nodal diameter.
Eigen::MatrixXd expected_waves(int casing_lobes, int engine_order_max, int sectors) {
  const int lobes = std::max(casing_lobes, 1);
  const int count = std::max(1, engine_order_max / lobes);
  Eigen::MatrixXd rows(count, 2);
  for (int k = 1; k <= count; ++k) rows.row(k - 1) << k * lobes, signed_nodal_diameter(k * lobes, sectors);
  return rows;
}

/// Fills the figure's table, and draws the waves that reach the colours: engine order, signed nodal diameter,
/// amplitude, the largest first, of which some are named.
void set_waves(Figure& figure, const TravellingSpectrum& spectrum, const Drawn& drawn, const std::string& unit) {
  const int sectors = spectrum.sector_count;
  figure.data = {{"engine order", "signed nodal diameter", "direction", "amplitude [" + unit + "]"}, {}};
  struct Wave {
    double engine_order;
    int nodal_diameter;
    double amplitude;
  };
  std::vector<Wave> waves;
  for (int line = 1; line <= drawn.last; ++line)
    for (int row = 0; row < sectors; ++row) {
      const int n = drawn.lowest + row;
      const double amplitude = spectrum.amplitude(line, (n + sectors) % sectors);
      if (amplitude > drawn.low) waves.push_back({spectrum.engine_order(line), n, amplitude});
      figure.data.rows.push_back({spectrum.engine_order(line), n, name_of(wave_direction(n, sectors)), amplitude});
    }
  constexpr std::size_t named = 6;
  std::ranges::stable_sort(waves, std::greater(), &Wave::amplitude);
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(waves.size()), 3);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < waves.size(); ++i) {
    rows.row(static_cast<Eigen::Index>(i)) << waves[i].engine_order, waves[i].nodal_diameter, waves[i].amplitude;
    if (i < named) names.push_back(significant(waves[i].amplitude, 3) + " " + unit);
  }
  figure.drawing.tables.push_back({"waves", {rows}});
  figure.drawing.values.insert(figure.drawing.values.end(),
                               {{"names", static_cast<int>(names.size())}, {"name_of_wave", names}});
}

}  // namespace

Figure sectors_figure(const std::string& name, const SectorSignal& signal, const SpeedResponse& shown) {
  constexpr double clear_of_each_other = 1.15, smallest_spacing = 1e-9;
  const int revolutions = drawn_revolutions(shown);
  const int samples_per_revolution = shown.samples_per_revolution;
  const double spacing = std::max(2 * clear_of_each_other * vibration_amplitude(signal.values), smallest_spacing);
  const std::string bar = fixed(0.5 * spacing, 3) + " " + signal.unit;
  Figure figure = listed_figure(name, {{"what", signal.what}, {"speed", rpm_text(shown.speed)}, {"bar", bar}});
  figure.drawing.values = {{"revolutions", revolutions},
                           {"sectors", static_cast<int>(signal.values.cols())},
                           {"middle", middles(signal.values)},
                           {"spacing", spacing},
                           {"bar_label", bar}};
  figure.data =
      signal_table(signal, static_cast<Eigen::Index>(samples_per_revolution) * revolutions, samples_per_revolution);
  return figure;
}

Figure two_way_spectrum_figure(const std::string& name, const SectorSignal& signal, const SpeedResponse& shown,
                               const SpeedFrame& frame, double decades) {
  const TravellingSpectrum spectrum = travelling_spectrum(signal.values, shown.recorded_revolutions);
  const Drawn drawn = drawn_part(spectrum, frame.engine_order_max, decades);
  Figure figure = listed_figure(name, {{"what", signal.what}, {"speed", rpm_text(shown.speed)}});
  figure.drawing.values = {{"lines", drawn.last},
                           {"revolutions", spectrum.revolutions},
                           {"sectors", spectrum.sector_count},
                           {"lowest_nodal_diameter", drawn.lowest},
                           {"amplitude", DrawnRange{drawn.low, drawn.high}},
                           {"unit", signal.unit}};
  figure.drawing.tables = {
      {"expected", {expected_waves(frame.lobes, frame.engine_order_max, spectrum.sector_count)}}};
  set_waves(figure, spectrum, drawn, signal.unit);
  return figure;
}

Figure contact_force_figure(const SimulatedScene& scene, const SpeedResponse& shown, const ContactLine& contact,
                            int engine_order_max) {
  const int samples = shown.samples_per_revolution;
  const Eigen::VectorXd leading = tip_force(shown, scene, 0).col(0),
                        trailing = tip_force(shown, scene, contact.trailing_edge()).col(0);
  Figure figure =
      listed_figure("contact_force", {{"of_blade", of_main_blade(contact)}, {"speed", rpm_text(shown.speed)}});
  figure.drawing.values = {{"engine_order_max", engine_order_max}};
  figure.drawing.tables = {
      {"lines", {line_spectra(leading, trailing, shown.recorded_revolutions, engine_order_max)}}};
  figure.data = {{"rotor angle [deg]", "leading edge [N]", "trailing edge [N]"}, {}};
  for (int s = 0; s < samples; ++s) figure.data.rows.push_back({360.0 * s / samples, leading[s], trailing[s]});
  return figure;
}

Figure harmonic_bars_figure(const MapColumn& shown, int last) {
  const TravellingSpectrum& spectrum = shown.spectrum;
  const int half = spectrum.sector_count / 2;
  int order = 1, diameter = 0;  // of the largest wave
  for (int k = 1; k <= last && k * spectrum.revolutions < spectrum.lines(); ++k) {
    Eigen::Index n = 0;
    if (shown.parts.row(k * spectrum.revolutions).maxCoeff(&n) >
        shown.parts(order * spectrum.revolutions, diameter)) {
      order = k;
      diameter = static_cast<int>(n);
    }
  }
  Figure figure = listed_figure("harmonic_bars", {{"speed", rpm_text(shown.speed)},
                                                  {"engine_order", std::to_string(order)},
                                                  {"nodal_diameter", std::to_string(diameter)}});
  figure.drawing.values = {
      {"engine_order", order}, {"nodal_diameter", diameter}, {"nodal_diameters", half + 1}, {"engine_orders", last}};
  figure.data = {{"engine order", "nodal diameter", "backward or standing [mm]", "forward [mm]"}, {}};
  for (int n = 0; n <= half; ++n) figure.data.rows.push_back(bar_row(spectrum, order, n));
  for (int k = 1; k <= last; ++k) figure.data.rows.push_back(bar_row(spectrum, k, diameter));
  return figure;
}

}  // namespace tiprub::postprocess
