// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/response_file.h"
#include "cases/program/errors.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <vector>

#include "reduce/model/hdf5_file.h"
#include "simulate/response/response_groups.h"
#include "tests/cases/complaint.h"
#include "tests/cases/full_disk.h"
#include "tests/simulate/written_response.h"

namespace tiprub::simulate {
namespace {

SpeedResponse settled_speed() {
  SpeedResponse speed;
  speed.speed = 100, speed.motion = MotionClass::subharmonic;
  speed.steps_per_revolution = 40, speed.samples_per_revolution = 4, speed.recorded_revolutions = 2;
  speed.clearance = Eigen::Vector3d(1e-4, 2e-4, 3e-4);
  speed.displacement = Eigen::MatrixXd::Random(8, 2 * 3 * 3);
  speed.contact_force = Eigen::MatrixXd::Random(8, 2 * 3);
  speed.contact_count.setConstant(6, 20, 7);
  speed.contact_steps = 123456789012;
  speed.snapshot = RotorSnapshot{5, 12.5, {Eigen::VectorXcd::Random(4), Eigen::VectorXcd::Random(7)}};
  speed.cycle = RotorCycle{4, {Eigen::MatrixXcd::Random(4, 4), Eigen::MatrixXcd::Random(7, 4)}};
  speed.audit.orbit = {OrbitReport::Outcome::marched, 4, 25, 1e-3, 1.1, 0.01, 2};
  speed.budget.resize(3);
  speed.budget[0].samples_per_revolution = speed.budget[1].samples_per_revolution = 6;
  speed.budget[0].cycle = RotorCycle{0, {Eigen::MatrixXcd::Random(4, 3), Eigen::MatrixXcd::Random(7, 3)}};
  speed.budget[1].model_digest = "of another model";
  speed.budget[1].cycle = RotorCycle{0, {Eigen::MatrixXcd::Random(5, 2), Eigen::MatrixXcd::Random(9, 2)}};
  return speed;
}

Response two_speeds() {
  Response response{.scene = {}, .key = "abc", .speeds = {settled_speed(), {}}};
  SimulatedScene& scene = response.scene;
  scene.sector_count = 4, scene.independent_sectors = 2, scene.lobes = 2, scene.largest_distortion = 7;
  scene.nodal_diameters = {0, 2};
  scene.casing_angle = scene.casing_distortion = Eigen::VectorXd::LinSpaced(5, 0, 6.28);
  scene.damping = {.by_family = {0.002, 0.004}, .beyond = 0.02};
  scene.clearance = Eigen::VectorXd::Constant(3, 1e-4), scene.clearance_state = ClearanceState::cold;
  response.speeds[1].speed = 200, response.speeds[1].failure = "why";
  response.frequencies = {Eigen::VectorXd::LinSpaced(5, 0, 200), {}};
  for (int modes : {3, 4, 5}) response.frequencies.by_nodal_diameter.emplace_back(Eigen::MatrixXd::Random(5, modes));
  return response;
}

class ResponseFile : public ::testing::Test {
 protected:
  ~ResponseFile() override { std::filesystem::remove(path_); }

  Response written_and_read(const Response& response) const {
    write_response(response, path_, "test");
    return read_response(path_);
  }

  const std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("tiprub-response-" + std::to_string(getpid()) + ".h5");
};

TEST_F(ResponseFile, GivesBackTheScene) {
  Response response = two_speeds();
  response.scene.node_distortion = Eigen::MatrixXd::Random(5, 3),
  response.scene.node_crest = Eigen::Vector3d(1, 2, 3);
  const Response back = written_and_read(response);
  EXPECT_EQ(back.key, "abc");
  EXPECT_EQ(back.scene.crest(), 7);
  EXPECT_EQ(back.scene.nodal_diameters, response.scene.nodal_diameters);
  EXPECT_EQ(back.scene.clearance, response.scene.clearance);
  EXPECT_EQ(back.frequencies.speed, response.frequencies.speed);
  EXPECT_EQ(back.frequencies.by_nodal_diameter, response.frequencies.by_nodal_diameter);
  EXPECT_EQ(back.scene.node_distortion, response.scene.node_distortion);
  EXPECT_EQ(back.scene.node_crest, response.scene.node_crest);
}

TEST_F(ResponseFile, GivesBackTheDamping) {
  Response response = two_speeds();
  response.frequencies.damping_ratio = {Eigen::MatrixXd::Constant(5, 3, 0.002), Eigen::MatrixXd::Constant(5, 4, 0.02),
                                        Eigen::MatrixXd::Constant(5, 5, 0.004)};
  Response back = written_and_read(response);
  EXPECT_EQ(back.scene.damping.by_family, (std::vector<double>{0.002, 0.004}));
  EXPECT_EQ(back.scene.damping.beyond, 0.02);
  EXPECT_EQ(back.frequencies.damping_ratio, response.frequencies.damping_ratio);
  response.scene.damping = {.by_frequency = {{1000, 0.002}, {3000, 0.006}}, .beyond = 0.1};
  back = written_and_read(response);
  EXPECT_TRUE(back.scene.damping.by_family.empty());
  EXPECT_EQ(back.scene.damping.by_frequency, response.scene.damping.by_frequency);
  EXPECT_TRUE(back.scene.damping.by_mode.empty());
  response.scene.damping.by_mode = {{2, 0, 0.001}, {0, 3, 0.004}};
  EXPECT_EQ(written_and_read(response).scene.damping.by_mode, response.scene.damping.by_mode);
}

TEST_F(ResponseFile, GivesBackWhatTheSceneChose) {
  Response response = two_speeds();
  response.scene.scheme = Scheme::central_differences;
  response.scene.contact = ContactRule::paper;
  response.scene.effects = {{Effect::friction, Treatment::left_out, "along the normal alone"},
                            {Effect::blade_clearance, Treatment::modelled, "", 1e-4}};
  response.speeds[0].audit.halving_failure = "too many steps";
  response.speeds[0].other_starts = {{Start::whole_wheel, "", 1e-4, {{1, 2, 4}}, MotionClass::periodic, 1, 0}};
  const Response back = written_and_read(response);
  EXPECT_EQ(back.scene.scheme, Scheme::central_differences);
  EXPECT_EQ(back.scene.contact, ContactRule::paper);
  EXPECT_EQ(back.scene.effects, response.scene.effects);
  EXPECT_EQ(back.scene.clearance_state, ClearanceState::cold);
  EXPECT_EQ(back.speeds[0].audit.halving_failure, "too many steps");
  EXPECT_EQ(back.speeds[0].other_starts.at(0).start, Start::whole_wheel);
  EXPECT_EQ(back.speeds[0].other_starts.at(0).blades, (BladeExcursions{1, 2, 4}));
}

TEST_F(ResponseFile, SaysThatTheDiskIsFull) {
  write_response(two_speeds(), path_, "test");
  const auto size = static_cast<rlim_t>(std::filesystem::file_size(path_));
  constexpr int cuts = 20;
  for (int cut = 0; cut < cuts; ++cut) {
    std::filesystem::remove(path_);
    const FullDisk disk(cut * size / cuts);
    EXPECT_THROW(write_response(two_speeds(), path_, "test"), RunError) << cut;
  }
}

/// A reader refuses what isn't finite: then all other speeds would be lost with it.
TEST(SpeedResponse, TellsWhetherItIsFinite) {
  const double nan = std::nan("");
  EXPECT_TRUE(is_finite(settled_speed()));
  for (const auto& spoil : std::vector<std::function<void(SpeedResponse&)>>{
           [&](SpeedResponse& s) { s.displacement(1, 1) = nan; },
           [&](SpeedResponse& s) { s.contact_force(0, 0) = nan; }, [&](SpeedResponse& s) { s.change_rate = nan; },
           [&](SpeedResponse& s) { s.audit.halving_difference = nan; },
           [&](SpeedResponse& s) { s.snapshot->displacement[0][2] = nan; },
           [&](SpeedResponse& s) { s.cycle->displacement[1](2, 2) = nan; }}) {
    SpeedResponse speed = settled_speed();
    spoil(speed);
    EXPECT_FALSE(is_finite(speed));
  }
}

TEST_F(ResponseFile, RefusesAByteThatChanged) {
  write_response(two_speeds(), path_, "test");
  const auto middle = static_cast<std::streamoff>(std::filesystem::file_size(path_) / 2);
  std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
  file.seekg(middle);
  const char byte = static_cast<char>(file.get() ^ 1);
  file.seekp(middle);
  file.put(byte);
  file.close();
  EXPECT_EQ(complaint<RunError>([&] { read_response(path_); }),
            path_.string() + ": was damaged after it was written (its seal is broken); run tiprub-simulate again");
}

TEST_F(ResponseFile, GivesBackASpeed) {
  const Response response = two_speeds(), back = written_and_read(response);
  const SpeedResponse& given = response.speeds[0];
  const SpeedResponse& speed = back.speeds.at(0);
  EXPECT_EQ(speed.clearance, given.clearance);
  EXPECT_EQ(speed.displacement, given.displacement);
  EXPECT_EQ(speed.contact_force, given.contact_force);
  EXPECT_EQ(speed.contact_count, given.contact_count);
  EXPECT_EQ(speed.contact_steps, given.contact_steps);
  EXPECT_EQ(speed.motion, MotionClass::subharmonic);
  ASSERT_TRUE(speed.snapshot && speed.cycle);
  EXPECT_EQ(speed.snapshot->sample, 5);
  EXPECT_EQ(speed.snapshot->force, 12.5);
  EXPECT_EQ(speed.snapshot->displacement, given.snapshot->displacement);
  EXPECT_EQ(speed.cycle->first_sample, 4);
  EXPECT_EQ(speed.cycle->displacement, given.cycle->displacement);
  EXPECT_EQ(speed.audit.orbit, given.audit.orbit);
  ASSERT_TRUE(speed.budget.size() == 3 && speed.budget[0].cycle && speed.budget[1].cycle && !speed.budget[2].cycle);
  EXPECT_EQ(speed.budget[0].samples_per_revolution, 6);
  EXPECT_EQ(speed.budget[0].cycle->displacement, given.budget[0].cycle->displacement);
  EXPECT_EQ(speed.budget[1].cycle->displacement, given.budget[1].cycle->displacement);
}

TEST_F(ResponseFile, GivesBackWhyASpeedFailed) {
  const Response back = written_and_read(two_speeds());
  EXPECT_EQ(back.speeds.at(1).failure, "why");
  EXPECT_FALSE(back.speeds[1].snapshot || back.speeds[1].cycle);
  EXPECT_EQ(back.speeds[1].audit.orbit.outcome, OrbitReport::Outcome::none);
}

OrbitBranch three_orbits() {
  OrbitBranch branch;
  branch.start = 150;
  branch.steps_per_revolution = 1200;
  branch.ends[0] = "end of the range";
  branch.ends[1] = "most steps";
  branch.speed = Eigen::Vector3d(100, 150, 140);
  branch.amplitude = Eigen::Vector3d(1e-4, 2e-4, 3e-4);
  branch.multiplier = Eigen::Vector3d(0.9, 0.99, 1.1);
  branch.multiplier_uncertainty = Eigen::Vector3d(0.01, 0.02, 0.03);
  branch.multiplier_angle = Eigen::Vector3d(0, 1, 3);
  branch.folds = Eigen::VectorXd::Constant(1, 151);
  return branch;
}

TEST_F(ResponseFile, GivesBackItsBranches) {
  Response given = two_speeds();
  given.branches = {three_orbits(), three_orbits()};
  given.branches[1].folds.resize(0);
  const Response back = written_and_read(given);
  ASSERT_EQ(back.branches.size(), 2u);
  const OrbitBranch &branch = back.branches[0], wanted = three_orbits();
  EXPECT_EQ(branch.start, wanted.start);
  EXPECT_EQ(branch.steps_per_revolution, wanted.steps_per_revolution);
  EXPECT_EQ(branch.ends[0], wanted.ends[0]);
  EXPECT_EQ(branch.ends[1], wanted.ends[1]);
  EXPECT_EQ(branch.speed, wanted.speed);
  EXPECT_EQ(branch.amplitude, wanted.amplitude);
  EXPECT_EQ(branch.multiplier, wanted.multiplier);
  EXPECT_EQ(branch.multiplier_uncertainty, wanted.multiplier_uncertainty);
  EXPECT_EQ(branch.multiplier_angle, wanted.multiplier_angle);
  EXPECT_EQ(branch.folds, wanted.folds);
  EXPECT_TRUE(branch.attracts(1));
  EXPECT_FALSE(branch.attracts(2));
  EXPECT_EQ(back.branches[1].folds.size(), 0);
}

TEST_F(ResponseFile, RefusesABranchThatDoesNotFitTogether) {
  Response given = two_speeds();
  given.branches = {three_orbits()};
  given.branches[0].amplitude.resize(2);
  EXPECT_THROW(written_and_read(given), RunError);
  given.branches = {three_orbits()};
  given.branches[0].multiplier[1] = -1;
  EXPECT_THROW(written_and_read(given), RunError);
}

TEST_F(ResponseFile, SaysWhatToDoWithAnOlderOne) {
  { Hdf5File::create(path_).set_schema("tiprub-response", 1, "test"); }
  for (const auto& read : {+[](const std::filesystem::path& path) { read_response(path); },
                           +[](const std::filesystem::path& path) { read_response_key(path); }}) {
    const std::string said = complaint<RunError>([&] { read(path_); });
    EXPECT_NE(said.find("version 1, made by an older tiprub-simulate; run it again"), std::string::npos) << said;
  }
}

/// A response that is wrong in one place, and what the reader says of it.
struct Wrong {
  const char* what;
  std::function<void(Response&)> spoil;
  const char* message;
};

void damp(Response& response, const ModeDamping& mode) {
  response.scene.damping.by_mode = {mode};
}

const std::vector<Wrong> wrong_scenes = {
    {"no casing", [](Response& r) { r.scene.casing_angle.resize(0), r.scene.casing_distortion.resize(0); },
     "/casing/angle: has shape 0, must have at least 1 angles"},
    {"no distortion", [](Response& r) { r.scene.casing_distortion.resize(0); },
     "/casing/distortion: has shape 0, must have 5 angles (as /casing/angle)"},
    {"more angles", [](Response& r) { r.scene.casing_angle = Eigen::VectorXd::LinSpaced(9, 0, 6.28); },
     "/casing/distortion: has shape 5, must have 9 angles"},
    {"one angle", [](Response& r) { r.scene.casing_angle = r.scene.casing_distortion = Eigen::VectorXd::Zero(1); },
     "/casing/angle must increase within 0 .. 2 pi, 2 angles at least"},
    {"angles that return", [](Response& r) { r.scene.casing_angle[2] = 0; }, "/casing/angle must increase"},
    {"angles in degrees", [](Response& r) { r.scene.casing_angle *= 57; }, "/casing/angle must increase within 0 .."},
    {"no lobes", [](Response& r) { r.scene.lobes = 0; }, "lobes must be at least 1"},
    {"a clearance neither cold nor running",
     [](Response& r) { r.scene.clearance_state = static_cast<ClearanceState>(9); },
     "/casing: attribute clearance_state is \"\", must be \"cold\", \"running\" or \"at_speed\""},
    {"a damping above critical", [](Response& r) { r.scene.damping.by_family[1] = 2; },
     "/damping/ratio_by_family must be within 0 .. 1"},
    {"a mode damped above critical",
     [](Response& r) {
       damp(r, {1, 0, 2});
     },
     "/damping/ratio_of_mode must be within 0 .. 1"},
    {"a negative family",
     [](Response& r) {
       damp(r, {1, -1, 0.1});
     },
     "/damping/family_of_mode must be within 0 .. 1e6"},
    {"a negative damping beyond", [](Response& r) { r.scene.damping.beyond = -1; },
     "/damping: attribute ratio_beyond must be within 0 .. 1"},
    {"damping at frequencies that fall",
     [](Response& r) {
       r.scene.damping.by_frequency = {{2, 0.1}, {1, 0.1}};
     },
     "/damping/frequency must increase"},
    {"damping of other modes",
     [](Response& r) { r.frequencies.damping_ratio.assign(3, Eigen::MatrixXd::Constant(5, 2, 0.1)); },
     "/frequencies/damping_ratio/0: has shape 5 x 2, must have 5 speeds of the frequencies"},
    {"a scheme without a name", [](Response& r) { r.scene.scheme = static_cast<Scheme>(9); },
     "attribute scheme is \"\", must be \"trigonometric\", "},
    {"a contact law without a name", [](Response& r) { r.scene.contact = static_cast<ContactRule>(9); },
     "attribute contact is \"\", must be \"complementarity\" or \"paper\""},
    {"no contact node", [](Response& r) { r.scene.clearance.resize(0); }, "/casing/clearance: has shape 0"},
    {"no sectors", [](Response& r) { r.scene.sector_count = 0; }, "independent_sectors must divide sector_count"},
    {"no nodal diameter", [](Response& r) { r.scene.nodal_diameters.clear(), r.speeds.clear(); },
     "/nodal_diameters: has shape 0"},
    {"a nodal diameter beyond N/2",
     [](Response& r) {
       r.scene.nodal_diameters = {0, 3};
     },
     "/nodal_diameters must increase within 0 .. sector_count/2"},
    {"a band below zero", [](Response& r) { r.scene.resolved_frequency = -1; }, "resolved_frequency must be above 0"},
    {"frequencies at other speeds", [](Response& r) { r.frequencies.speed.conservativeResize(4); },
     "/frequencies/nodal_diameter/0: has shape 5 x 3, must have 4 speeds of the frequencies"},
    {"a nodal diameter without frequencies", [](Response& r) { r.frequencies.by_nodal_diameter.pop_back(); },
     "/frequencies/nodal_diameter/2: is missing"},
    {"no modes", [](Response& r) { r.frequencies.by_nodal_diameter[1].resize(5, 0); },
     "/frequencies/nodal_diameter/1: has shape 5 x 0"},
    {"frequencies at speeds that fall", [](Response& r) { r.frequencies.speed.reverseInPlace(); },
     "/frequencies/speed must increase"},
};

SpeedResponse& first(Response& response) {
  return response.speeds.front();
}

const std::vector<Wrong> wrong_speeds = {
    {"a speed of zero", [](Response& r) { first(r).speed = 0; }, "/speed/00000: attribute speed is 0"},
    {"two equal speeds", [](Response& r) { first(r).speed = 200; },
     "/speed/00001: attribute speed must be above that of the group before it"},
    {"one sample a revolution, which says nothing of a motion",
     [](Response& r) { first(r).samples_per_revolution = 1; },
     "attribute samples_per_revolution is 1, must be at least 2"},
    {"fewer than no steps", [](Response& r) { first(r).contact_steps = -3; },
     "attribute contact_steps is -3, must be at least 0"},
    {"more steps than are counted", [](Response& r) { first(r).leftover_steps = 10000000000000000; },
     "attribute leftover_steps is 1e+16"},
    {"a negative amplitude", [](Response& r) { first(r).amplitude = -1; }, "attribute amplitude is -1"},
    {"a node that there isn't", [](Response& r) { first(r).chatter_node = 3; },
     "attribute chatter_node is 3, must be one of the 3 contact nodes"},
    {"other samples than it says", [](Response& r) { first(r).recorded_revolutions = 3; },
     "/speed/00000/displacement: has shape 8 x 2 x 3 x 3, must have 12 samples (samples_per_revolution x "
     "recorded_revolutions) x 2 sectors (independent_sectors) x 3 contact nodes (as /casing/clearance) x 3 "
     "components"},
    {"other nodes", [](Response& r) { first(r).clearance.conservativeResize(2); },
     "/speed/00000/clearance: has shape 2, must have 3 contact nodes"},
    {"no areas", [](Response& r) { first(r).contact_count.resize(6, 0); },
     "/speed/00000/contact_count: has shape 2 x 3 x 0"},
    {"other areas than the speed before",
     [](Response& r) {
       r.speeds[1] = first(r), r.speeds[1].speed = 200;
       r.speeds[1].contact_count.setConstant(6, 21, 7);
     },
     "/speed/00001/contact_count: has shape 2 x 3 x 21, must have 2 sectors (independent_sectors) x 3 contact nodes "
     "(as /casing/clearance) x 20 casing areas (as /speed/00000/contact_count)"},
    {"counts below zero", [](Response& r) { first(r).contact_count(2, 3) = -1; },
     "contact_count: must be within 0 .."},
    {"counts above the steps", [](Response& r) { first(r).contact_count(2, 3) = 81; },
     "contact_count: must be within 0 .."},
    {"a snapshot of another instant", [](Response& r) { first(r).snapshot->sample = 8; },
     "sample 8 is not one of the 8"},
    {"a cycle of other dofs", [](Response& r) { first(r).cycle->displacement[1].conservativeResize(6, 4); },
     "/speed/00000/cycle/2: has shape 6 x 4, must have 7 dofs of nodal diameter 2 (as /speed/00000/snapshot/2)"},
    {"a cycle that ends elsewhere", [](Response& r) { first(r).cycle->first_sample = 3; },
     "/speed/00000/cycle/0: has shape 4 x 4, must have 4 dofs of nodal diameter 0 (as /speed/00000/snapshot/0) x 5 "
     "samples"},
    {"a cycle from before the recording", [](Response& r) { first(r).cycle->first_sample = -1; },
     "first_sample -1 is not one of the 8"},
    {"a varied peak's cycle of other dofs",
     [](Response& r) { first(r).budget[0].cycle->displacement[1].conservativeResize(6, 3); },
     "/speed/00000/budget/0/cycle/2: has shape 6 x 3, must have"},
};

TEST_F(ResponseFile, SaysWhatDoesNotFit) {
  for (const std::vector<Wrong>* list : {&wrong_scenes, &wrong_speeds})
    for (const Wrong& wrong : *list) {
      Response response = two_speeds();
      wrong.spoil(response);
      const std::string said = complaint<RunError>([&] { written_and_read(response); });
      EXPECT_NE(said.find(wrong.message), std::string::npos) << wrong.what << ": " << said;
    }
}

/// A dataset may name any size, and take no place in the file where nothing was written.
TEST_F(ResponseFile, AsksForMemoryBeforeItReads) {
  {
    Hdf5File file = Hdf5File::create(path_);
    file.set_schema("tiprub-response", 4, "test");
    for (const char* name : {"key", "model_digest", "provenance", "scope"})
      file.set_attribute("/", name, std::string());
    for (const char* name : {"sector_count", "independent_sectors"}) file.set_attribute("/", name, 1);
    file.write_text("/casing/table", "");
    file.write("/nodal_diameters", Array<std::int32_t>{{1}, {0}}, "1");
    for (const char* name : {"/casing/angle", "/casing/distortion", "/casing/clearance"})
      file.write(name, Eigen::VectorXd(Eigen::Vector2d(0, 1)), "m");
    file.set_attribute("/casing", "lobes", 1);
    file.set_attribute("/casing", "clearance_state", "cold");
    file.make_slices("/speed/00000/displacement", {std::size_t{1} << 40, 1, 2, 3}, Hdf5File::Number::real, "m");
  }
  const std::string said = complaint<RunError>([&] { read_response(path_); });
  EXPECT_NE(said.find(": /speed/00000/displacement: takes more memory than there is"), std::string::npos) << said;
}

}  // namespace
}  // namespace tiprub::simulate
