// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/study_figures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/cells/cell_kind.h"

namespace tiprub::postprocess {
namespace {

/// Bricks around the axis: r from `inner` to `inner` + 1, z from 0 to 1 [m], leaning in theta as blades do.
SectorFields ring_of(const std::vector<double>& inner, double lean) {
  SectorFields sector;
  sector.cells.resize(20, static_cast<Eigen::Index>(inner.size()));
  sector.nodes.resize(3, 20 * static_cast<Eigen::Index>(inner.size()));
  for (const char* name : {"clamped", "contact", "cyclic_low", "cyclic_high"}) sector.node_sets[name];
  for (std::size_t brick = 0; brick < inner.size(); ++brick)
    for (int k = 0; k < 20; ++k) {
      const Eigen::Vector3d place = 0.5 * (cell_kind(20).places[static_cast<std::size_t>(k)].array() + 1);
      const int node = 20 * static_cast<int>(brick) + k;
      const double r = inner[brick] + place[0], theta = 0.2 * place[1] + lean * place[0] * place[2];
      sector.nodes.col(node) << r * std::cos(theta), r * std::sin(theta), place[2];
      sector.cells(k, static_cast<Eigen::Index>(brick)) = node;
    }
  return sector;
}

double area(const Eigen::Matrix2Xd& line) {
  double twice = 0;
  for (Eigen::Index i = 0; i < line.cols(); ++i) {
    const Eigen::Index next = (i + 1) % line.cols();
    twice += line(0, i) * line(1, next) - line(0, next) * line(1, i);
  }
  return std::abs(twice) / 2;
}

std::vector<Eigen::Matrix2Xd> outline(const SectorFields& sector) {
  return meridional_outline(sector.nodes, sector_surface(sector));
}

TEST(MeridionalOutline, IsTheRectangleOfARing) {
  for (const double lean : {0.0, 0.7, 3.0}) {
    const std::vector<Eigen::Matrix2Xd> lines = outline(ring_of({1}, lean));
    ASSERT_EQ(lines.size(), 1U) << lean;
    EXPECT_NEAR(area(lines[0]), 1, 1e-6) << lean;
    EXPECT_NEAR(lines[0].row(0).minCoeff(), 1, 1e-6);
    EXPECT_NEAR(lines[0].row(0).maxCoeff(), 2, 1e-6);
  }
}

TEST(MeridionalOutline, JoinsWhatOverlapsAndPartsWhatDoesNot) {
  const std::vector<Eigen::Matrix2Xd> joined = outline(ring_of({1, 1.5, 2.5}, 0.3));
  ASSERT_EQ(joined.size(), 1U);
  EXPECT_NEAR(area(joined[0]), 2.5, 1e-6);
  EXPECT_EQ(outline(ring_of({1, 4}, 0.3)).size(), 2U);
}

TEST(MeshErrorFigure, ColoursTheSurfaceByTheSharesOfTheCells) {
  FieldStudy fields;
  fields.sector = ring_of({1, 4}, 0.3);  // two bricks apart
  fields.sector.node_sets["contact"] = {20};
  fields.mesh_error_of_frequencies = Eigen::Vector2d(1e-3, 3e-3);
  fields.mesh_error_of_compliances = Eigen::Vector2d(0.2, 0.0);
  const Figure figure = mesh_error_figure(fields);
  ASSERT_EQ(figure.pixels.size(), 1U);
  const Eigen::MatrixXf& pixels = figure.pixels[0].values;
  const Eigen::Index half = pixels.rows() / 2;
  const auto expect_values = [&](const Eigen::MatrixXf& panel, float one, float other) {
    Eigen::Index ones = 0, others = 0;
    for (const float value : panel.reshaped()) {
      ones += value == one;
      others += value == other;
      EXPECT_TRUE(std::isnan(value) || value == one || value == other) << value;
    }
    EXPECT_GT(ones, panel.size() / 100);
    EXPECT_GT(others, panel.size() / 100);
  };
  for (const Eigen::Index column : {Eigen::Index(0), half}) {
    expect_values(pixels.block(half, column, half, half), 25.0F, 75.0F);
    expect_values(pixels.block(0, column, half, half), 100.0F, 0.01F);  // the least that is drawn
  }
  ASSERT_EQ(figure.data.rows.size(), 2U);
  EXPECT_NE(figure.caption.find("75 %, lies at the radius 4"), std::string::npos) << figure.caption;
}

}  // namespace
}  // namespace tiprub::postprocess
