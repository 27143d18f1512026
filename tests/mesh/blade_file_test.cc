// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/wheels/wheel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "mesh/blades/blade_files.h"
#include "mesh/sector/sector_check.h"
#include "tests/mesh/mesh_cases.h"
#include "tests/mesh/sector_geometry.h"

namespace tiprub::mesh {
namespace {

using test::geometry_volume;
using test::sector_from;
using test::wheel_from;

/// A file of the test that runs: others run beside it.
std::filesystem::path written(const std::string& name, const std::string& text) {
  const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const auto path = std::filesystem::path(::testing::TempDir()) / (test + "_" + name);
  std::ofstream(path) << text;
  return path;
}

/// The blade of a wheel, as a table of so many sections and points, its angles by so many units a radian.
std::string table_of(const Wheel& wheel, int sections, int points, double radian = 1.0) {
  std::ostringstream text;
  text << std::setprecision(17);
  for (int i = 0; i < sections; ++i) {
    text << "section\n";
    for (int k = 0; k < points; ++k) {
      const double span = i / (sections - 1.0), chord = k / (points - 1.0);
      const MeridionalPoint at = wheel.geometry->blade_point(chord, span);
      const double theta = wheel.geometry->theta(chord, span);
      const double half = wheel.geometry->half_width(BladeKind::main, chord, span);
      text << at.z << " " << at.r << " " << radian * (theta + half) << " " << radian * (theta - half) << "\n";
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
  const MeshedSector of_family = sector_from(test::twisted_blades());
  for (const bool degrees : {false, true}) {
    const double radian = degrees ? 180.0 / EIGEN_PI : 1.0;
    const auto file = written("twisted.txt", table_of(wheel_from(test::twisted_blades()), 81, 161, radian));
    const MeshedSector of_file =
        sector_from(twisted_blades_of_file(file) + (degrees ? "angle_unit = \"deg\"\n" : ""));
    ASSERT_EQ(of_file.nodes.size(), of_family.nodes.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < of_file.nodes.size(); ++i)
      worst = std::max(worst, (of_file.nodes[i] - of_family.nodes[i]).norm());
    EXPECT_LT(worst, 1e-6);  // m, of a blade of 60 mm
  }
}

/// hub.curve or shroud.curve of a cylinder, in millimetres, from far upstream to far downstream.
std::string cylinder(double radius) {
  std::ostringstream text;
  text << "# a cylinder\n" << 1e3 * radius << " 0 -100\n0 " << 1e3 * radius << " 100\n";
  return text.str();
}

/// profile.curve, in millimetres: from hub to tip so many profiles, each once round, begun in the middle of a side;
/// two profiles reach below the hub and above the shroud.
std::string profiles_of(const Wheel& wheel, int sections, int points) {
  std::ostringstream text;
  text << std::setprecision(17) << "## Main blade\n";
  for (int i = 0; i < sections; ++i) {
    text << "# Profile " << i + 1 << " at " << 100.0 * i / (sections - 1) << "%\n";
    for (int k = 0; k < 2 * points; ++k) {
      const int at = (k + points / 2) % (2 * points);
      const double chord = at < points ? at / (points - 1.0) : (2 * points - 1 - at) / (points - 1.0);
      const double span = i / (sections - 1.0);
      const MeridionalPoint place = wheel.geometry->blade_point(chord, span);
      const double half = wheel.geometry->half_width(BladeKind::main, chord, span);
      const double theta =
          wheel.geometry->theta(chord, span) + (at < points ? half : -half) + 3.0;  // over the jump at pi
      text << 1e3 * place.r * std::cos(theta) << " " << 1e3 * place.r * std::sin(theta) << " " << 1e3 * place.z
           << (at == 0 ? " le1" : "") << "\n";
    }
  }
  return text.str();
}

TEST(BladeFile, MeshesABladeOfTurboGridsCurves) {
  const Wheel wheel = wheel_from(test::twisted_blades());
  const auto profiles = written("profile.curve", profiles_of(wheel, 61, 101));
  const auto hub = written("hub.curve", cylinder(0.11)), shroud = written("shroud.curve", cylinder(0.152));
  const Wheel of_file =
      wheel_from("[mesh]\nfamily = \"blade_file\"\nblade_format = \"curve\"\nblade_file = \"" + profiles.string() +
                 "\"\nhub_file = \"" + hub.string() + "\"\nshroud_file = \"" + shroud.string() +
                 "\"\nlength_unit = \"mm\"\ntip_clearance = 2e-3\nblade_count = 12\n"
                 "blunt_edge = 0.0\ndisc = \"none\"\n");
  for (const double chord : {0.0, 0.3, 0.7, 1.0})
    for (const double span : {0.0, 0.4, 1.0}) {
      const double whole = (0.01 + 0.04 * span) / 0.06;  // from radius 0.1 to 0.16
      const MeridionalPoint at = of_file.geometry->blade_point(chord, span);
      EXPECT_NEAR(at.r, 0.11 + 0.04 * span, 1e-9);
      EXPECT_NEAR(at.z, wheel.geometry->blade_point(chord, whole).z, 1e-9);
      EXPECT_NEAR(of_file.geometry->theta(chord, span), wheel.geometry->theta(chord, whole) + 3.0, 1e-5);
      EXPECT_NEAR(of_file.geometry->half_width(BladeKind::main, chord, span),
                  wheel.geometry->half_width(BladeKind::main, chord, whole), 1e-6);
    }
}

/// Meanline data, in inches, whose thickness is along the circle (T), or normal to the mean line (N).
std::string meanline_of(const Wheel& wheel, char flag, int layers, int points) {
  std::ostringstream text;
  text << std::setprecision(17) << "12\n0\n0.0\n" << layers << "\n" << flag << "\n";
  constexpr double inch = 0.0254, step = 1e-6;
  for (int i = 0; i < layers; ++i) {
    const double span = i / (layers - 1.0);
    text << span << " " << points + 1 << " b\n";
    for (int k = 0; k < points; ++k) {
      const double chord = k / (points - 1.0);
      const MeridionalPoint at = wheel.geometry->blade_point(chord, span);
      const double tangential = 2.0 * at.r * wheel.geometry->half_width(BladeKind::main, chord, span);
      const double turned = wheel.geometry->theta(chord + step, span) - wheel.geometry->theta(chord - step, span);
      const double along =
          wheel.geometry->blade_point(chord + step, span).z - wheel.geometry->blade_point(chord - step, span).z;
      const double cosine = 1.0 / std::hypot(1.0, at.r * turned / along);
      text << at.r / inch << " " << wheel.geometry->theta(chord, span) << " " << at.z / inch << " "
           << tangential * (flag == 'N' ? cosine : 1.0) / inch << "\n";
    }
    const MeridionalPoint end = wheel.geometry->blade_point(1.0, span);
    text << end.r / inch << " " << wheel.geometry->theta(1.0, span) << " " << (end.z + 0.01) / inch << " 0.0\n";
  }
  return text.str();
}

/// One blade of meanline data, in metres, thickness along the circle, over its own stations, turned.
std::string meanline_blade(const Wheel& wheel, BladeKind kind, double first_station, double turned) {
  constexpr int layers = 21, points = 161;
  std::ostringstream text;
  text << std::setprecision(17) << 0.5 << "\n" << layers << " T\n";
  for (int i = 0; i < layers; ++i) {
    const double span = i / (layers - 1.0);
    text << span << " " << points << "\n";
    for (int k = 0; k < points; ++k) {
      const double station = first_station + (1.0 - first_station) * k / (points - 1.0);
      const MeridionalPoint at = wheel.geometry->blade_point(station, span);
      text << at.r << " " << wheel.geometry->theta(station, span) + turned << " " << at.z << " "
           << 2.0 * at.r * wheel.geometry->half_width(kind, station, span) << "\n";
    }
  }
  return text.str();
}

std::string impeller_of_file(const std::filesystem::path& file) {
  return "[mesh]\nfamily = \"blade_file\"\nblade_format = \"rtzt\"\nblade_file = \"" + file.string() +
         "\"\nlength_unit = \"m\"\nblade_count = 10\nblunt_edge = 0.0\ndisc = \"back_face\"\nbore_radius = 0.028\n"
         "back_profile = [[0.028, 0.092], [0.045, 0.087], [0.09, 0.0755], [0.122, 0.0705]]\n"
         "elements_along_chord = 10\nelements_along_bore = 4\nelements_along_span = 5\nelements_through_blade = 3\n"
         "elements_through_splitter = 2\nelements_through_disc = 3\nelements_between_blades = 2\n";
}

// Between hub and tip stations are other fractions of the length than the family's; the shape is the same.
TEST(BladeFile, MeshesAnImpellerWithSplittersLikeTheFamily) {
  const Wheel family = wheel_from(test::with(test::case_text("fast_impeller"), "splitter_start", "0.42"));
  const std::string main = meanline_blade(family, BladeKind::main, 0.0, 0.0);
  for (const double turned : {0.0, 0.5 * family.plan.pitch()}) {  // both are written by people
    const std::string splitter = meanline_blade(family, BladeKind::splitter, family.plan.splitter_start, turned);
    const Wheel wheel = wheel_from(impeller_of_file(written("impeller.rtzt", "10\n1\n" + main + splitter)));
    EXPECT_NEAR(wheel.plan.splitter_start, 0.42, 0.01);  // as a fraction at mid-span
    EXPECT_EQ(wheel.plan.elements.upstream, family.plan.elements.upstream);
    EXPECT_NEAR(geometry_volume(wheel), geometry_volume(family), 1e-4 * geometry_volume(family));
    EXPECT_EQ(mesh_sector(wheel).cells.size(), mesh_sector(family).cells.size());
    for (const double span : {0.0, 1.0})
      for (int half = 0; half <= 2 * family.plan.elements.chord; ++half) {
        const double ours = wheel.plan.station(half), theirs = family.plan.station(half);
        EXPECT_NEAR(wheel.geometry->blade_point(ours, span).z, family.geometry->blade_point(theirs, span).z, 1e-6);
        EXPECT_NEAR(wheel.geometry->blade_point(ours, span).r, family.geometry->blade_point(theirs, span).r, 1e-6);
        EXPECT_NEAR(wheel.geometry->theta(ours, span), family.geometry->theta(theirs, span), 1e-5);
        EXPECT_NEAR(wheel.geometry->half_width(BladeKind::main, ours, span),
                    family.geometry->half_width(BladeKind::main, theirs, span), 1e-5);
        if (theirs < family.plan.splitter_start) continue;
        EXPECT_NEAR(wheel.geometry->half_width(BladeKind::splitter, ours, span),
                    family.geometry->half_width(BladeKind::splitter, theirs, span), 1e-5);
      }
  }
}

TEST(BladeFile, RefusesASplitterThatStandsElsewhere) {
  const Wheel family = wheel_from(test::with(test::case_text("fast_impeller"), "splitter_start", "0.42"));
  const std::string main = meanline_blade(family, BladeKind::main, 0.0, 0.0);
  const std::string elsewhere = meanline_blade(family, BladeKind::splitter, family.plan.splitter_start, 0.05);
  EXPECT_NE(test::complaint(impeller_of_file(written("impeller.rtzt", "10\n1\n" + main + elsewhere)))
                .find("the splitter leaves the main blade's mean surface by 0.05 rad at 0 of the span"),
            std::string::npos);
}

// The last point of each layer is no blade, and stands as a sharp edge: it stretches the chord by a known share.
TEST(BladeFile, MeshesABladeOfBladeGensMeanline) {
  const Wheel wheel = wheel_from(test::twisted_blades());
  for (const char flag : {'N', 'T'}) {
    const auto file = written("blade.rtzt", meanline_of(wheel, flag, 61, 101));
    const Wheel of_file =
        wheel_from("[mesh]\nfamily = \"blade_file\"\nblade_format = \"rtzt\"\nblade_file = \"" + file.string() +
                   "\"\nlength_unit = \"in\"\nblade_count = 12\nblunt_edge = 0.0\ndisc = \"none\"\n");
    for (const double chord : {0.0, 0.3, 0.7})
      for (const double span : {0.0, 0.4, 1.0}) {
        const double stretched = chord * 0.03 / 0.04;
        EXPECT_NEAR(of_file.geometry->blade_point(stretched, span).z, wheel.geometry->blade_point(chord, span).z,
                    1e-9);
        EXPECT_NEAR(of_file.geometry->theta(stretched, span), wheel.geometry->theta(chord, span), 1e-5);
        EXPECT_NEAR(of_file.geometry->half_width(BladeKind::main, stretched, span),
                    wheel.geometry->half_width(BladeKind::main, chord, span), 1e-5)
            << flag;
      }
  }
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
}  // namespace tiprub::mesh
