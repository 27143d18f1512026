// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene says that it models.
#include "simulate/sweep/simulated_scene.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <numbers>

#include "reduce/model/hdf5_file.h"
#include "simulate/response/response_file.h"
#include "tests/simulate/synthetic_wheel.h"
#include "tests/simulate/written_response.h"

namespace tiprub::simulate {
namespace {

class SceneEffects : public ::testing::Test {
 protected:
  ModelledEffect of(Effect effect) const {
    const SceneScope scope = find_scope(model_.sector_count, 2, parameters_);
    const std::vector<ModelledEffect> effects = effects_of(Scene{model_, casing_, parameters_, scope});
    const ModelledEffect* const found = find(effects, effect);
    if (found == nullptr) ADD_FAILURE() << "nothing is told of " << meaning_of(effect).words;
    return found == nullptr ? ModelledEffect{} : *found;
  }

  ReducedModel model_ = testing::synthetic_wheel({});
  Casing casing_;
  SimulateParameters parameters_;
};

/// Symptom: reports said that no program models differences between the blades, whatever `blade_clearance` was.
TEST_F(SceneEffects, TellsOfBladesThatDiffer) {
  EXPECT_EQ(of(Effect::blade_clearance).treatment, Treatment::left_out);
  casing_.blade_clearance = {0, 2e-5, 1e-5};
  EXPECT_EQ(of(Effect::blade_clearance).treatment, Treatment::modelled);
  EXPECT_EQ(of(Effect::blade_clearance).size, 2e-5);
}

TEST_F(SceneEffects, TellsOfTheContact) {
  EXPECT_EQ(of(Effect::normal_contact).treatment, Treatment::modelled);
  parameters_.scheme = Scheme::central_differences;
  parameters_.contact = ContactRule::paper;
  EXPECT_EQ(of(Effect::normal_contact).treatment, Treatment::simplified);
  EXPECT_NE(of(Effect::normal_contact).reason.find("central_differences"), std::string::npos);
  EXPECT_EQ(of(Effect::friction).treatment, Treatment::left_out);
}

TEST_F(SceneEffects, TellsWhetherMultipliersHaveTheInstantsOfImpacts) {
  EXPECT_EQ(of(Effect::impact_instants).treatment, Treatment::modelled);
  for (const Scheme scheme : {Scheme::central_differences, Scheme::residual_flexibility}) {
    parameters_.scheme = scheme;
    EXPECT_EQ(of(Effect::impact_instants).treatment, Treatment::simplified);
    EXPECT_NE(of(Effect::impact_instants).reason.find("multipliers do not hold"), std::string::npos);
  }
}

TEST_F(SceneEffects, TellsOfFriction) {
  EXPECT_EQ(of(Effect::friction).treatment, Treatment::left_out);
  EXPECT_NE(of(Effect::friction).reason.find("jams"), std::string::npos);
  casing_.friction = {{0.0, 0.1}};
  EXPECT_EQ(of(Effect::friction).treatment, Treatment::modelled);
  EXPECT_NE(of(Effect::friction).reason.find("coefficient 0.1,"), std::string::npos);
}

/// Only a profile can differ between the contact nodes of a tip.
TEST_F(SceneEffects, TellsWhereTheCasingStandsOverEachNode) {
  const SceneScope scope = find_scope(model_.sector_count, 2, parameters_);
  const auto described = [&] { return simulated_scene(Scene{model_, casing_, parameters_, scope}, {}); };
  casing_.amplitude = 1e-4, casing_.clearance = {{0.0, 1e-4}};
  casing_.lobes = 2;
  EXPECT_EQ(described().node_crest.size(), 0);
  casing_.shape = CasingShape::profile;
  casing_.profile = read_casing_profile({"casing.csv", "0, 0.0, 1.0\n0, 1e-4, 0\n90, 0, 3e-4\n"}, std::numbers::pi);
  const SimulatedScene scene = described();
  const int last = model_.contact.size() - 1;
  EXPECT_NEAR(scene.node_crest[0], 1e-4, 1e-15);
  EXPECT_NEAR(scene.node_crest[last], 3e-4, 1e-15);
  EXPECT_NEAR(scene.distortion_over(0).maxCoeff(), 1e-4, 1e-8);
  EXPECT_NEAR(scene.interference(Eigen::VectorXd::Constant(last + 1, 2e-4)).maxCoeff(), 1e-4, 1e-15);
}

/// In response.h5, by the attribute `comment`.
TEST_F(SceneEffects, StandBesideMultipliersThatLackTheInstantsOfImpacts) {
  const auto path = std::filesystem::temp_directory_path() / ("tiprub-effects-" + std::to_string(getpid()) + ".h5");
  Response response;
  response.scene.casing_angle = response.scene.casing_distortion = Eigen::VectorXd::LinSpaced(5, 0, 6.28);
  response.scene.clearance = Eigen::VectorXd::Constant(3, 1e-4);
  response.speeds.resize(1);
  response.speeds[0].failure = "why";
  OrbitBranch branch;
  for (Eigen::VectorXd* array : {&branch.speed, &branch.amplitude, &branch.multiplier, &branch.multiplier_uncertainty,
                                 &branch.multiplier_angle})
    *array = Eigen::Vector2d(1, 2);
  response.branches = {branch};
  for (const Scheme scheme : {Scheme::trigonometric, Scheme::central_differences}) {
    parameters_.scheme = scheme;
    const ModelledEffect impacts = of(Effect::impact_instants);
    response.scene.effects = {impacts};
    write_response(response, path, "test");
    const Hdf5File file = Hdf5File::open(path);
    for (const std::string dataset : {"/multiplier", "/branch/0/multiplier"})
      EXPECT_EQ(file.has_attribute(dataset, "comment") ? file.text_attribute(dataset, "comment") : "",
                scheme == Scheme::trigonometric ? "" : impacts.reason);
  }
  std::filesystem::remove(path);
}

TEST_F(SceneEffects, TellsOfNodalDiametersAndModes) {
  EXPECT_EQ(of(Effect::nodal_diameters).treatment, Treatment::left_out);
  parameters_.nodal_diameters = DiameterChoice::all;
  EXPECT_EQ(of(Effect::nodal_diameters).treatment, Treatment::modelled);
  EXPECT_EQ(of(Effect::massless_modes).treatment, Treatment::modelled);
  parameters_.modes = 3;
  EXPECT_EQ(of(Effect::massless_modes).treatment, Treatment::left_out);
  parameters_.scheme = Scheme::residual_flexibility;
  EXPECT_EQ(of(Effect::massless_modes).treatment, Treatment::simplified);
}

}  // namespace
}  // namespace tiprub::simulate
