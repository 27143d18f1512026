// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/wheels/blade_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "mesh/blades/section_table.h"
#include "mesh/wheels/geometry_volume.h"
#include "tests/mesh/mesh_cases.h"

namespace tiprub {
namespace {

using test::sector_from;
using test::wheel_from;

std::filesystem::path written(const std::string& name, const std::string& text) {
  const auto path = std::filesystem::path(::testing::TempDir()) / name;
  std::ofstream(path) << text;
  return path;
}

/// The blade of a wheel, as a table of so many sections and points.
std::string table_of(const Wheel& wheel, int sections, int points) {
  std::ostringstream text;
  text << std::setprecision(17);
  for (int i = 0; i < sections; ++i) {
    text << "section\n";
    for (int k = 0; k < points; ++k) {
      const double span = i / (sections - 1.0), chord = k / (points - 1.0);
      const MeridionalPoint at = wheel.geometry->blade_point(chord, span);
      const double theta = wheel.geometry->theta(chord, span);
      const double half = wheel.geometry->half_width(BladeKind::main, chord, span);
      text << at.z << " " << at.r << " " << theta + half << " " << theta - half << "\n";
    }
  }
  return text.str();
}

std::string twisted_blades_of_file(const std::filesystem::path& file) {
  return "[mesh]\nfamily = \"blade_file\"\nblade_format = \"sections\"\nblade_file = \"" + file.string() +
         "\"\nlength_unit = \"m\"\nblade_count = 12\nblunt_edge = 0.0\ndisc = \"profile\"\nbore_radius = 0.04\n"
         "elements_along_chord = 6\nelements_along_span = 6\n";
}

std::string rotor37(const std::string& disc) {
  return "[mesh]\nfamily = \"blade_file\"\nblade_format = \"sections\"\nblade_file = \"" TIPRUB_CASES
         "/rotor37/blade.txt\"\nlength_unit = \"cm\"\nblade_count = 36\n" +
         disc;
}

TEST(BladeFile, MeshesABladeLikeTheFamilyThatItsTableComesFrom) {
  const auto file = written("twisted.txt", table_of(wheel_from(test::twisted_blades()), 81, 161));
  const MeshedSector of_family = sector_from(test::twisted_blades());
  const MeshedSector of_file = sector_from(twisted_blades_of_file(file));
  ASSERT_EQ(of_file.nodes.size(), of_family.nodes.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < of_file.nodes.size(); ++i)
    worst = std::max(worst, (of_file.nodes[i] - of_family.nodes[i]).norm());
  EXPECT_LT(worst, 1e-6);  // m, of a blade of 60 mm
}

TEST(BladeFile, MirrorsAWheelThatTurnsTheOtherWay) {
  const Wheel one = wheel_from(rotor37("disc = \"none\"\n"));
  const Wheel mirrored = wheel_from(rotor37("disc = \"none\"\nrotation = \"negative\"\n"));
  EXPECT_GT(one.geometry->theta(1.0, 0.5), one.geometry->theta(0.0, 0.5));
  EXPECT_DOUBLE_EQ(mirrored.geometry->theta(0.3, 0.5), -one.geometry->theta(0.3, 0.5));
  EXPECT_DOUBLE_EQ(geometry_volume(mirrored), geometry_volume(one));
}

/// The volume between the points of a table, by trapezia in the meridional plane: r times the angle that the blade
/// takes.
double volume_of_table(const FileBlade& blade) {
  double volume = 0.0;
  for (std::size_t i = 1; i < blade.sections.size(); ++i)
    for (std::size_t k = 1; k < blade.sections[i].size(); ++k) {
      const BladePoint corners[] = {blade.sections[i - 1][k - 1], blade.sections[i - 1][k], blade.sections[i][k],
                                    blade.sections[i][k - 1]};
      const MeridionalPoint one = corners[2].at - corners[0].at, other = corners[3].at - corners[1].at;
      double width = 0.0;
      for (const BladePoint& corner : corners) width += 0.25 * corner.at.r * 2.0 * corner.half_width;
      volume += 0.5 * std::abs(one.z * other.r - one.r * other.z) * width;
    }
  return volume;
}

TEST(BladeFile, HasTheVolumeOfRotor37sTable) {
  std::ifstream file(TIPRUB_CASES "/rotor37/blade.txt");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const double expected = volume_of_table(read_section_table({"blade.txt", text}, {0.01, 1.0}));
  const double blunt = geometry_volume(wheel_from(rotor37("disc = \"none\"\n")));
  const double round = geometry_volume(wheel_from(rotor37("disc = \"none\"\nblunt_edge = 0.0\n")));
  EXPECT_NEAR(round, expected, 2e-3 * expected);
  EXPECT_GT(blunt, round);
  EXPECT_NEAR(blunt, round, 5e-3 * round);
}

TEST(BladeFile, MeshesABladeAloneWithoutCuts) {
  const MeshedSector mesh =
      sector_from(rotor37("disc = \"none\"\nelements_along_chord = 4\nelements_along_span = 3\n"
                          "elements_through_blade = 2\n"));
  EXPECT_EQ(mesh.cells.size(), 24U);
  std::vector<std::string> names;
  for (const SectorSurface& surface : mesh.surfaces) names.push_back(surface.name);
  EXPECT_EQ(names, (std::vector<std::string>{"clamped", "blade_tip"}));
  EXPECT_EQ(mesh.surface("clamped").face_nodes.size(), 8U * 8U);
  EXPECT_EQ(mesh.contact.size(), 9U);
  EXPECT_TRUE(mesh.low_and_high_nodes.empty());
}

TEST(BladeFile, StandsOnABackFace) {
  const Wheel wheel =
      wheel_from(rotor37("disc = \"back_face\"\nbore_radius = 0.1\n"
                         "back_profile = [[0.1, 0.09], [0.19, 0.08]]\nelements_along_bore = 3\n"));
  const MeridionalPoint corner = wheel.geometry->disc_point(wheel.plan.station(6), 0.0);
  EXPECT_DOUBLE_EQ(corner.r, 0.1);
  EXPECT_DOUBLE_EQ(corner.z, 0.09);
  EXPECT_DOUBLE_EQ(wheel.geometry->disc_point(1.0, 0.0).r, wheel.geometry->blade_point(1.0, 0.0).r);
}

TEST(BladeFile, RefusesADiscThatDoesNotFit) {
  using test::complaint;
  const auto said = [](const std::string& disc) { return complaint(rotor37(disc)); };
  EXPECT_NE(said("disc = \"profile\"\nbore_radius = 0.18\n").find("must be less than the hub's radius, 0.177"),
            std::string::npos);
  EXPECT_NE(said("disc = \"profile\"\nbore_radius = 0.1\ndisc_profile = [[0.0, 0.04], [1.0, 0.04]]\n")
                .find("must go from height 0, the bore, to less than 1"),
            std::string::npos);
  EXPECT_NE(said("disc = \"back_face\"\nbore_radius = 0.1\nback_profile = [[0.1, 0.09], [0.15, 0.08]]\n")
                .find("must go from bore_radius to the hub's radius at the exit, 0.187"),
            std::string::npos);
  EXPECT_NE(said("disc = \"none\"\nclamped = \"bore\"\n").find("unknown key \"clamped\""), std::string::npos);
}

}  // namespace
}  // namespace tiprub
