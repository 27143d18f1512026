// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "postprocess/analysis/contact_maps.h"
#include "postprocess/analysis/critical_speeds.h"
#include "postprocess/analysis/interaction_map.h"
#include "postprocess/analysis/study.h"
#include "postprocess/records/study_records.h"
#include "simulate/motion/casing_areas.h"
#include "synthetic_scene.h"

namespace tiprub::postprocess {
namespace {

const Study& made_study() {
  static const Study study = [] {
    ReducedModel rotor = synthetic::model();
    Response response = synthetic::resonant_sweep(rotor);
    PostprocessParameters parameters;
    parameters.prominence = 0.15;
    return make_study(parameters, std::move(rotor), std::move(response), {});
  }();
  return study;
}

// --- contact maps: checks 57-59 ---

/// Symptom: shares up to 1.11 and stripes all over the maps. Cause: counts were divided by the mean number of steps
/// over an area; where the areas don't divide the steps, some have one more. A node that is closed all the time has 1
/// everywhere, and one that is closed in some steps no more than that.
TEST(ContactMap, DividesByTheStepsOverEachArea) {
  const ReducedModel rotor = synthetic::model();
  Response closed{synthetic::two_lobes(), "made", {}, {}};
  closed.scene.clearance.setConstant(-1e-2);
  closed.speeds.push_back(synthetic::speed(closed.scene, rotor.contact, 1500, {}, 2));
  SpeedResponse& speed = closed.speeds.front();
  for (const int areas : {200, 70, 5000}) {  // 3600 steps: they divide them, don't, are narrower than one
    speed.contact_count.setZero(speed.contact_count.rows(), areas);
    for (int node = 0; node < rotor.contact.size(); ++node)
      speed.contact_count.row(node) =
          2 * steps_over_areas({rotor.contact.position(node, 1), 0, 10, speed.steps_per_revolution}, areas);
    for (int node = 0; node < rotor.contact.size(); ++node)
      EXPECT_EQ(contact_map(closed, rotor.contact, node).share, Eigen::MatrixXd::Ones(areas, 1)) << areas;
  }
  const Study& study = made_study();
  for (const ContactMap* edge : {&study.contact.leading, &study.contact.trailing}) {
    EXPECT_LE(edge->share.maxCoeff(), 1.0);
    EXPECT_GT(edge->share.maxCoeff(), 0.5);
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
  for (const MapColumn& column : study.waves.first().columns) {
    const Eigen::VectorXd sum = column.parts.rowwise().sum();
    EXPECT_LE((column.total - sum).cwiseAbs().maxCoeff(), 1e-12 * column.total.maxCoeff());
    EXPECT_NEAR(column.total.sum(), column.spectrum.amplitude.sum(), 1e-12 * column.total.sum());
  }
}

TEST(InteractionMap, OddNodalDiametersStayEmptyUnderTwoLobes) {
  const Eigen::VectorXd shares = energy_shares(made_study().waves.first());
  EXPECT_NEAR(shares.sum(), 1.0, 1e-12);
  EXPECT_LT(shares[1] + shares[3] + shares[5], 1e-20);
}

TEST(HarmonicTracking, ReadsTheSpectrum) {
  const Study& study = made_study();
  const HarmonicTracking by_diameter = nodal_diameter_tracking(study.waves.first(), 6);
  const HarmonicTracking by_order = engine_order_tracking(study.waves.first(), 4, {1, 2, 3, 4, 5, 6});
  for (std::size_t i = 0; i < study.waves.first().columns.size(); ++i) {
    const TravellingSpectrum& spectrum = study.waves.first().columns[i].spectrum;
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
                synthetic::crossing_speed(std::abs(want.signed_nodal_diameter), want.family, want.engine_order),
                step);
    EXPECT_EQ(critical.node, 0);
    EXPECT_TRUE(critical.by_aliasing);
    EXPECT_FALSE(critical.by_equation_2);
  }
  EXPECT_EQ(study.speed_at(study.critical[2].index).motion, MotionClass::subharmonic);
  EXPECT_EQ(study.rules.equation_2_score.misses, 4);
  EXPECT_EQ(study.rules.aliasing_score.hits, 4);
}

/// Symptom: at 13,900 rpm the table said "EO 2". The casing pushes the wheel through EO 2 everywhere; what resonates
/// there is EO 10. Both are told apart.
TEST(CriticalSpeeds, TheRisingWaveIsNotAlwaysTheLargest) {
  const CriticalSpeed& critical = made_study().critical[1];
  EXPECT_EQ(critical.rising.engine_order, 10);
  EXPECT_EQ(critical.others.front().engine_order, 2);
  EXPECT_GT(critical.others.front().amplitude, critical.rising.amplitude);
}

/// Forward waves, which eq. 2 excludes, are listed as such.
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
  for (std::size_t i = 0; i < study.waves.first().columns.size(); ++i) {
    const double share = subharmonic_share(study.waves.first().columns[i].spectrum);
    if (i == 30 || i == 31)
      EXPECT_GT(share, 0.01);
    else
      EXPECT_LT(share, 1e-20);
  }
}

}  // namespace
}  // namespace tiprub::postprocess
