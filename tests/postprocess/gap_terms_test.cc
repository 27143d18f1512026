// SPDX-License-Identifier: GPL-3.0-or-later
// The terms of second order that a linear gap leaves out, against rigid motions and closed forms.
#include "postprocess/analysis/gap_terms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "postprocess/analysis/study.h"
#include "synthetic_scene.h"

namespace tiprub::postprocess {
namespace {

/// Along the tangent the made tips move by 0.8 of what they move along their normals, which have no tangential part.
TEST(GapTerms, IsThatOfACircleAndOfABentBeam) {
  const ReducedModel rotor = synthetic::model();
  const SimulatedScene scene = synthetic::two_lobes();
  constexpr double amplitude = 1e-3;
  const synthetic::Wave wave{2, 2, amplitude, 0};
  const SpeedResponse response = synthetic::speed(scene, rotor.contact, 1000, {wave}, 1);
  const Eigen::VectorXd span = Eigen::Vector4d(0.04, 0.03, 0.02, 0.004);
  double curvature = 0, distortion = 0, foreshortening = 0;
  for (int k = 0; k < rotor.contact.size(); ++k) {
    const double tangential = 0.8 * amplitude * wave.shape[k], radius = rotor.contact.position(k, 0);
    curvature = std::max(curvature, std::cos(k * std::numbers::pi / 6) * tangential * tangential / (2 * radius));
    distortion = std::max(distortion, 2 * 3e-4 * tangential / radius);
    foreshortening = std::max(foreshortening, 6.0 / 5 * tangential * tangential / (2 * span[k]));
  }
  const GapTerms gap = gap_terms(response, scene, rotor.contact, span);
  EXPECT_NEAR(gap.curvature, curvature, 1e-9 * curvature);
  EXPECT_NEAR(gap.distortion, distortion, 1e-4 * distortion);  // the slope is that of a table
  ASSERT_TRUE(gap.foreshortening);
  EXPECT_NEAR(*gap.foreshortening, foreshortening, 1e-9 * foreshortening);
  EXPECT_FALSE(gap_terms(response, scene, rotor.contact).foreshortening);
}

/// The pieces of a bent beam, clamped at one end and pushed at the other: the formula is the length that they lose.
TEST(GapTerms, BeamShortensBySixFifths) {
  constexpr double length = 0.03, w = 1e-3;
  constexpr int pieces = 100000;
  double lost = 0, before = 0;
  for (int i = 1; i <= pieces; ++i) {
    const double x = static_cast<double>(i) / pieces, here = w * (3 * x * x - x * x * x) / 2;
    lost += std::hypot(length / pieces, here - before) - length / pieces;
    before = here;
  }
  EXPECT_NEAR(lost, 6.0 / 5 * w * w / (2 * length), 1e-3 * lost);
}

/// A speed at which one blade stands still, displaced: each row of `moved` is a contact node's u.
SpeedResponse standing(const ReducedModel& rotor, const Eigen::MatrixX3d& moved) {
  SpeedResponse response = synthetic::speed(synthetic::two_lobes(), rotor.contact, 1000, {}, 1);
  response.displacement.setZero();
  for (Eigen::Index node = 0; node < moved.rows(); ++node)
    response.displacement.middleCols<3>(3 * node).rowwise() = moved.row(node);
  return response;
}

SecondOrderGap round_casing(const ReducedModel& rotor) {
  const Eigen::Index nodes = rotor.contact.size();
  SecondOrderGap second_order{
      Eigen::MatrixX2d::Zero(nodes, 2), Eigen::MatrixXd::Zero(3 * nodes, 1),
      std::vector<Eigen::MatrixXd>(static_cast<std::size_t>(nodes), Eigen::MatrixXd::Zero(1, 1))};
  second_order.curvature.col(0) = rotor.contact.normal.col(0).cwiseQuotient(rotor.contact.position.col(0));
  return second_order;
}

/// A wheel that turns by an angle within a round casing keeps its gap: what the linear gap gains, curvature takes.
TEST(GapTerms, CancelTheOpeningOfATurnedWheel) {
  ReducedModel rotor = synthetic::model();
  rotor.contact.second_order = round_casing(rotor);
  constexpr double angle = 0.01;
  const Eigen::VectorXd radius = rotor.contact.position.col(0);
  Eigen::MatrixX3d moved = Eigen::MatrixX3d::Zero(radius.size(), 3);
  moved.col(0) = radius * (std::cos(angle) - 1);
  moved.col(1) = radius * std::sin(angle);
  const GapTerms terms = gap_terms(standing(rotor, moved), synthetic::two_lobes(), rotor.contact);
  const double opening = (-moved.col(0).cwiseProduct(rotor.contact.normal.col(0))).maxCoeff();
  EXPECT_NEAR(terms.curvature, opening, angle * angle * opening);
  EXPECT_NEAR(terms.together, opening, angle * angle * opening);
}

/// A blade of 30 mm whose tip moves by w on a circle around its root comes back by w^2/(2 L). Around a wheel of 30 mm
/// radius the casing has the same circle, and nothing is left together.
TEST(GapTerms, AddWithTheirSigns) {
  ReducedModel rotor = synthetic::model();
  constexpr double span = 0.03, w = 1e-3;
  rotor.contact.normal.row(0) << 1, 0, 0;
  rotor.contact.second_order = round_casing(rotor);
  SecondOrderGap& second_order = *rotor.contact.second_order;
  second_order.curvature.setZero();
  second_order.curvature(0, 1) = 1 / span;
  second_order.coordinates(2, 0) = 1;
  second_order.displacement[0](0, 0) = -1 / (2 * span);
  Eigen::MatrixX3d moved = Eigen::MatrixX3d::Zero(rotor.contact.size(), 3);
  moved(0, 2) = w;
  const GapTerms terms = gap_terms(standing(rotor, moved), synthetic::two_lobes(), rotor.contact);
  EXPECT_NEAR(terms.curvature, w * w / (2 * span), 1e-15);
  EXPECT_NEAR(*terms.foreshortening, w * w / (2 * span), 1e-15);
  EXPECT_LT(terms.together, 1e-15);
}

/// 3 um of second order at an interference of 40 um are within a tenth of it, 5 um are not; a march that has the
/// terms, and a tip that reaches nowhere and does not move, leave nothing out.
TEST(GapTerms, AreMeasuredByTheInterference) {
  GapTerms terms;
  EXPECT_FALSE(terms.beyond());
  terms.interference = 40e-6;
  terms.together = 3e-6;
  EXPECT_FALSE(terms.beyond());
  terms.together = 5e-6;
  EXPECT_TRUE(terms.beyond());
  EXPECT_EQ(terms.in_words(), "second order of the gap 0.005 mm, at an interference of 0.04 mm");
  terms.modelled = true;
  EXPECT_FALSE(terms.beyond());
}

TEST(GapTerms, InterferenceIsCrestMinusClearanceUnderSpin) {
  const ReducedModel rotor = synthetic::model();
  SimulatedScene scene = synthetic::two_lobes();
  SpeedResponse response = synthetic::speed(scene, rotor.contact, 1000, {}, 1);
  scene.casing_distortion *= 2.5e-4 / scene.casing_distortion.maxCoeff();
  response.clearance << 3e-4, 2.1e-4, 2.3e-4, 2.4e-4;
  EXPECT_NEAR(gap_terms(response, scene, rotor.contact).interference, 4e-5, 1e-12);
}

/// Symptom: with a casing's profile that differs along the tip, the slope of the envelope counted at every node.
TEST(GapTerms, DistortionTakesTheSlopeOverEachNode) {
  const ReducedModel rotor = synthetic::model();
  SimulatedScene scene = synthetic::two_lobes();
  const SpeedResponse response = synthetic::speed(scene, rotor.contact, 1000, {{2, 2, 1e-3, 0}}, 1);
  const double alike = gap_terms(response, scene, rotor.contact).distortion;
  scene.node_distortion = scene.casing_distortion * Eigen::RowVector4d(3.0, 3.0, 3.0, 3.0);
  EXPECT_NEAR(gap_terms(response, scene, rotor.contact).distortion, 3 * alike, 1e-9 * alike);
}

/// Symptom: where a casing's profile stands in over one node, and another has less clearance, the crest over the one
/// was compared with the clearance of the other.
TEST(GapTerms, InterferenceIsOfEachNode) {
  const ReducedModel rotor = synthetic::model();
  SimulatedScene scene = synthetic::two_lobes();
  SpeedResponse response = synthetic::speed(scene, rotor.contact, 1000, {}, 1);
  scene.node_distortion = scene.casing_distortion * Eigen::RowVector4d(1.0, 0.5, 0.2, 0.1);
  scene.node_crest = scene.crest() * Eigen::Vector4d(1.0, 0.5, 0.2, 0.1);
  response.clearance << 5e-4, 4e-4, 3e-4, 2e-4;
  EXPECT_NEAR(gap_terms(response, scene, rotor.contact).interference, -1.7e-4, 1e-6);
  EXPECT_TRUE(scene.distortion_over(3).isApprox(0.1 * scene.casing_distortion));
}

}  // namespace
}  // namespace tiprub::postprocess
