// SPDX-License-Identifier: GPL-3.0-or-later
// A sector that tiprub-mesh didn't make: one eighth of a disc, meshed by gmsh (transfinite, recombined, extruded).
//
// usage: gmsh_sector KIND SECTOR.msh; KIND is hex20, hex27, hex8, inverted (hex20 mirrored in z)
// or held_cut (the group clamped holds a cut, too).
#include <gmsh.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace {

constexpr int sectors = 8;
constexpr double bore = 0.05, rim = 0.1, height = 0.01;  // [m]
constexpr int steps_along_radius = 3, steps_round_half = 1, steps_in_height = 2;

int point(double radius, double angle) {
  return gmsh::model::geo::addPoint(radius * std::cos(angle), radius * std::sin(angle), 0.0);
}

void name(int dimension, const std::vector<int>& entities, const std::string& group) {
  gmsh::model::setPhysicalName(dimension, gmsh::model::addPhysicalGroup(dimension, entities), group);
}

/// The edge that stands on the rim in the middle between the cuts.
int tip_edge(double angle) {
  constexpr double near = 1e-6;
  const double x = rim * std::cos(angle), y = rim * std::sin(angle);
  gmsh::vectorpair found;
  gmsh::model::getEntitiesInBoundingBox(x - near, y - near, -near, x + near, y + near, height + near, found, 1);
  return found.at(0).second;
}

void draw(bool holds_cut) {
  namespace geo = gmsh::model::geo;
  const double alpha = 2 * std::numbers::pi / sectors;
  const int centre = geo::addPoint(0, 0, 0);
  const int a = point(bore, 0), b = point(rim, 0), middle = point(rim, alpha / 2), c = point(rim, alpha);
  const int d = point(bore, alpha);
  const int low = geo::addLine(a, b), first = geo::addCircleArc(b, centre, middle);
  const int second = geo::addCircleArc(middle, centre, c), high = geo::addLine(c, d),
            inner = geo::addCircleArc(d, centre, a);
  const int face = geo::addPlaneSurface({geo::addCurveLoop({low, first, second, high, inner})});
  for (const int radial : {low, high}) geo::mesh::setTransfiniteCurve(radial, steps_along_radius + 1);
  for (const int half : {first, second}) geo::mesh::setTransfiniteCurve(half, steps_round_half + 1);
  geo::mesh::setTransfiniteCurve(inner, 2 * steps_round_half + 1);
  geo::mesh::setTransfiniteSurface(face, "Left", {a, b, c, d});
  geo::mesh::setRecombine(2, face);
  gmsh::vectorpair made;  // top, volume, then the sides in the order of the curves
  geo::extrude({{2, face}}, 0, 0, height, made, {steps_in_height}, {}, true);
  geo::synchronize();
  const int cut = made.at(2).second, inside = made.at(6).second;
  name(3, {made.at(1).second}, "sector");
  name(2, {cut}, "cyclic_low");
  name(2, {made.at(5).second}, "cyclic_high");
  name(2, holds_cut ? std::vector{inside, cut} : std::vector{inside}, "clamped");
  name(1, {tip_edge(alpha / 2)}, "contact");
}

void mirror() {
  std::vector<std::size_t> tags;
  std::vector<double> positions, parameters;
  gmsh::model::mesh::getNodes(tags, positions, parameters, -1, -1, false, false);
  for (std::size_t i = 0; i < tags.size(); ++i)
    gmsh::model::mesh::setNode(tags[i], {positions[3 * i], positions[3 * i + 1], -positions[3 * i + 2]}, {});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::string kind = argv[1];
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("Mesh.ElementOrder", kind == "hex8" ? 1 : 2);
  gmsh::option::setNumber("Mesh.SecondOrderIncomplete", kind == "hex27" ? 0 : 1);
  draw(kind == "held_cut");
  gmsh::model::mesh::generate(3);
  if (kind == "inverted") mirror();
  gmsh::write(argv[2]);
  gmsh::finalize();
  return 0;
}
