// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/mesh/mesh_cases.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "mesh/sector/sector_check.h"

namespace tiprub::mesh::test {

std::string case_text(const std::string& name) {
  std::ifstream file(std::string(TIPRUB_CASES) + "/" + name + "/case.toml");
  EXPECT_TRUE(file.good()) << name;
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string with(const std::string& text, const std::string& key, const std::string& value) {
  const std::size_t start = text.find("\n" + key + " = ");
  EXPECT_NE(start, std::string::npos) << key;
  const std::size_t end = text.find('\n', start + 1);
  return text.substr(0, start + 1) + key + " = " + value + text.substr(end);
}

std::string with_keys(const std::string& text, const std::string& keys) {
  const std::string table = "[mesh]\n";
  const std::size_t start = text.find(table);
  EXPECT_NE(start, std::string::npos);
  return std::string(text).insert(start + table.size(), keys);
}

std::string annular_plate(int elements_round, const std::string& element) {
  std::ostringstream text;
  text << "[mesh]\nfamily = \"bladed_disc\"\nblade = \"none\"\nblade_count = 6\nbore_radius = 0.1\n"
       << "rim_radius = 0.2\naxial_length = 0.001\nelements_along_chord = 1\n"
       << "elements_through_disc = " << (elements_round + 1) / 2 << "\nelements_between_blades = " << elements_round
       << "\nelement = \"" << element << "\"\n";
  return text.str();
}

std::string twisted_blades() {
  return "[mesh]\nfamily = \"bladed_disc\"\nblade_count = 12\nbore_radius = 0.04\nrim_radius = 0.1\n"
         "axial_length = 0.03\ntip_radius = 0.16\nstagger_root_deg = 15.0\nstagger_tip_deg = 45.0\n"
         "thickness_root = [[0.0, 0.002], [0.4, 0.004], [1.0, 0.002]]\nthickness_tip = [[0.0, 0.001]]\n"
         "elements_along_chord = 6\nelements_along_span = 6\n";
}

Wheel wheel_from(const std::string& case_text) {
  const std::filesystem::path path =
      std::filesystem::path(::testing::TempDir()) / ("tiprub_mesh_" + std::to_string(getpid()) + ".toml");
  std::ofstream(path) << case_text;
  const CaseFile file(path);
  std::filesystem::remove(path);
  CaseTable table = file.table("mesh");
  return read_wheel(table);
}

MeshedSector sector_from(const std::string& case_text) {
  return mesh_sector(wheel_from(case_text));
}

std::string complaint(const std::string& case_text) {
  try {
    const Wheel wheel = wheel_from(case_text);
    measure_sector(mesh_sector(wheel), wheel);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace tiprub::mesh::test
