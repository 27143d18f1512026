// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sector/sector_file.h"

#include <gmsh.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "cases/program/errors.h"
#include "tests/mesh/mesh_cases.h"
#include "tests/mesh/sector_geometry.h"

namespace tiprub::mesh {
namespace {

using test::case_text;
using test::sector_from;

std::filesystem::path scratch_file(const std::string& name) {
  return std::filesystem::path(::testing::TempDir()) / (std::to_string(getpid()) + "_" + name + ".msh");
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// A file as anybody reads it: through gmsh, by the names of its groups.
class ReadBack {
 public:
  explicit ReadBack(const MeshedSector& mesh) {
    const std::filesystem::path path = scratch_file("read_back");
    write_mesh(named_groups(mesh), path);
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::open(path.string());
    std::filesystem::remove(path);
    gmsh::vectorpair groups;
    gmsh::model::getPhysicalGroups(groups);
    for (const auto& [dimension, tag] : groups) {
      std::string name;
      gmsh::model::getPhysicalName(dimension, tag, name);
      groups_[name] = {dimension, tag};
    }
  }
  ReadBack(const ReadBack&) = delete;
  ReadBack& operator=(const ReadBack&) = delete;
  ~ReadBack() { gmsh::finalize(); }

  bool has(const std::string& name) const { return groups_.count(name) == 1; }
  std::size_t nodes(const std::string& name) const {
    std::vector<std::size_t> tags;
    std::vector<double> coordinates;
    gmsh::model::mesh::getNodesForPhysicalGroup(groups_.at(name).first, groups_.at(name).second, tags, coordinates);
    return tags.size();
  }
  /// All elements of a group, which must be of one type; their nodes in order.
  std::vector<std::size_t> element_nodes(const std::string& name, int type) const {
    std::vector<std::size_t> all;
    std::vector<int> entities;
    const auto [dimension, tag] = groups_.at(name);
    gmsh::model::getEntitiesForPhysicalGroup(dimension, tag, entities);
    for (int entity : entities) {
      std::vector<int> types;
      std::vector<std::vector<std::size_t>> elements, nodes;
      gmsh::model::mesh::getElements(types, elements, nodes, dimension, entity);
      EXPECT_EQ(types, std::vector<int>{type}) << name;
      all.insert(all.end(), nodes[0].begin(), nodes[0].end());
    }
    return all;
  }

 private:
  std::map<std::string, std::pair<int, int>> groups_;
};

TEST(SectorFile, HoldsEveryGroupWithItsNodes) {
  const MeshedSector mesh = sector_from(case_text("fast_impeller"));
  const ReadBack file(mesh);
  EXPECT_EQ(file.nodes("sector"), mesh.nodes.size());
  EXPECT_EQ(file.nodes("cyclic_low"), test::cyclic_pairs(mesh).size());
  EXPECT_EQ(file.nodes("cyclic_high"), test::cyclic_pairs(mesh).size());
  EXPECT_EQ(file.nodes("contact"), mesh.contact.size());
  for (const char* name : {"clamped", "hub", "blade_tip", "splitter_tip", "disc", "main_blade", "splitter"})
    EXPECT_TRUE(file.has(name)) << name;
}

TEST(SectorFile, EveryCellIsInTheSectorAndInOnePart) {
  const MeshedSector mesh = sector_from(case_text("fast_impeller"));
  const ReadBack file(mesh);
  std::size_t parts = 0;
  for (const char* name : {"disc", "main_blade", "splitter"}) parts += file.element_nodes(name, 17).size();
  EXPECT_EQ(parts, 20 * mesh.cells.size());
  EXPECT_EQ(file.element_nodes("sector", 17).size(), 20 * mesh.cells.size());
  EXPECT_EQ(file.element_nodes("clamped", 16).size() % 8, 0u);
}

TEST(SectorFile, ContactIsDirectedFromLeadingToTrailingEdge) {
  const MeshedSector mesh = sector_from(case_text("fast_impeller"));
  const std::vector<std::size_t> lines = ReadBack(mesh).element_nodes("contact", 1);
  ASSERT_EQ(lines.size(), 2 * (mesh.contact.size() - 1));
  for (std::size_t n = 0; n + 1 < mesh.contact.size(); ++n) {
    EXPECT_EQ(lines[2 * n], mesh.contact[n] + 1);
    EXPECT_EQ(lines[2 * n + 1], mesh.contact[n + 1] + 1);
  }
}

TEST(SectorFile, FullQuadraticCellsHaveTheirOwnTypes) {
  const MeshedSector mesh = sector_from(test::annular_plate(2, "hex27"));
  const ReadBack file(mesh);
  EXPECT_EQ(file.element_nodes("sector", 12).size(), 27 * mesh.cells.size());
  EXPECT_EQ(file.element_nodes("cyclic_low", 10).size(), 9u);
}

TEST(SectorFile, ABareDiscHasItsContactOnTheRim) {
  const ReadBack file(sector_from(test::annular_plate(2)));
  EXPECT_EQ(file.nodes("contact"), 3u);
  EXPECT_FALSE(file.has("blade_tip"));
}

TEST(SectorFile, SameInputSameBytes) {
  const std::filesystem::path first = scratch_file("first"), second = scratch_file("second");
  write_mesh(named_groups(sector_from(case_text("fast_impeller"))), first);
  write_mesh(named_groups(sector_from(case_text("fast_impeller"))), second);
  EXPECT_EQ(bytes_of(first), bytes_of(second));
  EXPECT_GT(bytes_of(first).size(), 0u);
  std::filesystem::remove(first);
  std::filesystem::remove(second);
}

TEST(SectorFile, AFileThatCannotBeWrittenIsAnError) {
  EXPECT_THROW(write_mesh(named_groups(sector_from(test::annular_plate(1))), "/no/such/folder/sector.msh"), RunError);
}

}  // namespace
}  // namespace tiprub::mesh
