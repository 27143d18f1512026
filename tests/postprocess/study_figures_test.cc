// SPDX-License-Identifier: GPL-3.0-or-later
// What the pictures choose to show.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "postprocess/figures/study_figures.h"
#include "synthetic_scene.h"

namespace tiprub::postprocess::study_figures_test {
namespace {

struct Made {
  Study study;
  std::vector<Figure> figures;

  const Figure& figure(const std::string& name) const {
    return *std::find_if(figures.begin(), figures.end(),
                         [&](const Figure& figure) { return figure.drawing.name == name; });
  }
};

const Made& made() {
  static const Made all = [] {
    ReducedModel rotor = synthetic::model();
    Response response = synthetic::resonant_sweep(rotor);
    Study study = make_study({}, std::move(rotor), std::move(response), {});
    std::vector<Figure> figures = response_figures(study, field_results(std::nullopt, study.critical));
    for (Figure& figure : study_figures(study)) figures.push_back(std::move(figure));
    return Made{std::move(study), std::move(figures)};
  }();
  return all;
}

int number_after(const std::string& text, const std::string& word) {
  return std::stoi(text.substr(text.find(word) + word.size()));
}

/// Symptom: the bars showed EO 4, the casing's second harmonic, where EO 6 made the peak.
TEST(HarmonicBars, CrossAtTheLargestWave) {
  const TravellingSpectrum& spectrum =
      made().study.waves.first().columns[static_cast<std::size_t>(made().study.shown)].spectrum;
  double largest = 0;
  int order = 0, diameter = 0;
  for (int k = 1; k <= made().study.parameters.engine_order_max; ++k)
    for (int n = 0; n <= spectrum.sector_count / 2; ++n)
      if (const double both = spectrum.at(k, n) + (n % (spectrum.sector_count / 2) == 0 ? 0 : spectrum.at(k, -n));
          both > largest) {
        largest = both;
        order = k;
        diameter = n;
      }
  const std::string& caption = made().figure("harmonic_bars").caption;
  EXPECT_EQ(number_after(caption, "on engine order "), order) << caption;
  EXPECT_EQ(number_after(caption, "engine orders on nodal diameter "), diameter) << caption;
}

/// Symptom: of a casing with two lobes the odd engine orders were followed, which don't move, and one panel was
/// empty; EO 10 on nodal diameter 0, the second largest, was left out.
TEST(EngineOrderTracking, FollowsTheLargestWaveOfEachPeakAndHasNoEmptyPanel) {
  std::map<std::string, double> highest;
  double all = 0;
  for (const auto& row : made().figure("engine_order_tracking").data.rows) {
    double& here = highest[std::get<std::string>(row[0])];
    here = std::max(here, std::get<double>(row[3]));
    all = std::max(all, here);
  }
  double largest = 0;
  for (const MapColumn& column : made().study.waves.first().columns)
    for (int k = 1; k <= made().study.parameters.engine_order_max; ++k)
      largest = std::max(largest, column.parts.row(k * column.spectrum.revolutions).maxCoeff());
  EXPECT_NEAR(all, 1e3 * largest, 1e-12 * all);
  for (const auto& [panel, height] : highest) EXPECT_GT(height, 0.01 * all) << panel;
}

/// Symptom: a place of contact at 0 degrees stood half at the top and half at the foot of the map.
TEST(ContactMapFigure, IsCutWhereThereIsLeastContact) {
  const Eigen::VectorXd contact = made().study.contact.leading.share.rowwise().sum();
  const auto& values = made().figure("contact_map_leading_edge").drawing.values;
  const auto cut = std::find_if(values.begin(), values.end(), [](const auto& value) { return value.first == "cut"; });
  ASSERT_NE(cut, values.end());
  const auto area = static_cast<Eigen::Index>(
      std::lround(std::get<double>(cut->second) / 360 * static_cast<double>(contact.size())));
  EXPECT_EQ(contact[area], contact.minCoeff());
  EXPECT_EQ(contact[(area + contact.size() - 1) % contact.size()], contact.minCoeff());
}

/// Symptom: where speeds lie close together, near a peak, the spectra hid each other, and the picture took 0.8 MB.
TEST(Waterfall, ShowsTheLargestLineOfSpeedsThatAreApart) {
  const Figure& figure = made().figure("waterfall");
  double largest = 0;
  for (const Eigen::MatrixXd& sheet : figure.drawing.tables.back().sheets)
    largest = std::max(largest, sheet.col(1).maxCoeff());
  EXPECT_NEAR(largest, 1e3 * made().study.waves.first().largest(), 1e-12 * largest);
  EXPECT_LE(figure.drawing.tables.back().sheets.size(), 48U);
}

}  // namespace
}  // namespace tiprub::postprocess::study_figures_test
