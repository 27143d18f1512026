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
  const Eigen::MatrixXd& faces = figure.drawing.tables.at(0).sheets.at(0);
  ASSERT_EQ(faces.rows(), 12 * 9);
  for (Eigen::Index face = 0; face < faces.rows(); face += 9)
    for (const Eigen::Index corner : {0, 1, 3, 4}) {
      const Eigen::RowVectorXd row = faces.row(face + corner);
      const bool inner = row.head<3>().norm() < 3e3;  // [mm]
      EXPECT_DOUBLE_EQ(row[3], inner ? 25 : 75);
      EXPECT_DOUBLE_EQ(row[4], inner ? 100 : 0.01);  // the least that is drawn
      EXPECT_TRUE(std::isnan(faces(face + 6, 3)));   // nothing is drawn to the next face
    }
  ASSERT_EQ(figure.data.rows.size(), 2U);
  EXPECT_NE(figure.caption.find("75 %, lies at the radius 4"), std::string::npos) << figure.caption;
}

}  // namespace
}  // namespace tiprub::postprocess
