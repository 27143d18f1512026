// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/sector_geometry.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "cases/program/errors.h"
#include "mesh/cells/cell_kind.h"
#include "postprocess/fields/cell_stress.h"
#include "postprocess/fields/field_peak.h"

namespace tiprub::postprocess::blade_place_test {
namespace {

constexpr double length = 0.1, height = 0.05, hub = 0.1;  // [m] axial chord, blade height, hub radius
constexpr int half_cells = 8;                             // half bricks along and up a blade

struct Made {
  SectorFields sector;
  std::map<std::array<int, 3>, int> node;  ///< by half bricks along z, around, and up from the hub
};

void add_bricks(Made& made, const std::string& part, int from, int to, int below, int above) {
  for (int along = from; along < to; along += 2)
    for (int up = below; up < above; up += 2) {
      Eigen::VectorXi cell(20);
      for (int k = 0; k < 20; ++k) {
        const Eigen::Vector3i corner = cell_kind(20).places[static_cast<std::size_t>(k)].cast<int>();
        const std::array<int, 3> at = {along + 1 + corner[0], 1 + corner[1], up + 1 + corner[2]};
        cell[k] = made.node.try_emplace(at, static_cast<int>(made.node.size())).first->second;
      }
      made.sector.parts[part].push_back(static_cast<int>(made.sector.cells.cols()));
      made.sector.cells.conservativeResize(20, made.sector.cells.cols() + 1);
      made.sector.cells.rightCols(1) = cell;
    }
}

/// A straight blade on a straight hub, and a splitter from half of the length on. The hub's underside is clamped.
Made bladed_hub() {
  Made made;
  add_bricks(made, "disc", 0, half_cells, -4, 0);
  add_bricks(made, "main_blade", 0, half_cells, 0, half_cells);
  SectorFields& sector = made.sector;
  for (const char* name : {"clamped", "contact", "contact_line", "cyclic_low", "cyclic_high"}) sector.node_sets[name];
  sector.nodes.resize(3, static_cast<Eigen::Index>(made.node.size()));
  for (const auto& [at, node] : made.node) {
    const double r = hub + height * at[2] / half_cells;
    sector.nodes.col(node) << r, 1e-3 * at[1], length * at[0] / half_cells;
    if (at[2] == -4) sector.node_sets["clamped"].push_back(node);
  }
  for (int k = 0; k <= half_cells; ++k) {
    const int node = made.node.at({k, 0, half_cells});
    sector.node_sets["contact_line"].push_back(node);
    if (k % 4 == 0) sector.node_sets["contact"].push_back(node);
  }
  return made;
}

TEST(BladePlaces, NamesTheEndsOfABlade) {
  const Made made = bladed_hub();
  const BladePlaces places(made.sector);
  const auto words = [&](int along, int up) { return places.words(made.node.at({along, 0, up})); };
  EXPECT_EQ(words(0, 0), "root of the main blade at the leading edge");
  EXPECT_EQ(words(half_cells, 0), "root of the main blade at the trailing edge");
  EXPECT_EQ(words(4, 4), "main blade at mid-span, at 50 % of its length");
  EXPECT_EQ(words(0, half_cells), "main blade near the tip, at the leading edge");
  EXPECT_EQ(words(2, 2), "main blade near the root, at 25 % of its length");
  EXPECT_EQ(words(4, -2), "disc");
  EXPECT_EQ(places.part(made.node.at({4, 0, 4})), "main_blade");
}

/// A splitter has no tip line of its own, and another length.
TEST(BladePlaces, MeasuresASplitterByItsOwnLength) {
  Made made = bladed_hub();
  std::vector<int>&main = made.sector.parts["main_blade"], &splitter = made.sector.parts["splitter"];
  // The rear half of the blade stands for one: the same meridional places.
  for (const int cell : main)
    if (made.sector.nodes.row(2)(made.sector.cells.col(cell)).minCoeff() >= 0.5 * length - 1e-9)
      splitter.push_back(cell);
  std::erase_if(main, [&](int cell) { return std::find(splitter.begin(), splitter.end(), cell) != splitter.end(); });
  const BladePlaces places(made.sector);
  const std::string at = places.words(made.node.at({6, 0, 4}));
  EXPECT_NE(at.find("at mid-span"), std::string::npos) << at;
  EXPECT_EQ(at.find("splitter"), 0U) << at;
}

TEST(BladePlaces, HasOnlyThePartWithoutADisc) {
  Made made = bladed_hub();
  made.sector.parts = {{"ring", {0, 1}}};
  EXPECT_EQ(BladePlaces(made.sector).words(made.sector.cells(0, 0)), "ring");
  made.sector.parts.clear();
  EXPECT_EQ(BladePlaces(made.sector).words(0), "");
}

TEST(StressZones, AreNearTheTipLineAndTheClampsEdge) {
  const Made made = bladed_hub();
  const StressZones zones = stress_zones(made.sector, 0);
  EXPECT_NEAR(tip_length(made.sector), length, 1e-12);
  EXPECT_NEAR(zones.width, 0.05 * length, 1e-12);
  const auto zone = [&](int along, int up) {
    return zones.at_node[static_cast<std::size_t>(made.node.at({along, 0, up}))];
  };
  EXPECT_EQ(zone(3, half_cells), StressZone::tip_patch);  // between contact nodes too
  EXPECT_EQ(zone(4, half_cells - 1), StressZone::body);   // a half brick is 6.25 mm
  EXPECT_EQ(zone(4, 0), StressZone::body);
  EXPECT_EQ(zone(0, -4), StressZone::clamp_rim);
  EXPECT_EQ(zone(half_cells, -4), StressZone::clamp_rim);
  EXPECT_EQ(zone(0, half_cells), StressZone::tip_patch);
  EXPECT_EQ(zone(half_cells, half_cells), StressZone::tip_patch);
  const StressZones wider = stress_zones(made.sector, 0.01);
  EXPECT_EQ(wider.at_node[static_cast<std::size_t>(made.node.at({4, 0, half_cells - 1}))], StressZone::tip_patch);
  EXPECT_THROW(stress_zones(made.sector, 1), InputError);
}

/// The nodes next to the centres of segments end before the edges of the blade.
TEST(StressZones, ReachTheEdgesOfABladeInContactBySegments) {
  Made made = bladed_hub();
  made.sector.node_sets["contact"] = {made.node.at({2, 0, half_cells}),
                                      made.node.at({half_cells - 2, 0, half_cells})};
  const StressZones zones = stress_zones(made.sector, 0);
  for (const int along : {0, half_cells})
    EXPECT_EQ(zones.at_node[static_cast<std::size_t>(made.node.at({along, 0, half_cells}))], StressZone::tip_patch);
}

/// Between the end of the blade's tip line and the beginning of the splitter's there is none.
TEST(StressZones, AreNotBetweenABladeAndItsSplitter) {
  Made made = bladed_hub();
  const int on_hub = made.node.at({4, 0, 0}), beside = made.node.at({6, 0, 0});
  made.sector.node_sets["contact_splitter"] = {on_hub, beside};
  const StressZones zones = stress_zones(made.sector, 0);
  const auto zone = [&](int node) { return zones.at_node[static_cast<std::size_t>(node)]; };
  EXPECT_EQ(zone(on_hub), StressZone::tip_patch);
  EXPECT_EQ(zone(beside), StressZone::tip_patch);
  EXPECT_EQ(zone(made.node.at({half_cells, 0, half_cells / 2})), StressZone::body);
}

}  // namespace
}  // namespace tiprub::postprocess::blade_place_test
