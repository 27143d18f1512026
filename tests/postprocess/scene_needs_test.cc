// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene needs: the sizes of what is left out, against closed forms; and the table that judges them.
#include "postprocess/records/scene_needs_record.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <tuple>

#include "mesh/cells/cell_kind.h"
#include "postprocess/fields/cell_stress.h"
#include "postprocess/report/report.h"
#include "synthetic_fields.h"
#include "synthetic_scene.h"

namespace tiprub::postprocess {
namespace {

TEST(TipSpans, LeadToTheNearestNodeOfTheDisc) {
  SectorFields sector;
  sector.nodes.resize(3, 22);
  sector.nodes.leftCols(20).setRandom();
  sector.nodes.row(0).head(20).setConstant(-3);
  sector.nodes.col(4) << 1, 2, 3;  // of the disc
  sector.nodes.col(20) << 2, 4, 5;
  sector.nodes.col(21) << 1, 2, 10;
  sector.cells = Eigen::VectorXi::LinSpaced(20, 0, 19);
  sector.node_sets["contact"] = {20, 21};
  EXPECT_EQ(tip_spans(sector).size(), 0);
  sector.parts["disc"] = {0};
  const Eigen::VectorXd spans = tip_spans(sector);
  EXPECT_DOUBLE_EQ(spans[0], 3);
  EXPECT_DOUBLE_EQ(spans[1], 7);
}

/// All blades push at node 1 with 3 N on a quarter of the casing, half of the time.
TEST(CasingWear, IsArchards) {
  const ReducedModel rotor = synthetic::model();
  const SimulatedScene scene = synthetic::two_lobes();
  SpeedResponse response = synthetic::speed(scene, rotor.contact, 1000, {}, 1);
  response.contact_force.setZero();
  response.contact_count.setZero();
  const Eigen::Index half = response.contact_force.rows() / 2;
  for (int sector = 0; sector < scene.independent_sectors; ++sector) {
    const int point = sector * rotor.contact.size() + 1;
    response.contact_force.col(point).head(half).setConstant(6);
    for (const int lobe : {0, 100}) response.contact_count.row(point).segment(lobe, 25).setConstant(7);
  }
  constexpr double coefficient = 2e-15, time = 60, turned = 1000 * time;
  const double width = 0.04 * std::numbers::pi / 6;
  const CasingWear wear = casing_wear(response, scene, rotor.contact, coefficient, time);
  EXPECT_EQ(wear.node, 1);
  EXPECT_NEAR(wear.force, 3, 1e-12);
  const double volume = coefficient * 3 * 10 * turned;  // over the radius, which cancels
  EXPECT_NEAR(wear.depth, volume / (0.25 * 2 * std::numbers::pi * width), 1e-9 * wear.depth);
}

/// Symptom: wear at an outermost segment was 1.5 times too deep. Six hat functions, one apart, of which the outermost
/// are halves with their centres a third from the edges.
TEST(CasingWear, IsSpreadOverTheWholeTipLineBySegments) {
  ReducedModel rotor = synthetic::model();
  const int count = rotor.contact.size();
  ASSERT_GE(count, 4);
  rotor.contact.kind = ContactKind::segments;
  rotor.contact.splitter_nodes = 0;
  for (int i = 0; i < count; ++i) rotor.contact.arc_length[i] = i;
  rotor.contact.arc_length[0] = 1.0 / 3;
  rotor.contact.arc_length[count - 1] = count - 1 - 1.0 / 3;
  const SimulatedScene scene = synthetic::two_lobes();
  for (int node = 0; node < count; ++node) {
    SpeedResponse response = synthetic::speed(scene, rotor.contact, 1000, {}, 1);
    response.contact_force.setZero();
    response.contact_count.setZero();
    for (int sector = 0; sector < scene.independent_sectors; ++sector) {
      response.contact_force.col(sector * count + node).setConstant(1);
      response.contact_count.row(sector * count + node).setConstant(1);
    }
    const CasingWear wear = casing_wear(response, scene, rotor.contact, 1e-15, 1);
    const double width = node == 0 || node == count - 1 ? 0.5 : 1;
    EXPECT_NEAR(wear.depth * width, 1e-15 * 10 * 1000 / (2 * std::numbers::pi), 1e-9 * wear.depth) << node;
  }
}

/// A mass on even springs, seen from a turntable: it goes around at sqrt(omega^2 + Omega^2) -+ Omega.
TEST(Coriolis, SplitsAPairOfModes) {
  constexpr double omega = 300, speed = 40;
  Eigen::Matrix2cd coupling;
  coupling << 0, -1, 1, 0;
  const Eigen::VectorXd found = gyroscopic_frequencies(Eigen::Vector2d(omega, omega), coupling, speed);
  const double middle = std::hypot(omega, speed);
  EXPECT_LT((found - Eigen::Vector4d(-middle - speed, -middle + speed, middle - speed, middle + speed)).norm(), 1e-9);
}

/// A wave that runs around with u_theta = i u_r couples with itself alone, by all that is possible; a motion along
/// the axis with nothing.
TEST(Coriolis, CouplesTheRadialWithTheTangential) {
  const SectorFields sector = synthetic::sector_fields(synthetic::model());
  const Eigen::VectorXd volumes = node_volumes(sector);
  EXPECT_NEAR(volumes.sum(), CellStress(sector).volumes().sum(), 1e-12 * volumes.sum());
  Eigen::MatrixXcd shapes = Eigen::MatrixXcd::Zero(3 * sector.nodes.cols(), 2);
  for (Eigen::Index node = 0; node < sector.nodes.cols(); ++node) {
    const std::complex<double> wave = std::polar(sector.nodes.col(node).head<2>().norm(), 0.3 * double(node));
    shapes.block(3 * node, 0, 2, 1) << wave, std::complex<double>(0, 1) * wave;
    shapes(3 * node + 2, 1) = wave;
  }
  Eigen::VectorXd three(shapes.rows());
  for (int axis = 0; axis < 3; ++axis) three(Eigen::seqN(axis, volumes.size(), 3)) = volumes;
  for (int mode = 0; mode < 2; ++mode)
    shapes.col(mode) /= std::sqrt(shapes.col(mode).cwiseAbs2().dot(three));  // to unit modal mass, of unit density
  const Eigen::MatrixXcd coupling = coriolis_coupling(shapes, volumes);
  EXPECT_LT(std::abs(coupling(0, 0) - std::complex<double>(0, -1)), 1e-12);
  EXPECT_LT(std::abs(coupling(0, 1)) + std::abs(coupling(1, 1)), 1e-12);
}

/// x^2 over a box, a wedge and a tetrahedron.
TEST(Coriolis, VolumesOfNodesIntegrateSquares) {
  for (const auto& [nodes, volume, square] :
       {std::tuple{10, 1 / 6.0, 1 / 60.0}, {15, 1.0, 1 / 6.0}, {20, 8.0, 8 / 3.0}, {27, 8.0, 8 / 3.0}}) {
    SectorFields sector;
    sector.cells = Eigen::VectorXi::LinSpaced(nodes, 0, nodes - 1);
    sector.young = sector.density = 1;
    sector.nodes.resize(3, nodes);
    for (int k = 0; k < nodes; ++k) {
      const auto& at = cell_kind(nodes).places[static_cast<std::size_t>(k)];
      sector.nodes.col(k) << 2.0 * at[0], 0.5 * at[1], 3.0 * at[2];
    }
    const Eigen::VectorXd volumes = node_volumes(sector), x = sector.nodes.row(0).transpose();
    EXPECT_NEAR(volumes.sum(), 3 * volume, 1e-12);
    EXPECT_NEAR(volumes.dot(x.cwiseAbs2()), 12 * square, 1e-11);
  }
}

class SceneNeeds : public ::testing::Test {
 protected:
  static Study study(const PostprocessParameters& parameters = {}) {
    const ReducedModel rotor = synthetic::model();
    Response response = synthetic::resonant_sweep(rotor);
    response.speeds[3].chatter = 0.2;
    for (SpeedResponse& speed : response.speeds) speed.audit.symmetry = SymmetryVerdict::holds;
    for (SpeedResponse& speed : response.speeds) speed.audit.excluded_growth = 0.9;
    response.speeds[5].audit.symmetry = SymmetryVerdict::undecided;
    response.speeds[7].audit.halving_difference = 1e-3;
    return make_study(parameters, rotor, response, {});
  }
  static SceneNeed need(const std::vector<SceneNeed>& needs, Effect effect) {
    for (const SceneNeed& need : needs)
      if (need.effect.effect == effect) return need;
    ADD_FAILURE() << "no need tells of " << name_with_unit(effect);
    return {};
  }
};

TEST_F(SceneNeeds, EachHasASizeAndATolerance_OrAWayToOne) {
  for (const auto& [effect, verdict, how] : scene_needs(study(), {})) {
    const std::string name = name_with_unit(effect.effect);
    if (verdict == NeedVerdict::none) continue;
    EXPECT_NE(how, "") << name;
    EXPECT_EQ(effect.size.has_value(), verdict != NeedVerdict::not_estimated) << name;
    EXPECT_EQ(effect.size.has_value(), effect.tolerance.has_value()) << name;
    if (verdict == NeedVerdict::negligible) {
      EXPECT_LE(*effect.size, *effect.tolerance) << name;
    }
  }
}

TEST_F(SceneNeeds, AreJudgedOnTheScene) {
  const std::vector<SceneNeed> needs = scene_needs(study(), {.tip_span = Eigen::Vector4d::Constant(1e-4)});
  EXPECT_EQ(need(needs, Effect::round_casing).verdict, NeedVerdict::negligible);
  EXPECT_EQ(need(needs, Effect::blade_foreshortening).verdict, NeedVerdict::matters);
  EXPECT_EQ(need(needs, Effect::nodal_diameters).verdict, NeedVerdict::undecided);
  EXPECT_NE(need(needs, Effect::nodal_diameters).how.find("1 undecided, 0 unchecked"), std::string::npos);
  EXPECT_EQ(need(needs, Effect::time_step).verdict, NeedVerdict::negligible);
  EXPECT_NE(need(needs, Effect::time_step).how.find("at 1 of 47 speeds"), std::string::npos);
  EXPECT_EQ(need(needs, Effect::chatter).verdict, NeedVerdict::matters);
  EXPECT_EQ(need(needs, Effect::spin_stiffness).verdict, NeedVerdict::not_estimated);
  EXPECT_EQ(need(needs, Effect::contact_resolution).how, "compare with tiprub-reduce --set reduce.contact_nodes=8");
  const double crest = study().response.scene.casing_distortion.maxCoeff();
  const double clearance = study().judged_response().clearance.minCoeff();
  EXPECT_NEAR(*need(needs, Effect::round_casing).effect.tolerance, 0.1 * (crest - clearance), 1e-15);
}

TEST_F(SceneNeeds, TakeTheErrorOfTheMeshFromTheModel) {
  Study made = study();
  EXPECT_EQ(need(scene_needs(made, {}), Effect::mesh).verdict, NeedVerdict::not_estimated);
  const WaveLabel& wave = made.critical[*largest_critical(made.critical)].rising;
  const Eigen::Index diameters = made.model.nodal_diameter_max() + 1, n = std::abs(wave.signed_nodal_diameter);
  made.model.mesh_error = {Eigen::MatrixXd::Constant(diameters, wave.family + 1, 0.5),
                           Eigen::VectorXd::Constant(made.model.contact.size(), 0.04)};
  made.model.mesh_error->frequency(n, wave.family) = 0.02;
  SceneNeed mesh = need(scene_needs(made, {}), Effect::mesh);
  EXPECT_EQ(mesh.effect.size, 0.02);
  EXPECT_EQ(mesh.verdict, NeedVerdict::matters);
  EXPECT_NE(mesh.how.find("the compliance of the tip is up to 4 % too small"), std::string::npos) << mesh.how;
  made.critical[*largest_critical(made.critical)].rising.family += 1;
  mesh = need(scene_needs(made, {}), Effect::mesh);
  EXPECT_EQ(mesh.verdict, NeedVerdict::not_estimated);
  EXPECT_EQ(mesh.how, "reduce with more verification_modes: it takes the mode of the largest peak");
}

/// A tip that moves 3 along theta for each -1 along its normal: a coefficient of 0.1 does 0.3 of the normal force's
/// work.
TEST_F(SceneNeeds, SizesFrictionByTheMotionAlongTheCasing) {
  Study made = study();
  const Eigen::Index nodes = made.model.contact.size();
  for (SpeedResponse& response : made.response.speeds) {
    response.contact_force.setOnes();
    for (Eigen::Index point = 0; point < response.contact_force.cols(); ++point) {
      auto moves = response.displacement.middleCols<3>(3 * point);
      const Eigen::VectorXd across = moves * made.model.contact.normal.row(point % nodes).transpose();
      moves.col(1) = -3 * across;
    }
  }
  const SceneNeed friction = need(scene_needs(made, {}), Effect::friction);
  EXPECT_EQ(friction.verdict, NeedVerdict::matters);
  EXPECT_NEAR(*friction.effect.size, 0.3, 1e-12);
  for (ModelledEffect& effect : made.response.scene.effects)
    if (effect.effect == Effect::friction) effect.treatment = Treatment::modelled;
  EXPECT_EQ(need(scene_needs(made, {}), Effect::friction).verdict, NeedVerdict::none);
}

TEST_F(SceneNeeds, PowerOfFrictionStandsInTheVerdict) {
  Study made = study();
  const auto all_text = [&] {
    std::string text;
    for (const Answer& answer : verdict(made, field_results(std::nullopt, made.critical), {})) text += answer.text;
    return text;
  };
  EXPECT_EQ(all_text().find("Friction takes"), std::string::npos);
  for (SpeedResponse& speed : made.response.speeds) {
    speed.friction.rub_power_mean = 3.8e5;
    speed.friction.rub_power_largest = 1.2e6;
  }
  EXPECT_NE(all_text().find("Friction takes 380 kW of the wheel's power on average, and at most 1200 kW."),
            std::string::npos);
}

/// A speed that nobody looked at leaves the question open, even where all others hold.
TEST_F(SceneNeeds, OneUncheckedSpeedLeavesSymmetryOpen) {
  Study made = study();
  const auto verdict_with = [&](SymmetryVerdict at_one) {
    made.response.speeds[5].audit.symmetry = at_one;
    return need(scene_needs(made, {}), Effect::nodal_diameters).verdict;
  };
  EXPECT_EQ(verdict_with(SymmetryVerdict::holds), NeedVerdict::negligible);
  EXPECT_EQ(verdict_with(SymmetryVerdict::unchecked), NeedVerdict::undecided);
  EXPECT_EQ(verdict_with(SymmetryVerdict::breaking), NeedVerdict::matters);
}

/// Symptom: of a nonlinear model without spin softening the measured misfit of eq. 7 was lost, "not estimated".
TEST_F(SceneNeeds, SizesNonlinearPrestressWithoutSpinSofteningToo) {
  Study made = study();
  made.model.prestress = Prestress::nonlinear;
  made.model.verification.speeds = Eigen::VectorXd::Zero(1);
  made.model.verification.polynomial_misfit = Eigen::MatrixXd::Constant(1, 1, 2e-4);
  for (const SpinSoftening softening : {SpinSoftening::on, SpinSoftening::off}) {
    made.model.spin_softening = softening;
    made.model.effects = effects_of(made.model);
    EXPECT_EQ(need(scene_needs(made, {}), Effect::spin_stiffness).effect.size, 2e-4);
  }
}

/// Symptom: a report said that no program models differences between the blades, of a scene with [casing]
/// blade_clearance. Who marched the scene says what it models.
TEST_F(SceneNeeds, TellsWhatTheResponseModels) {
  Study made = study();
  EXPECT_EQ(need(scene_needs(made, {}), Effect::blade_clearance).verdict, NeedVerdict::not_estimated);
  made.response.scene.effects.push_back({Effect::blade_clearance, Treatment::modelled, "each has its own", 2e-5});
  std::erase_if(made.response.scene.effects, [](const ModelledEffect& effect) {
    return effect.effect == Effect::blade_clearance && effect.treatment == Treatment::left_out;
  });
  const std::vector<SceneNeed> needs = scene_needs(made, {});
  EXPECT_EQ(need(needs, Effect::blade_clearance).verdict, NeedVerdict::none);
  EXPECT_EQ(effects_in_words(needs, Treatment::modelled),
            "modelled: differences of the clearance between the blades, damping of the modes");
  EXPECT_EQ(effects_in_words(needs, Treatment::left_out),
            "left out: friction at the tips, differences of mass and stiffness between the blades, Coriolis terms");
  const Table table = scene_needs_record(needs);
  const auto row = std::find_if(table.rows.begin(), table.rows.end(), [](const std::vector<Cell>& cells) {
    return csv_cell(cells[0]) == name_with_unit(Effect::blade_clearance);
  });
  ASSERT_NE(row, table.rows.end());
  EXPECT_DOUBLE_EQ(std::get<double>((*row)[5]), 0.02);
}

/// Symptom: branches of a scheme that lacks the instants of impacts were called stable without a word about that.
TEST_F(SceneNeeds, TellThatMultipliersLackTheInstantsOfImpacts) {
  Study made = study();
  OrbitBranch branch;
  branch.speed = branch.amplitude = Eigen::Vector3d(1100, 1200, 1300);
  branch.multiplier = Eigen::Vector3d::Constant(0.5);
  branch.multiplier_angle = Eigen::Vector3d::Zero();
  made.response.branches = {branch};
  const auto said = [&] {
    for (const std::string& line : summary(made))
      if (line.find("leaves at once") != std::string::npos) return line;
    return std::string();
  };
  EXPECT_EQ(said(), "");
  made.response.scene.effects.push_back(
      {Effect::impact_instants, Treatment::simplified, "multipliers do not hold where a node leaves at once"});
  EXPECT_EQ(said(), " About the stability of the branches: multipliers do not hold where a node leaves at once.");
  const SceneNeed told = need(scene_needs(made, {}), Effect::impact_instants);
  EXPECT_EQ(told.verdict, NeedVerdict::not_estimated);
  EXPECT_EQ(told.how, "compare with settings that model it");
}

TEST_F(SceneNeeds, WithoutACoefficientNoWear) {
  EXPECT_GT(*need(scene_needs(study(), {}), Effect::casing_wear).effect.size, 0);
  PostprocessParameters parameters;
  parameters.wear_coefficient = 0;
  EXPECT_EQ(need(scene_needs(study(parameters), {}), Effect::casing_wear).verdict, NeedVerdict::not_estimated);
}

}  // namespace
}  // namespace tiprub::postprocess
