// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <sstream>

#include "postprocess/figures/figure.h"
#include "postprocess/figures/figure_style.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

constexpr double degrees = 360.0;

std::string shown_text(const Study& study) {
  return fixed(study.shown_response().speed * rpm_per_rad_s, 0) + " rpm";
}

std::string component_label(const Study& study) {
  return std::string(name_of(study.parameters.component)) + ", " + name_of(study.parameters.edge);
}

Eigen::MatrixXd shown_motion(const Study& study) {
  return tip_motion(study.shown_response(), study.response.scene, study.model.contact, study.map_node,
                    study.parameters.component) *
         mm_per_m;
}

/// What all sectors do at the speed that is shown: one column a sector.
struct SectorSignal {
  std::string name;  ///< of the figure
  std::string title;
  std::string caption;  ///< begins with what is drawn
  std::string unit;
  Eigen::MatrixXd values;
};

std::string peak_name(const CriticalSpeed& critical) {
  return engine_order_name(critical.rising.engine_order) + ", ND " +
         style::signed_name(critical.rising.signed_nodal_diameter);
}

/// Speeds [rpm] of crossings on a fixed height of the drawing.
Eigen::MatrixXd forecast_rows(const std::vector<Crossing>& crossings, double height) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(crossings.size()), 2);
  for (std::size_t i = 0; i < crossings.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) << crossings[i].speed * rpm_per_rad_s, height;
  return rows;
}

/// Each value as a block of pixels, so that a viewer that smooths the picture keeps its edges.
Eigen::MatrixXf enlarged(const Eigen::MatrixXf& values) {
  constexpr int wide = 1000, high = 500;
  const Eigen::Index across = std::max<Eigen::Index>(1, wide / values.cols());
  const Eigen::Index up = std::max<Eigen::Index>(1, high / values.rows());
  Eigen::MatrixXf pixels(up * values.rows(), across * values.cols());
  for (Eigen::Index y = 0; y < pixels.rows(); ++y)
    for (Eigen::Index x = 0; x < pixels.cols(); ++x) pixels(y, x) = values(y / up, x / across);
  return pixels;
}

/// Where eq. 17 puts the casing's harmonics: engine order, signed nodal diameter.
std::string expected_waves(const Study& study) {
  const int lobes = std::max(study.response.scene.lobes, 1);
  const int count = std::max(1, study.parameters.engine_order_max / lobes);
  Eigen::MatrixXd rows(count, 2);
  for (int k = 1; k <= count; ++k)
    rows.row(k - 1) << k * lobes, signed_nodal_diameter(k * lobes, study.model.sector_count);
  return style::block("expected", rows);
}

}  // namespace

Figure response_figure(const Study& study) {
  constexpr double label_room = 1.45, forecast_height = 0.02;
  const Eigen::VectorXd rpm = style::speeds_rpm(study);
  const TipAmplitudes& amplitudes = study.amplitudes;
  Eigen::MatrixXd rows(rpm.size(), 5);
  for (Eigen::Index i = 0; i < rpm.size(); ++i) {
    const bool steady = study.response.speeds[static_cast<std::size_t>(i)].motion == MotionClass::periodic;
    rows.row(i) << rpm[i], amplitudes.largest[i] * mm_per_m, amplitudes.by_node(0, i) * mm_per_m,
        amplitudes.by_node(amplitudes.by_node.rows() - 1, i) * mm_per_m,
        steady ? std::nan("") : amplitudes.largest[i] * mm_per_m;
  }
  const double top = std::max(rows.col(1).maxCoeff(), 1e-9) * label_room;
  const style::SpeedAxis axis = style::speed_axis(study);
  Figure figure;
  figure.drawing = {"response", 1000, 520, ""};
  figure.title = "Response";
  figure.caption =
      std::string("Half of the peak-to-peak ") + name_of(study.parameters.component) +
      ", the largest over sectors. Each critical speed carries the engine order and signed nodal diameter "
      "(+ backward, \xE2\x88\x92 forward) of the wave that makes it. Triangles at the foot: speeds "
      "foretold by the linear rules. Rings: motion that is not the same every revolution.";
  figure.data = {{"speed [rpm]", "largest [mm]", "leading edge [mm]", "trailing edge [mm]", "node of the largest"},
                 {}};
  for (Eigen::Index i = 0; i < rpm.size(); ++i)
    figure.data.rows.push_back({rpm[i], rows(i, 1), rows(i, 2), rows(i, 3), amplitudes.node[i]});
  std::ostringstream out, plot;
  out << style::base() << style::block("curve", rows) << style::range("x", axis.low, axis.high)
      << style::range("y", 0, top)
      << "set lmargin at screen 0.085\nset rmargin at screen 0.975\nset tmargin at screen 0.86\n"
      << "set bmargin at screen 0.13\nset xlabel 'speed [rpm]'\nset ylabel 'amplitude [mm]'\n"
      << "set key at screen 0.53,0.985 center top horizontal maxrows 2\n";
  for (const CriticalSpeed& critical : study.critical)
    out << "set label " << gnuplot_quoted(peak_name(critical)) << " at first " << critical.speed * rpm_per_rad_s
        << ", first " << critical.amplitude * mm_per_m << " rotate by 90 left offset 0,0.7 font ',11'\n";
  plot
      << "plot $curve using 1:2 with linespoints pointtype 7 pointsize 0.6 linewidth 3 linecolor rgb '#9aa7b3' title "
         "'largest on the tip line', '' using 1:3 with lines linewidth 1.3 linecolor rgb '#0072b2' title 'leading "
         "edge', '' using 1:4 with lines linewidth 1.3 linecolor rgb '#d55e00' title 'trailing edge', '' using 1:5 "
         "with points pointtype 6 pointsize 1.3 linewidth 1.3 linecolor rgb "
         "'#c2185b' title 'not periodic'";
  const auto forecast = [&](const std::string& name, const std::vector<Crossing>& crossings, double height,
                            const std::string& look) {
    if (crossings.empty()) return;
    out << style::block(name, forecast_rows(crossings, height * top));
    plot << ", $" << name << " with points pointsize 1 " << look;
  };
  forecast("aliased", study.aliased, forecast_height,
           "pointtype 8 linecolor rgb '#555555' title 'rule with aliasing'");
  forecast("linear", study.equation_2, forecast_height, "pointtype 9 linecolor rgb '#009e73' title 'eq. 2'");
  if (!study.failed.empty()) {
    Eigen::MatrixXd failed(static_cast<Eigen::Index>(study.failed.size()), 2);
    for (std::size_t i = 0; i < study.failed.size(); ++i)
      failed.row(static_cast<Eigen::Index>(i)) << study.failed[i].speed * rpm_per_rad_s, 2 * forecast_height * top;
    out << style::block("failed", failed);
    plot << ", $failed with points pointtype 2 pointsize 1 linecolor rgb '#c2185b' title 'failed'";
  }
  figure.drawing.commands = out.str() + plot.str() + "\n";
  return figure;
}

namespace {

Figure sectors_figure(const Study& study, const SectorSignal& signal) {
  constexpr double clear_of_each_other = 1.15;
  const SpeedResponse& at = study.shown_response();
  const Eigen::MatrixXd& motion = signal.values;
  const int revolutions = std::clamp(at.period_revolutions == 0 ? at.recorded_revolutions : at.period_revolutions, 1,
                                     at.recorded_revolutions);
  const Eigen::Index samples = static_cast<Eigen::Index>(at.samples_per_revolution) * revolutions;
  const double spacing = std::max(2 * clear_of_each_other * vibration_amplitude(motion), 1e-9);
  Eigen::MatrixXd rows(samples, 1 + motion.cols());
  for (Eigen::Index s = 0; s < samples; ++s)
    rows(s, 0) = degrees * static_cast<double>(s) / at.samples_per_revolution;
  rows.rightCols(motion.cols()) = motion.topRows(samples);
  Figure figure;
  figure.drawing = {signal.name, 1000, 640, ""};
  figure.title = signal.title;
  figure.caption = signal.caption + ", at " + shown_text(study) + ", one sector above the other; the bar is " +
                   fixed(0.5 * spacing, 3) + " " + signal.unit +
                   " long. In a fully symmetric steady motion each sector repeats its neighbour's signal.";
  figure.data.header = {"rotor angle [deg]"};
  for (Eigen::Index j = 0; j < motion.cols(); ++j)
    figure.data.header.push_back("sector " + std::to_string(j) + " [" + signal.unit + "]");
  for (Eigen::Index s = 0; s < samples; ++s) {
    figure.data.rows.emplace_back();
    for (Eigen::Index k = 0; k < rows.cols(); ++k) figure.data.rows.back().emplace_back(rows(s, k));
  }
  const double right = degrees * revolutions;
  std::ostringstream out;
  out << style::base() << style::block("motion", rows) << style::range("x", 0, right)
      << style::range("y", -0.8, static_cast<double>(motion.cols()) - 0.2)
      << "set lmargin at screen 0.085\nset rmargin at screen 0.95\nset tmargin at screen 0.97\nset bmargin at screen "
         "0.1\n"
      << "set xtics " << 45 * revolutions << "\nset ytics 1\nset xlabel 'rotor angle [deg]'\nset ylabel 'sector'\n"
      << "set arrow 1 from " << right * 1.015 << ",0 to " << right * 1.015 << ",0.5 nohead linewidth 3\n"
      << "set label 1 '" << fixed(0.5 * spacing, 3) << " " << signal.unit << "' at " << right * 1.03
      << ",0.25 rotate by 90 center font ',10'\nset clip two\n";
  for (Eigen::Index j = 0; j < motion.cols(); ++j) {
    const double middle = 0.5 * (motion.col(j).maxCoeff() + motion.col(j).minCoeff());
    out << (j == 0 ? "plot " : ", ") << "$motion using 1:(" << j << "+($" << j + 2 << "-(" << middle << "))/"
        << spacing << ") with lines linewidth 1.3 linecolor rgb '" << (j % 2 == 0 ? "#0072b2" : "#08306b") << "'";
  }
  out << "\n";
  figure.drawing.commands = out.str();
  return figure;
}

Figure two_way_figure(const Study& study, const TravellingSpectrum& spectrum, const SectorSignal& signal) {
  const int sectors = spectrum.sector_count;
  const int last = std::min(spectrum.lines() - 1, study.parameters.engine_order_max * spectrum.revolutions);
  const double high = std::max(spectrum.amplitude.bottomRows(spectrum.lines() - 1).maxCoeff(), 1e-9);
  const double low = high * std::pow(10.0, -study.parameters.amplitude_decades);
  const int lowest = -((sectors - 1) / 2);  // of the signed nodal diameters
  Figure figure;
  figure.drawing = {signal.name, 1000, 520, ""};
  figure.title = signal.title;
  figure.caption =
      signal.caption + ", at " + shown_text(study) +
      ": amplitude of each travelling wave. Positive nodal diameters run against the rotation (backward), "
      "negative ones with it (forward), as seen from the rotor. Circles: where eq. 17 puts the casing's "
      "harmonics.";
  figure.data = {{"engine order", "signed nodal diameter", "direction", "amplitude [" + signal.unit + "]"}, {}};
  Eigen::MatrixXf waves(sectors, last);
  for (int line = 1; line <= last; ++line)
    for (int row = 0; row < sectors; ++row) {
      const int n = lowest + row;
      const double amplitude = spectrum.amplitude(line, (n + sectors) % sectors);
      waves(row, line - 1) = static_cast<float>(std::max(amplitude, low));
      figure.data.rows.push_back({spectrum.engine_order(line), n, name_of(wave_direction(n, sectors)), amplitude});
    }
  figure.pixels.push_back({signal.name + ".pixels", enlarged(waves)});
  const Eigen::MatrixXf& pixels = figure.pixels.back().values;
  const double width = 1.0 / spectrum.revolutions;  // of a line, in engine orders
  const double dx = width * last / static_cast<double>(pixels.cols());
  const double dy = static_cast<double>(sectors) / static_cast<double>(pixels.rows());
  std::ostringstream out;
  out.precision(12);
  out << style::base() << style::amplitude_palette() << "unset grid\n"
      << expected_waves(study) << style::range("x", 0.5 * width, (last + 0.5) * width)
      << style::range("y", lowest - 0.5, lowest + sectors - 0.5) << style::range("cb", low, high)
      << "set logscale cb\nset format cb '%g'\nset lmargin at screen 0.085\nset rmargin at screen 0.83\n"
      << "set tmargin at screen 0.96\nset bmargin at screen 0.13\nset xtics 1\nset ytics 1\nset xlabel 'engine "
         "order'\n"
      << "set ylabel 'signed nodal diameter'\nset cblabel 'amplitude [" << signal.unit << "]'\n"
      << "set colorbox user origin screen 0.87,0.13 size screen 0.022,0.83\nplot '" << signal.name
      << ".pixels' binary array=(" << pixels.cols() << "," << pixels.rows() << ") format='%float32' origin=("
      << 0.5 * (width + dx) << "," << lowest - 0.5 + dy / 2 << ") dx=" << dx << " dy=" << dy
      << " with image, $expected with points pointtype 6 pointsize 1.6 linewidth 1.2 linecolor rgb '#ff7f50'\n";
  figure.drawing.commands = out.str();
  return figure;
}

}  // namespace

Figure tip_motion_figure(const Study& study) {
  return sectors_figure(study, {.name = "tip_motion",
                                .title = "Motion of all sectors",
                                .caption = "The " + component_label(study),
                                .unit = "mm",
                                .values = shown_motion(study)});
}

Figure tip_spectrum_figure(const Study& study) {
  const SectorSignal signal{.name = "tip_spectrum",
                            .title = "Two-way spectrum of the motion",
                            .caption = "The " + component_label(study),
                            .unit = "mm",
                            .values = shown_motion(study)};
  return two_way_figure(study, travelling_spectrum(signal.values, study.shown_response().recorded_revolutions),
                        signal);
}

Figure force_of_sectors_figure(const Study& study) {
  return sectors_figure(study, {.name = "force_of_sectors",
                                .title = "Contact force on all sectors",
                                .caption = "The contact force at the " + std::string(name_of(study.parameters.edge)),
                                .unit = "N",
                                .values = tip_force(study.shown_response(), study.response.scene, study.map_node)});
}

Figure force_spectrum_figure(const Study& study) {
  const SectorSignal signal{.name = "force_spectrum",
                            .title = "Two-way spectrum of the contact force",
                            .caption = "The contact force at the " + std::string(name_of(study.parameters.edge)),
                            .unit = "N",
                            .values = tip_force(study.shown_response(), study.response.scene, study.map_node)};
  return two_way_figure(study, travelling_spectrum(signal.values, study.shown_response().recorded_revolutions),
                        signal);
}

}  // namespace tiprub
