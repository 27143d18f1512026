// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iomanip>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "mesh/import/import_check.h"
#include "mesh/import/periodic_cuts.h"
#include "mesh/import/sector_import.h"
#include "mesh/import/selection.h"
#include "tests/cases/complaint.h"

namespace tiprub::mesh {
namespace {

using Place = std::function<Eigen::Vector3d(double i, double j, double k)>;
using Counts = std::array<int, 3>;

/// Ends and middles of the edges of a brick in halves of its sides, in VTK's order.
constexpr int brick[20][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
                              {0, 2, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2},
                              {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};

ForeignMesh bricks(const Counts& counts, const Place& place) {
  ForeignMesh mesh;
  mesh.file = "bricks";
  const auto number = [&](int i, int j, int k) { return 1 + i + 100L * (j + 100L * k); };
  for (int k = 0; k < counts[2]; ++k)
    for (int j = 0; j < counts[1]; ++j)
      for (int i = 0; i < counts[0]; ++i) {
        ForeignCell cell{static_cast<long>(mesh.cells.size()) + 1, {}};
        for (const auto& at : brick) {
          const int x = 2 * i + at[0], y = 2 * j + at[1], z = 2 * k + at[2];
          cell.nodes.push_back(number(x, y, z));
          mesh.nodes[cell.nodes.back()] = place(0.5 * x, 0.5 * y, 0.5 * z);
        }
        mesh.cells.push_back(cell);
      }
  return mesh;
}

CellMesh in_metres(const ForeignMesh& mesh) {
  return in_our_terms(mesh, 1.0, Axis::z);
}

/// Symptom: a mesh whose cells are written twice has no free face, and the message asked for the unit of length.
TEST(ImportedMesh, SaysThatCellsAreThereTwice) {
  ForeignMesh mesh = bricks({2, 1, 1}, [](double i, double j, double k) { return Eigen::Vector3d(1 + i, j, k); });
  EXPECT_NO_THROW(in_metres(mesh));
  mesh.cells.push_back({77, mesh.cells[1].nodes});
  EXPECT_EQ(complaint<InputError>([&] { in_metres(mesh); }),
            "bricks: elements 2 and 77 have the same nodes; is the mesh there twice? Write it once");
}

/// Symptom: along a blunt end that is slanted, the line ran across the end too: 21 nodes where the flank has 17.
TEST(ImportedMesh, FindsALineAlongOneFlankOfABluntSlantedTip) {
  const Eigen::Vector3d along(0, 0.003, 0.004), across(0, -0.004, 0.001);
  const CellMesh mesh = in_metres(bricks({8, 2, 1}, [&](double i, double j, double k) {
    return Eigen::Vector3d(Eigen::Vector3d(0.09 + 0.01 * k, 0, 0) + i * along + j * across);
  }));
  const std::vector<int> line =
      line_along_tip(mesh, select_faces(mesh, "blade_tip", "plane x 0.1"), "blade_tip", LeadingEdge::low_z);
  ASSERT_EQ(line.size(), 17u);
  const Eigen::Vector3d chord = mesh.nodes.col(line.back()) - mesh.nodes.col(line.front());
  EXPECT_LT((chord - 8 * along).norm(), 1e-12);
}

/// Symptom: of two cuts that were meshed apart the faces that coincided were paired, 62 of 240, and the rest was
/// free.
TEST(ImportedMesh, RefusesAPartOfACut) {
  constexpr int sectors = 6, around = 4;
  const auto ring = [&](double stretch) {
    return in_metres(bricks({2, around, 3}, [&](double i, double j, double k) {
      const double angle = 2 * std::numbers::pi / sectors * j / around, radius = 1 + 0.1 * i;
      const double z = 0.1 * k + (j == around && k > 1 ? stretch * k * (3 - k) : 0.0);
      return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z);
    }));
  };
  const CellMesh whole = ring(0), part = ring(0.01);
  const PeriodicCuts named =
      find_cuts(whole, 0);  // the cuts of both by their faces' numbers, as sets would name them
  EXPECT_EQ(find_cuts(whole, 0).low.size(), 6u);
  EXPECT_EQ(complaint<InputError>([&] { require_whole(whole, find_cuts(whole, 0)); }), "");
  EXPECT_EQ(
      complaint<InputError>([&] { require_whole(part, find_cuts(part, sectors)); }),
      "bricks: 2 of the 6 faces of a cut, turned by 360/6 degrees, are faces of the other; mesh both cuts alike "
      "(gmsh: Periodic Surface)");
  EXPECT_EQ(complaint<InputError>([&] { require_pairs(whole, named); }), "");
  EXPECT_EQ(complaint<InputError>([&] { require_pairs(part, named); }),
            complaint<InputError>([&] { require_whole(part, find_cuts(part, sectors)); }));
}

/// Symptom: of two named cuts that were meshed apart the message spoke of another axis, about which 6 faces of the
/// surface coincided by chance.
TEST(ImportedMesh, SaysThatNamedCutsAreMeshedApart) {
  constexpr int around = 4;
  const auto ring = [&](double pitch, bool apart) {
    return in_metres(bricks({2, around, 3}, [&](double i, double j, double k) {
      const double angle = pitch * j / around, radius = 1 + 0.1 * i;
      const double z = 0.1 * k + (apart && j == around ? 0.01 * k * (3 - k) : 0.0);
      return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z);
    }));
  };
  const double pitch = 2 * std::numbers::pi / 12;
  const CellMesh alike = ring(pitch, false), apart = ring(pitch, true), wrong = ring(pitch * 29 / 30, false);
  const PeriodicCuts cuts = find_cuts(alike, 0);  // the faces have the same numbers in all of them
  EXPECT_EQ(named_cuts(apart, cuts.low, cuts.high, 0).sector_count, 12);
  EXPECT_EQ(named_cuts(alike, cuts.high, cuts.low, 0).low, cuts.low);
  EXPECT_TRUE(mostly_pair(alike, named_cuts(alike, cuts.high, cuts.low, 0)));
  EXPECT_FALSE(mostly_pair(apart, named_cuts(apart, cuts.low, cuts.high, 0)));
  EXPECT_EQ(why_unpaired(apart, named_cuts(apart, cuts.low, cuts.high, 0)),
            "mesh both cuts alike (gmsh: Periodic Surface)");
  EXPECT_EQ(why_unpaired(wrong, named_cuts(wrong, cuts.low, cuts.high, 0)),
            "the cuts are 29 degrees apart, which is 360/12.4138; a sector needs 360/N");
  EXPECT_TRUE(could_be_meant(alike, named_cuts(alike, cuts.low, cuts.high, 0)));
}

/// Symptom: of a sector of six about x the message named y with two sectors, where a half turn exchanges the cuts.
TEST(ImportedMesh, SuggestsNoHalfTurnAboutTheMiddleOfASector) {
  const ForeignMesh sector = bricks({2, 4, 1}, [](double i, double j, double k) {
    const double angle = 2 * std::numbers::pi / 6 * (j / 4 - 0.5), radius = 1 + 0.1 * i;
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0.1 * (k - 0.5));
  });
  const CellMesh about_z = in_metres(sector), about_x = in_our_terms(sector, 1.0, Axis::x);
  const PeriodicCuts cuts = find_cuts(about_z, 6), half_turn = named_cuts(about_x, cuts.low, cuts.high, 2);
  EXPECT_TRUE(could_be_meant(about_z, named_cuts(about_z, cuts.low, cuts.high, 0)));
  EXPECT_TRUE(mostly_pair(about_x, half_turn));
  EXPECT_FALSE(could_be_meant(about_x, half_turn));
}

/// Symptom: the nodes of a cut passed as the clamped surface, and the wheel was held on a plane inside it.
TEST(ImportedMesh, RefusesToClampACut) {
  const CellMesh mesh = in_metres(bricks({2, 4, 1}, [](double i, double j, double k) {
    const double angle = 2 * std::numbers::pi / 6 * j / 4, radius = 1 + 0.1 * i;
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0.1 * k);
  }));
  const PeriodicCuts cuts = find_cuts(mesh, 6);
  ASSERT_EQ(cuts.low.size(), 2u);
  const auto clamping = [&](const std::vector<int>& faces) {
    return complaint<InputError>([&] { off_the_cuts(mesh, cuts, faces); });
  };
  const std::string refused =
      " of the cuts, inside the wheel; select the surface by which the wheel is held, as the bore";
  EXPECT_EQ(clamping(cuts.low), "bricks: [mesh] clamped selects 2 faces" + refused);
  std::vector<int> all, inner;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const FreeFace& face = mesh.faces[f];
    all.push_back(static_cast<int>(f));
    if (std::all_of(face.nodes.begin(), face.nodes.end(),
                    [&](int node) { return mesh.nodes.col(node).head<2>().norm() < 1.15; }))
      inner.push_back(static_cast<int>(f));
  }
  EXPECT_EQ(clamping(all), "bricks: [mesh] clamped selects 4 faces" + refused);
  // Bore, front and back: the nodes of these are all corners of a face of each cut, too.
  EXPECT_EQ(inner.size(), 14u);
  EXPECT_EQ(off_the_cuts(mesh, cuts, inner).size(), 12u);
}

/// The faces at k = 1 of two plates of 8 bricks, with a gap between them.
CellMesh two_blades(const Place& place) {
  ForeignMesh mesh = bricks({8, 3, 1}, place);
  std::erase_if(mesh.cells, [](const ForeignCell& cell) { return cell.number > 8 && cell.number <= 16; });
  return in_metres(mesh);
}

/// Symptom: faces of flanks and of other blades passed for a tip.
TEST(ImportedMesh, RefusesATipThatIsNotOneSurface) {
  const auto selecting = [](const CellMesh& mesh, const std::string& where) {
    return complaint<InputError>(
        [&] { require_one_surface(mesh, select_faces(mesh, "blade_tip", where), "blade_tip"); });
  };
  const CellMesh blades =
      two_blades([](double i, double j, double k) { return Eigen::Vector3d(1 + k, 0.1 * j, 0.1 * i); });
  EXPECT_EQ(selecting(blades, "plane x 2"),
            "bricks: [mesh] blade_tip selects surfaces that share no edge, one of 8 of the 16 faces; select the tip "
            "of one blade alone");
  EXPECT_EQ(complaint<InputError>([&] {
              line_along_tip(blades, select_faces(blades, "blade_tip", "plane x 2"), "blade_tip", LeadingEdge::low_z);
            }),
            "bricks: [mesh] blade_tip selects faces that have no single edge round them; select the tip of one blade "
            "alone, or name a set of nodes along it as contact");
  // The tip of an impeller turns from axial to radial, here with few faces.
  CellMesh curved = in_metres(bricks({3, 1, 1}, [](double i, double j, double k) {
    const double angle = std::numbers::pi / 2 * i / 3, radius = 1 - 0.1 * k;
    return Eigen::Vector3d(2 - radius * std::cos(angle), 0.1 * j, radius * std::sin(angle));
  }));
  curved.node_sets["tip"] = curved.node_sets["blade"] = {};
  for (int node = 0; node < curved.nodes.cols(); ++node) {
    const double radius = std::hypot(curved.nodes(0, node) - 2, curved.nodes(2, node));
    if (radius < 0.901) curved.node_sets["tip"].push_back(node);
    if (radius < 0.901 || curved.nodes(1, node) < 0.01) curved.node_sets["blade"].push_back(node);
  }
  EXPECT_EQ(selecting(curved, "tip"), "");
  EXPECT_NE(selecting(curved, "blade").find("blade_tip selects faces on both sides of a sharp edge, at x y z ="),
            std::string::npos);
}

/// Symptom: a line along the splitter, or along half of the tip, passed with the faces of the main blade's tip.
TEST(ImportedMesh, RefusesALineThatIsNotAlongItsTip) {
  const CellMesh mesh =
      two_blades([](double i, double j, double k) { return Eigen::Vector3d(1 + k, 0.1 * j, 0.1 * i); });
  std::vector<int> tip;  // of the blade at small y
  for (const int face : select_faces(mesh, "blade_tip", "plane x 2"))
    if (mesh.nodes(1, mesh.faces[static_cast<std::size_t>(face)].nodes[0]) < 0.15) tip.push_back(face);
  ASSERT_EQ(tip.size(), 8u);
  const auto along = [&](double y, double low, double high) {
    std::vector<int> line;
    for (int node = 0; node < mesh.nodes.cols(); ++node) {
      const Eigen::Vector3d at = mesh.nodes.col(node);
      if (at.x() > 1.99 && std::abs(at.y() - y) < 0.01 && at.z() > low - 0.01 && at.z() < high + 0.01)
        line.push_back(node);
    }
    line = ordered_line(mesh, line, LeadingEdge::low_z);
    return complaint<InputError>([&] { require_along_tip(mesh, tip, "blade_tip", line, "contact"); });
  };
  EXPECT_EQ(along(0, 0, 0.8), "");
  EXPECT_EQ(along(0.05, 0.1, 0.7), "") << "shorter by one face at each end";
  EXPECT_EQ(
      along(0.3, 0, 0.8),
      "bricks: [mesh] contact and blade_tip don't belong together: 17 of the 17 nodes of contact are not on the "
      "faces of blade_tip; name the line and the faces of one tip");
  EXPECT_EQ(along(0, 0, 0.4),
            "bricks: [mesh] contact and blade_tip don't belong together: 3 faces of blade_tip lie beyond the end of "
            "contact at x y z = 2 0 0.4 m; the line must run from the leading to the trailing edge");
}

/// Symptom: a line along two of the three faces of a coarse tip passed, and tiprub-reduce refused the sector.
TEST(ImportedMesh, RefusesALineThatLeavesOutMuchOfItsTip) {
  const CellMesh mesh = in_metres(
      bricks({3, 2, 1}, [](double i, double j, double k) { return Eigen::Vector3d(1 + k, 0.1 * j, 0.1 * i); }));
  const std::vector<int> tip = select_faces(mesh, "blade_tip", "plane x 2");
  const auto along = [&](double low, double high) {
    std::vector<int> line;
    for (int node = 0; node < mesh.nodes.cols(); ++node) {
      const Eigen::Vector3d at = mesh.nodes.col(node);
      if (at.x() > 1.99 && std::abs(at.y() - 0.1) < 0.01 && at.z() > low - 0.01 && at.z() < high + 0.01)
        line.push_back(node);
    }
    line = ordered_line(mesh, line, LeadingEdge::low_z);
    return complaint<InputError>([&] { require_along_tip(mesh, tip, "blade_tip", line, "contact"); });
  };
  EXPECT_EQ(along(0, 0.3), "");
  EXPECT_EQ(along(0.05, 0.25), "") << "to the middle of the outer faces";
  EXPECT_EQ(
      along(0, 0.2),
      "bricks: [mesh] contact and blade_tip don't belong together: 33 % of the area of blade_tip lies beyond the "
      "ends of contact; the line must run from the leading to the trailing edge");
  EXPECT_NE(along(0, 0.15).find("33 % of the area"), std::string::npos) << "to the middle of the tip";
  EXPECT_NE(along(0.1, 0.2).find("67 % of the area"), std::string::npos) << along(0.1, 0.2);
}

/// Symptom: the nodes of the whole face of a tip became a line across it.
TEST(ImportedMesh, RefusesNodesThatFormNoLine) {
  constexpr double slant = 0.02;  // no two nodes are at the same z
  const CellMesh mesh = in_metres(bricks({4, 2, 1}, [](double i, double j, double k) {
    return Eigen::Vector3d(10 + k, 0.1 * (j - 1), 0.1 * i + slant * j);
  }));
  const auto along = [&](double low, double high) {
    std::vector<int> nodes;
    for (int node = 0; node < mesh.nodes.cols(); ++node) {
      const Eigen::Vector3d at = mesh.nodes.col(node);
      if (at.x() > 10.99 && at.y() > low - 0.01 && at.y() < high + 0.01) nodes.push_back(node);
    }
    const std::vector<int> line = ordered_line(mesh, nodes, LeadingEdge::low_z);
    return complaint<InputError>([&] { require_one_line(mesh, nodes, line, "contact"); });
  };
  const std::string side_by_side = "bricks: [mesh] contact has nodes side by side across the tip, at x y z = ";
  EXPECT_EQ(along(0, 0), "");
  EXPECT_TRUE(along(-0.1, 0.1).starts_with(side_by_side)) << along(-0.1, 0.1);
  EXPECT_TRUE(along(0, 0.1).starts_with(side_by_side)) << along(0, 0.1);
}

/// Symptom: a blade that was not joined to its disc passed, and long after the stiffness was not positive definite.
TEST(ImportedMesh, RefusesABodyThatNothingHolds) {
  ForeignMesh row = bricks({4, 1, 1}, [](double i, double j, double k) { return Eigen::Vector3d(1 + i, j, k); });
  const auto clamping = [](const CellMesh& mesh, const std::string& where, const PeriodicCuts& pairs) {
    return complaint<InputError>([&] { require_held(mesh, pairs, select_faces(mesh, "clamped", where)); });
  };
  EXPECT_EQ(clamping(in_metres(row), "plane x 1", {}), "");
  row.cells.erase(row.cells.begin() + 1);
  const CellMesh parted = in_metres(row);
  EXPECT_EQ(clamping(parted, "plane x 1", {}),
            "bricks: the cells form 2 bodies that share no node: one of 2 cells, with r from 3 to 5.09902 m, touches "
            "nothing that is clamped; join the volumes before meshing (gmsh: BooleanFragments)");
  EXPECT_EQ(clamping(parted, "plane y 0", {}), "") << "each body is clamped";
  const PeriodicCuts pairs = {2, select_faces(parted, "", "plane x 2"), select_faces(parted, "", "plane x 3")};
  EXPECT_EQ(clamping(parted, "plane x 1", pairs), "") << "through a cut";
}

TEST(ImportedMesh, DoubtsOneBodyThatDoesNotGoRoundTheAxis) {
  const auto ring = [](double turn) {
    return in_metres(bricks({1, 8, 1}, [&](double i, double j, double k) {
      const double angle = turn * j / 8;
      return Eigen::Vector3d((1 + i) * std::cos(angle), (1 + i) * std::sin(angle), k);
    }));
  };
  EXPECT_TRUE(goes_round(ring(2 * std::numbers::pi)));
  EXPECT_FALSE(goes_round(ring(std::numbers::pi)));
}

/// An Abaqus deck of bricks. The sets hold nodes with these numbers, see bricks().
std::string deck_of(const ForeignMesh& mesh, const std::map<std::string, std::vector<long>>& sets) {
  std::ostringstream text;
  text << std::setprecision(17) << "*NODE\n";
  for (const auto& [number, at] : mesh.nodes)
    text << number << ", " << at.x() << ", " << at.y() << ", " << at.z() << "\n";
  text << "*ELEMENT, TYPE=C3D20\n";
  for (const ForeignCell& cell : mesh.cells) {
    text << cell.number;
    for (std::size_t k = 0; k < cell.nodes.size(); ++k) text << (k == 10 ? ",\n" : ", ") << cell.nodes[k];
    text << "\n";
  }
  for (const auto& [name, nodes] : sets) {
    text << "*NSET, NSET=" << name << "\n";
    for (const long node : nodes) text << node << ",\n";
  }
  return text.str();
}

/// Symptom: two bricks of different materials passed as one wheel without a word.
TEST(ImportedMesh, NotesTheMaterialsOfAnArchive) {
  std::ostringstream text;
  text << "ET,1,186\nEBLOCK,19,SOLID\n(19i9)\n";
  for (const int material : {1, 2}) {
    for (const int field : {material, 1, 1, 1, 0, 0, 0, 0, 20, 0, material}) text << std::setw(9) << field;
    for (int node = 1; node <= 20; ++node) text << (node == 9 ? "\n" : "") << std::setw(9) << node;
    text << "\n";
  }
  text << "       -1\n";
  EXPECT_EQ(read_cdb({"wheel.cdb", text.str()}).materials, (std::set<std::string>{"1", "2"}));
}

TEST(ImportedMesh, TellsARequestForConstraintsFromConstraints) {
  const ForeignMesh mesh = read_bdf({"wheel.bdf", "MPC     = 5\nMPC = 5\nBEGIN BULK\nMPC,5,1,1,1.,2,1,-1.\n"});
  EXPECT_EQ(mesh.not_read, (std::map<std::string, int>{{"MPC", 1}}));
}

/// Symptom: a sector about x, round which the nodes stand on all sides of z, passed as one body if `axis` was
/// forgotten.
TEST(ImportedMesh, SaysAboutWhichAxisThereAreCuts) {
  const ForeignMesh sector = bricks({2, 4, 2}, [](double i, double j, double k) {
    const double angle = 2 * std::numbers::pi / 12 * (j / 4 - 0.5), radius = 1 + 0.1 * i;
    return Eigen::Vector3d(0.1 * (k - 1), -radius * std::sin(angle), radius * std::cos(angle));
  });
  std::map<std::string, std::vector<long>> sets;
  for (const auto& [number, at] : sector.nodes) {
    if (number % 100 == 1) sets["clamped"].push_back(number);  // i = 0
    if (number % 100 == 5 && number / 10000 == 4 && at.y() >= 0) sets["contact"].push_back(number);
  }
  ImportParameters parameters;
  parameters.file = {"sector.inp", deck_of(sector, sets)};
  parameters.selection["clamped"] = "clamped";
  const std::string about_x =
      "no face, turned about the axis, is another one; with axis = \"x\" and sector_count = 12, "
      "4 faces are: set these, or, if this is one body without neighbours, sector_count = 1";
  EXPECT_NE(import_sector(parameters).description.find("\nwarning: " + about_x), std::string::npos)
      << import_sector(parameters).description;
  parameters.sector_count = 1;
  EXPECT_EQ(import_sector(parameters).description.find("warning"), std::string::npos);
}

/// Symptom: a whole wheel passed as one sector of 16, because the flanks of a blade, turned, are each other.
TEST(ImportedMesh, DoubtsCutsOfAMeshThatGoesRoundTheAxis) {
  ForeignMesh wheel = bricks({2, 16, 1}, [](double i, double j, double k) {
    const double angle = 2 * std::numbers::pi * j / 16;
    return Eigen::Vector3d((1 + i) * std::cos(angle), (1 + i) * std::sin(angle), k);
  });
  std::erase_if(wheel.cells,
                [](const ForeignCell& cell) { return cell.nodes[0] % 100 == 3 && cell.number % 4 == 0; });
  constexpr long around = 3200;  // of a node's number, see bricks()
  for (ForeignCell& cell : wheel.cells)
    for (long& node : cell.nodes)
      if (node % 10000 > around) node -= around;
  std::erase_if(wheel.nodes, [](const auto& node) { return node.first % 10000 > around; });
  std::map<std::string, std::vector<long>> sets;
  for (const auto& [number, at] : wheel.nodes) {
    if (number % 100 == 1) sets["clamped"].push_back(number);                               // i = 0
    if (number % 100 == 5 && (number / 100) % 100 == 1) sets["contact"].push_back(number);  // on a blade
  }
  ImportParameters parameters;
  parameters.file = {"wheel.inp", deck_of(wheel, sets)};
  parameters.selection["clamped"] = "clamped";
  const std::string said = import_sector(parameters).description;
  EXPECT_NE(said.find("\nwarning: the mesh goes round the axis, and its faces that were taken for cuts may be"),
            std::string::npos)
      << said;
  parameters.sector_count = 1;
  EXPECT_EQ(import_sector(parameters).description.find("warning"), std::string::npos);
}

}  // namespace
}  // namespace tiprub::mesh
