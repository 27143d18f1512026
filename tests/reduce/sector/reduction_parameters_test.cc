// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/reduction_parameters.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "cases/program/errors.h"
#include "tests/cases/complaint.h"

namespace tiprub::reduce {
namespace {

ReductionParameters read_table(const std::string& keys, SectorInput input) {
  const auto path = std::filesystem::path(::testing::TempDir()) / "reduction_parameters.toml";
  std::ofstream(path) << "[reduce]\nspeed_max_rpm = 1e4\n" << keys;
  CaseFile file(path);
  CaseTable table = file.table("reduce");
  return read_reduction_parameters(table, input);
}

ReductionParameters read(const std::string& keys) {
  return read_table("young_modulus = 2e11\npoisson_ratio = 0.3\ndensity = 7800\n" + keys, SectorInput::mesh);
}

TEST(ReductionParameters, AccuracySetsTheSizeOfTheBasis) {
  const ReductionParameters usual = read(""), fine = read("accuracy = 0.005\n"), coarse = read("accuracy = 0.1\n");
  EXPECT_EQ(read("accuracy = 0.02\n").modes_at_speed, usual.modes_at_speed);
  EXPECT_EQ(fine.fixed_interface_modes, 2 * usual.fixed_interface_modes);
  EXPECT_EQ(fine.modes_at_speed, 2 * usual.modes_at_speed);
  EXPECT_DOUBLE_EQ(fine.frequency_tolerance, usual.frequency_tolerance / 4);
  EXPECT_EQ(coarse.modes_at_speed, usual.modes_at_speed);  // fewer save next to nothing
  EXPECT_DOUBLE_EQ(coarse.frequency_tolerance, 5 * usual.frequency_tolerance);
  EXPECT_LE(read("accuracy = 1e-5\n").fixed_interface_modes, 500);
  EXPECT_EQ(read("accuracy = 0.005\nmodes_at_speed = 50\n").modes_at_speed, 50);  // a key of its own goes first
}

/// Symptom: a sector by its matrices required a young_modulus, which had no effect.
TEST(ReductionParameters, NeedNoMaterialBesideMatrices) {
  EXPECT_NO_THROW(read_table("", SectorInput::matrices));
  EXPECT_THROW(read_table("", SectorInput::mesh), InputError);
}

/// Symptom: prestress, mesh_error and the material of a sector by its matrices were taken without a word.
TEST(ReductionParameters, RefuseBesideMatricesWhatHasNoEffectThere) {
  for (const std::string line :
       {"young_modulus = 2e11", "poisson_ratio = 0.3", "density = 7800", "prestress = \"linear\"",
        "spin_softening = true", "polynomial_speeds = 0", "polynomial_tolerance = 1e-4", "refine = 0",
        "element_order = 2", "mesh_error = true", "contact = \"segments\""}) {
    const std::string said = complaint<InputError>([&] { read_table(line + "\n", SectorInput::matrices); });
    const std::string key = line.substr(0, line.find(' '));
    EXPECT_NE(said.find("reduction_parameters.toml:3:"), std::string::npos) << line << ": " << said;
    EXPECT_NE(said.find("[reduce] " + key), std::string::npos) << line << ": " << said;
    EXPECT_NE(said.find("--matrices"), std::string::npos) << line << ": " << said;
  }
  EXPECT_NO_THROW(read_table("contact = \"points\"\n", SectorInput::matrices));
}

TEST(ReductionParameters, LeaveTheKindOfContactToTheMesh) {
  EXPECT_EQ(read("").contact, std::nullopt);
  EXPECT_EQ(read("contact = \"automatic\"\n").contact, std::nullopt);
  EXPECT_EQ(read("contact = \"points\"\n").contact, ContactKind::points);
  EXPECT_EQ(read("contact = \"segments\"\n").contact, ContactKind::segments);
}

}  // namespace
}  // namespace tiprub::reduce
