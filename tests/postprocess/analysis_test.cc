// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "postprocess/analysis/aliasing.h"
#include "postprocess/analysis/contact_map.h"
#include "postprocess/analysis/critical_speeds.h"
#include "postprocess/analysis/harmonic_tracking.h"
#include "postprocess/analysis/linear_criterion.h"
#include "postprocess/analysis/study.h"
#include "postprocess/report/result_tables.h"
#include "postprocess/tables/units.h"
#include "synthetic_scene.h"

namespace tiprub {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

const Study& made_study() {
  static const Study study = [] {
    ReducedModel rotor = synthetic::model();
    Response response = synthetic::resonant_sweep(rotor);
    PostprocessParameters parameters;
    parameters.prominence = 0.15;
    return make_study(parameters, std::move(rotor), std::move(response));
  }();
  return study;
}

// --- aliasing: checks 43-47 and 54 ---

TEST(Aliasing, TenBladesCannotTellSixFromFour) {
  for (int j = 0; j < 10; ++j) {
    EXPECT_NEAR(std::cos(6 * two_pi * j / 10), std::cos(4 * two_pi * j / 10), 1e-14);
    EXPECT_NEAR(std::cos(8 * two_pi * j / 10), std::cos(2 * two_pi * j / 10), 1e-14);
  }
}

TEST(Aliasing, IsTheZigZagOfTheTenBlades) {
  const int zigzag[] = {0, 1, 2, 3, 4, 5, 4, 3, 2, 1};
  for (int order = 0; order <= 40; ++order) EXPECT_EQ(aliased_nodal_diameter(order, 10), zigzag[order % 10]);
}

TEST(Aliasing, TwoAndThreeLobes) {
  const int two[] = {2, 4, 4, 2, 0, 2}, three[] = {3, 4, 1, 2, 5, 2, 1, 4, 3, 0};
  for (int k = 1; k <= 6; ++k) EXPECT_EQ(aliased_nodal_diameter(2 * k, 10), two[k - 1]);
  for (int k = 1; k <= 10; ++k) EXPECT_EQ(aliased_nodal_diameter(3 * k, 10), three[k - 1]);
}

TEST(Aliasing, SmallestEngineOrderSolvesEquation17) {
  for (const int sectors : {1, 2, 7, 10, 13})
    for (int lobes = 1; lobes <= 6; ++lobes)
      for (int n = 0; n <= sectors / 2; ++n) {
        std::optional<int> expected;  // alpha N +- n = k N_l, by trying
        for (int k = 1; k <= 2 * sectors && !expected; ++k)
          if ((k * lobes - n) % sectors == 0 || (k * lobes + n) % sectors == 0) expected = k * lobes;
        EXPECT_EQ(smallest_engine_order(n, lobes, sectors), expected) << sectors << " " << lobes << " " << n;
      }
  EXPECT_FALSE(smallest_engine_order(1, 2, 10));
  EXPECT_EQ(smallest_engine_order(0, 2, 10), 10);
}

TEST(Aliasing, DirectionOfTheEngineOrders) {
  for (int order = 1; order <= 30; ++order) {
    const WaveDirection direction = wave_direction(signed_nodal_diameter(order, 10), 10);
    const int place = order % 10;
    const WaveDirection expected = place == 0 || place == 5 ? WaveDirection::standing
                                   : place < 5              ? WaveDirection::backward
                                                            : WaveDirection::forward;
    EXPECT_EQ(direction, expected) << "EO " << order;
  }
  EXPECT_EQ(signed_nodal_diameter(3, 10), 3);
  EXPECT_EQ(signed_nodal_diameter(6, 10), -4);
  EXPECT_EQ(signed_nodal_diameter(9, 10), -1);
  EXPECT_EQ(signed_nodal_diameter(12, 10), 2);
}

// --- linear criterion: checks 10-11 ---

/// sqrt(f0^2 + b r^2) = k r with r the rotation frequency: r = f0 / sqrt(k^2 - b).
double crossing_in_closed_form(int nodal_diameter, int family, int engine_order) {
  return two_pi * synthetic::rest_frequency(nodal_diameter, family) /
         std::sqrt(engine_order * engine_order - synthetic::stiffening);
}

TEST(LinearCriterion, Equation2MatchesTheClosedForm) {
  const FrequencyCurves curves(synthetic::model(), 2500);
  const SpeedRange range{1000, 2500};
  const std::vector<Crossing> crossings = equation_2_crossings(curves, 10, 2, range);
  std::size_t expected = 0;
  for (int n = 1; n <= 5; ++n)
    for (int family = 0; family < 2; ++family) {
      const double speed = crossing_in_closed_form(n, family, n);
      if (speed < range.low || speed > range.high) continue;
      ++expected;
      EXPECT_TRUE(std::any_of(crossings.begin(), crossings.end(),
                              [&](const Crossing& crossing) {
                                return crossing.signed_nodal_diameter == n && crossing.engine_order == n &&
                                       crossing.family == family && std::abs(crossing.speed - speed) < 1e-8 * speed;
                              }))
          << "nodal diameter " << n << ", family " << family;
    }
  EXPECT_GT(expected, 0U);
  EXPECT_EQ(crossings.size(), expected);
}

TEST(LinearCriterion, AliasedCrossingsMatchTheClosedForm) {
  const FrequencyCurves curves(synthetic::model(), 2500);
  for (const Crossing& crossing : aliased_crossings(curves, 10, 2, 2, 12, {1000, 2500})) {
    EXPECT_EQ(crossing.engine_order % 2, 0);
    EXPECT_EQ(crossing.signed_nodal_diameter, signed_nodal_diameter(crossing.engine_order, 10));
    const double speed =
        crossing_in_closed_form(std::abs(crossing.signed_nodal_diameter), crossing.family, crossing.engine_order);
    EXPECT_NEAR(crossing.speed, speed, 1e-8 * speed);
  }
  EXPECT_TRUE(aliased_crossings(curves, 10, 2, 0, 12, {1000, 2500}).empty());
}

/// f = |-f_c + n Omega| has two roots, n Omega = f_c - f and f_c + f, for a mode below the casing's.
TEST(LinearCriterion, AFlexibleCasingGivesBothRoots) {
  const auto constant = [](double) { return 100.0; };
  const std::vector<double> speeds = criterion_speeds(constant, 4, 300.0, {0, 1000});
  ASSERT_EQ(speeds.size(), 2U);
  EXPECT_NEAR(speeds[0], two_pi * 200 / 4, 1e-9);
  EXPECT_NEAR(speeds[1], two_pi * 400 / 4, 1e-9);
}

TEST(FrequencyCurves, FollowTheClosedFormBetweenTheirSamples) {
  const FrequencyCurves curves(synthetic::model(9), 2500);
  EXPECT_EQ(curves.nodal_diameters(), 5);
  for (const double speed : {0.0, 37.0, 911.0, 1777.7, 2500.0})
    for (int n = 0; n < 5; ++n)
      for (int family = 0; family < 3; ++family)
        EXPECT_NEAR(curves.frequency(n, family, speed), synthetic::frequency(n, family, speed), 1e-7);
}

// --- contact maps: checks 57-59 ---

TEST(ContactMap, KeepsEveryCount) {
  const Study& study = made_study();
  for (std::size_t i = 0; i < study.response.speeds.size(); ++i) {
    const SpeedResponse& at = study.response.speeds[i];
    const double steps_over_an_area = static_cast<double>(at.steps_per_revolution) * at.recorded_revolutions /
                                      static_cast<double>(at.contact_count.cols());
    EXPECT_NEAR(study.leading_edge.share.col(static_cast<Eigen::Index>(i)).sum() * steps_over_an_area,
                static_cast<double>(at.contact_count.row(0).sum()), 1e-9);
  }
}

TEST(ContactMap, ContrastTellsSharpFromGrey) {
  EXPECT_EQ(contact_contrast(Eigen::VectorXd::Zero(200)), 0.0);
  EXPECT_NEAR(contact_contrast(Eigen::VectorXd::Constant(200, 0.3)), 0.0, 1e-14);
  Eigen::VectorXd six = Eigen::VectorXd::Zero(200);
  for (int k = 0; k < 6; ++k) six[30 * k + 3] = 1.0;
  EXPECT_NEAR(contact_contrast(six), 1 - 6.0 / 200, 1e-14);
}

TEST(ContactMap, CountsPlacesAroundTheCasing) {
  Eigen::VectorXd column = Eigen::VectorXd::Zero(200);
  EXPECT_EQ(contact_clusters(column), 0);
  column.segment(0, 3).setOnes();
  column.segment(197, 3).setOnes();  // one place across the seam
  EXPECT_EQ(contact_clusters(column), 1);
  column.segment(100, 5).setOnes();
  EXPECT_EQ(contact_clusters(column), 2);
  column[102] = 0;  // a gap of one area parts nothing
  EXPECT_EQ(contact_clusters(column), 2);
  column[50] = 0.2;  // pale
  EXPECT_EQ(contact_clusters(column), 2);
  EXPECT_EQ(contact_clusters(Eigen::VectorXd::Ones(200)), 1);
}

// --- maps and trackings: checks 60, 64, 65 ---

TEST(InteractionMap, TotalIsTheSumOfItsParts) {
  const Study& study = made_study();
  for (const MapColumn& column : study.map.columns) {
    const Eigen::VectorXd sum = column.parts.rowwise().sum();
    EXPECT_LE((column.total - sum).cwiseAbs().maxCoeff(), 1e-12 * column.total.maxCoeff());
    EXPECT_NEAR(column.total.sum(), column.spectrum.amplitude.sum(), 1e-12 * column.total.sum());
  }
}

TEST(InteractionMap, OddNodalDiametersStayEmptyUnderTwoLobes) {
  const Eigen::VectorXd shares = energy_shares(made_study().map);
  EXPECT_NEAR(shares.sum(), 1.0, 1e-12);
  EXPECT_LT(shares[1] + shares[3] + shares[5], 1e-20);
}

TEST(HarmonicTracking, ReadsTheSpectrum) {
  const Study& study = made_study();
  const HarmonicTracking by_diameter = nodal_diameter_tracking(study.map, 6);
  const HarmonicTracking by_order = engine_order_tracking(study.map, 4, {1, 2, 3, 4, 5, 6});
  for (std::size_t i = 0; i < study.map.columns.size(); ++i) {
    const TravellingSpectrum& spectrum = study.map.columns[i].spectrum;
    const auto row = static_cast<Eigen::Index>(i);
    EXPECT_EQ(by_diameter.curves(row, 4), spectrum.at(6, 4) + spectrum.at(6, -4));
    EXPECT_EQ(by_diameter.curves(row, 4), by_order.curves(row, 5));
    EXPECT_NEAR(by_order.mean[row], by_order.curves.row(row).sum() / 6, 1e-18);
  }
}

// --- peaks and critical speeds ---

TEST(Peaks, NeedProminence) {
  Eigen::VectorXd curve(9);
  curve << 1, 3, 2.9, 3.1, 1, 1, 2, 2, 0.5;
  const std::vector<Peak> peaks = find_peaks(curve, 0.2);
  ASSERT_EQ(peaks.size(), 2U);
  EXPECT_EQ(peaks[0].index, 3);  // the shoulder at 1 stands 0.1 above its valley
  EXPECT_NEAR(peaks[0].prominence, 2.1, 1e-14);
  EXPECT_EQ(peaks[1].index, 6);                                               // the first of equals
  EXPECT_TRUE(find_peaks(Eigen::VectorXd::LinSpaced(5, 0, 1), 0.1).empty());  // an end is no peak
  EXPECT_EQ(rising_ends(Eigen::VectorXd::LinSpaced(5, 0.5, 1), 0.1), (std::vector<Eigen::Index>{4}));
}

/// The made sweep resonates where k Omega meets a mode of the nodal diameter of eq. 17: every peak must carry the
/// right wave and family, at the right speed.
TEST(CriticalSpeeds, AreFoundAndNamed) {
  const Study& study = made_study();
  struct Expected {
    int engine_order, signed_nodal_diameter, family;
    WaveDirection direction;
  };
  const Expected expected[] = {{8, -2, 0, WaveDirection::forward},
                               {10, 0, 1, WaveDirection::standing},
                               {6, -4, 0, WaveDirection::forward},
                               {8, -2, 1, WaveDirection::forward}};
  ASSERT_EQ(study.critical.size(), std::size(expected));
  const double step = (study.range.high - study.range.low) / 47;
  for (std::size_t i = 0; i < study.critical.size(); ++i) {
    const CriticalSpeed& critical = study.critical[i];
    const Expected& want = expected[i];
    EXPECT_EQ(critical.rising.engine_order, want.engine_order);
    EXPECT_EQ(critical.rising.signed_nodal_diameter, want.signed_nodal_diameter);
    EXPECT_EQ(critical.rising.family, want.family);
    EXPECT_EQ(critical.rising.direction, want.direction);
    EXPECT_NEAR(critical.speed,
                crossing_in_closed_form(std::abs(want.signed_nodal_diameter), want.family, want.engine_order), step);
    EXPECT_EQ(critical.node, 0);
    EXPECT_TRUE(critical.by_aliasing);
    EXPECT_FALSE(critical.by_equation_2);
  }
  EXPECT_EQ(study.critical[2].motion, MotionClass::subharmonic);
  EXPECT_EQ(study.equation_2_score.misses, 4);
  EXPECT_EQ(study.aliasing_score.hits, 4);
  EXPECT_EQ(study.aliasing_score.false_alarms, 1);  // EO 12 on family 2 is a shoulder only
}

/// Symptom: at 13,900 rpm the table said "EO 2". The casing pushes the wheel through EO 2 everywhere; what resonates
/// there is EO 10. Both are told apart.
TEST(CriticalSpeeds, TheRisingWaveIsNotAlwaysTheLargest) {
  const CriticalSpeed& critical = made_study().critical[1];
  EXPECT_EQ(critical.rising.engine_order, 10);
  EXPECT_EQ(critical.largest.engine_order, 2);
}

TEST(CriticalSpeeds, RuleSaysWhatItLeavesOut) {
  const Table table = linear_criterion_record(made_study());
  ASSERT_FALSE(table.rows.empty());
  const bool forward_excluded = std::any_of(table.rows.begin(), table.rows.end(), [](const auto& row) {
    return std::get<std::string>(row[6]) == "excluded: forward wave";
  });
  EXPECT_TRUE(forward_excluded);
}

TEST(Study, CountsFractionsOfAnEngineOrder) {
  const Study& study = made_study();
  for (std::size_t i = 0; i < study.map.columns.size(); ++i) {
    const double share = subharmonic_share(study.map.columns[i].spectrum);
    if (i == 30 || i == 31)
      EXPECT_GT(share, 0.01);
    else
      EXPECT_LT(share, 1e-20);
  }
}

}  // namespace
}  // namespace tiprub
