// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/simulated_scene.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "simulate/scene/casing.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate::run_key_test {
namespace {

const std::string range = "speed_min_rpm = 9000\nspeed_max_rpm = 12000\nspeed_count = 40\n";
const std::string list = "speeds_rpm = [9000, 12000]\n";
const std::string casing = "amplitude = 2e-4\nclearance = [[0.0, 1.5e-4], [1.0, 1.2e-4]]\n";

struct ReadCase {
  SweepSettings settings;
  SimulateParameters parameters;
};

ReadCase read(const std::string& casing_keys, const std::string& simulate_keys) {
  const auto path = std::filesystem::temp_directory_path() / ("tiprub-key-" + std::to_string(getpid()) + ".toml");
  std::ofstream(path) << "[casing]\n" << casing_keys << "[simulate]\n" << simulate_keys;
  CaseFile file(path);
  CaseTable casing_table = file.table("casing"), simulate_table = file.table("simulate");
  ReadCase read;
  read_casing(casing_table);
  read.parameters = read_simulate_parameters(simulate_table);
  read.settings = {casing_table.settings(), simulate_table.settings()};
  std::filesystem::remove(path);
  return read;
}

std::string key_of(const ReadCase& read, const ReducedModel& model = testing::synthetic_wheel({})) {
  return run_key(model, read.settings, read.parameters, "test");
}

bool is_exempt(const std::string& key) {
  return std::any_of(exempt_keys().begin(), exempt_keys().end(),
                     [&](const ExemptKey& exempt) { return key == exempt.key; });
}

TEST(RunKey, CountsAccuracyByTheTolerancesThatItSets) {
  const std::string usual = key_of(read(casing, range)), fine = key_of(read(casing, range + "accuracy = 0.005\n"));
  EXPECT_EQ(key_of(read(casing, range + "accuracy = 0.02\n")), usual);
  EXPECT_NE(fine, usual);
  EXPECT_EQ(key_of(read(casing, range + "step_tolerance = 1.25e-3\nsettle_tolerance = 2.5e-5\n")), fine);
  EXPECT_EQ(key_of(read(casing, range + "accuracy = 0.005\nstep_tolerance = 5e-3\nsettle_tolerance = 1e-4\n" +
                                    "steps_per_period = 200\n")),
            usual);  // keys of their own go first
}

/// Whatever the readers ask for: a key that is new to them is looked at here as well.
TEST(RunKey, ChangesWithEveryResolvedSettingThatIsNotExempt) {
  for (const std::string& speeds : {range, list}) {
    const ReadCase original = read(casing, speeds);
    const std::string key = key_of(original);
    ASSERT_GT(original.settings.casing.size(), 5u);
    ASSERT_GT(original.settings.simulate.size(), 15u);
    for (CaseSettings SweepSettings::*table : {&SweepSettings::casing, &SweepSettings::simulate})
      for (std::size_t i = 0; i < (original.settings.*table).size(); ++i) {
        ReadCase changed = original;
        auto& [name, value] = (changed.settings.*table)[i];
        value += "1";
        EXPECT_EQ(key_of(changed) == key, is_exempt(name)) << name;
      }
  }
}

TEST(RunKey, ComesFromTheCaseAsItIsRead) {
  const std::string key = key_of(read(casing, range));
  EXPECT_EQ(key_of(read("# a remark\n" + casing, list)), key);
  EXPECT_EQ(key_of(read(casing, range + "damping_ratio = 5e-3 # the default\n")), key);
  EXPECT_EQ(key_of(read(casing, range + "threads = 3\nexamine = \"none\"\n")), key);
  EXPECT_EQ(key_of(read(casing, range + "when_symmetry_breaks = \"full_run\"\n")), key);
  EXPECT_EQ(key_of(read(casing, range + "branches = \"critical_speeds\"\nbranch_steps = 9\n")), key);
  for (const char* change : {"damping_ratio = 6e-3\n", "step_tolerance = 1e-3\n", "scheme = \"moreau_jean\"\n",
                             "contact = \"paper\"\nscheme = \"central_differences\"\n", "modes = 12\n",
                             "nodal_diameters = \"all\"\n", "steady_state = \"orbit\"\n"})
    EXPECT_NE(key_of(read(casing, range + change)), key) << change;
  for (const char* change : {"lobes = 3\n", "crest_angle_deg = 1\n", "clearance_state = \"cold\"\n",
                             "ramp_revolutions = 2\n", "shape = \"bumps\"\n"})
    EXPECT_NE(key_of(read(casing + change, range)), key) << change;
}

TEST(RunKey, CountsTheSpeedsOfASweepThatCarriesItsState) {
  EXPECT_NE(key_of(read(casing, range + "sweep = \"up\"\n")), key_of(read(casing, list + "sweep = \"up\"\n")));
}

TEST(RunKey, CountsTheModelsNumbers) {
  const ReadCase original = read(casing, range);
  const std::string key = key_of(original);
  ReducedModel model = testing::synthetic_wheel({});
  model.provenance = "another remark";
  EXPECT_EQ(key_of(original, model), key);
  model.modes_at_speed = 2;
  EXPECT_NE(key_of(original, model), key);
  model = testing::synthetic_wheel({});
  model.nodal_diameters[1].K[1](0, 0) *= 1 + 1e-15;
  EXPECT_NE(key_of(original, model), key);
}

/// A name in the list that no reader knows would be a slip.
TEST(RunKey, ExemptsOnlyKeysThatExistAndSaysWhy) {
  std::set<std::string> known;
  for (const std::string& speeds : {range, list})
    for (const auto& [key, value] : read(casing, speeds).settings.simulate) known.insert(key);
  for (const ExemptKey& exempt : exempt_keys()) {
    EXPECT_EQ(known.count(exempt.key), 1u) << exempt.key;
    EXPECT_FALSE(std::string(exempt.reason).empty());
  }
}

}  // namespace
}  // namespace tiprub::simulate::run_key_test
