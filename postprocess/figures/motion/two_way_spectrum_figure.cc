// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "postprocess/figures/motion/sector_signals.h"
#include "postprocess/figures/study_figures.h"

namespace tiprub {

namespace {

/// What is drawn of a spectrum: lines 1 .. last, nodal diameters lowest .. lowest + N - 1, colours low .. high.
struct Drawn {
  int last, lowest;
  double low, high;
};

Drawn drawn_part(const Study& study, const TravellingSpectrum& spectrum) {
  constexpr double smallest = 1e-9;  // of a scale, where nothing moves
  const int last = std::min(spectrum.lines() - 1, study.parameters.engine_order_max * spectrum.revolutions);
  const double high = std::max(spectrum.amplitude.bottomRows(spectrum.lines() - 1).maxCoeff(), smallest);
  return {last, -((spectrum.sector_count - 1) / 2), high * std::pow(10.0, -study.parameters.amplitude_decades), high};
}

/// Where eq. 17 puts the casing's harmonics: engine order, signed nodal diameter.
Eigen::MatrixXd expected_waves(const Study& study) {
  const int lobes = std::max(study.response.scene.lobes, 1);
  const int count = std::max(1, study.parameters.engine_order_max / lobes);
  Eigen::MatrixXd rows(count, 2);
  for (int k = 1; k <= count; ++k)
    rows.row(k - 1) << k * lobes, signed_nodal_diameter(k * lobes, study.model.sector_count);
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

/// Fills the figure's table and its pixels.
void set_waves(Figure& figure, const TravellingSpectrum& spectrum, const Drawn& drawn, const std::string& unit) {
  const int sectors = spectrum.sector_count;
  figure.data = {{"engine order", "signed nodal diameter", "direction", "amplitude [" + unit + "]"}, {}};
  Eigen::MatrixXf waves(sectors, drawn.last);
  for (int line = 1; line <= drawn.last; ++line)
    for (int row = 0; row < sectors; ++row) {
      const int n = drawn.lowest + row;
      const double amplitude = spectrum.amplitude(line, (n + sectors) % sectors);
      waves(row, line - 1) = static_cast<float>(std::max(amplitude, drawn.low));
      figure.data.rows.push_back({spectrum.engine_order(line), n, name_of(wave_direction(n, sectors)), amplitude});
    }
  set_pixels(figure, enlarged(waves));
}

Figure two_way_spectrum_figure(const Study& study, const SectorSignal& signal, const std::string& name,
                               const std::string& title) {
  const TravellingSpectrum spectrum = travelling_spectrum(signal.values, study.shown_response().recorded_revolutions);
  const Drawn drawn = drawn_part(study, spectrum);
  Figure figure{.drawing = {.name = name,
                            .width = 1000,
                            .height = 520,
                            .script = "two_way_spectrum",
                            .values = {{"lines", drawn.last},
                                       {"revolutions", spectrum.revolutions},
                                       {"sectors", spectrum.sector_count},
                                       {"lowest_nodal_diameter", drawn.lowest},
                                       {"amplitude", DrawnRange{drawn.low, drawn.high}},
                                       {"unit", signal.unit}},
                            .tables = {{"expected", {expected_waves(study)}}}},
                .title = title,
                .caption = signal.what + ", at " + shown_speed_text(study) +
                           ": amplitude of each travelling wave. Positive nodal diameters run against the rotation "
                           "(backward), negative ones with it (forward), as seen from the rotor. Circles: where eq. "
                           "17 puts the casing's harmonics."};
  set_waves(figure, spectrum, drawn, signal.unit);
  return figure;
}

}  // namespace

Figure tip_spectrum_figure(const Study& study) {
  return two_way_spectrum_figure(study, motion_of_sectors(study), "tip_spectrum", "Two-way spectrum of the motion");
}

Figure force_spectrum_figure(const Study& study) {
  return two_way_spectrum_figure(study, force_of_sectors(study), "force_spectrum",
                                 "Two-way spectrum of the contact force");
}

}  // namespace tiprub
