// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/mesh/sector_geometry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "mesh/cells/gauss_points.h"

namespace tiprub::mesh::test {

namespace {

constexpr int panels_in_height = 4;
constexpr int least_panels_along = 80;    // many, since the curvature of tables may jump between two stations
constexpr double difference_step = 1e-5;  // of the unit square; central differences are then good to 1e-10

using Section = std::function<MeridionalPoint(double station, double height)>;
using Angle = std::function<double(double station, double height)>;

double area_density(const Section& section, double station, double height) {
  const double h = difference_step;
  const MeridionalPoint along = section(station + h, height) - section(station - h, height);
  const MeridionalPoint up = section(station, height + h) - section(station, height - h);
  return std::abs(along.z * up.r - along.r * up.z) / (4.0 * h * h);
}

// The integral of r * angle over the part of the section between two stations.
double slice_volume(const Section& section, const Angle& angle, double from, double to) {
  double volume = 0.0;
  for (const GaussPoint& a : gauss_points(5))
    for (int panel = 0; panel < panels_in_height; ++panel)
      for (const GaussPoint& b : gauss_points(5)) {
        const double station = 0.5 * (from + to) + 0.5 * (to - from) * a.x;
        const double height = (panel + 0.5 * (1.0 + b.x)) / panels_in_height;
        volume += 0.25 * (to - from) / panels_in_height * a.weight * b.weight * section(station, height).r *
                  angle(station, height) * area_density(section, station, height);
      }
  return volume;
}

double volume_between(const SectorPlan& plan, int first_station, const Section& section, const Angle& angle) {
  const int panels = 1 + least_panels_along / plan.elements.chord;
  double volume = 0.0;
  for (int i = first_station; i < plan.elements.chord; ++i) {
    const double from = plan.station(2 * i), width = (plan.station(2 * i + 2) - from) / panels;
    for (int panel = 0; panel < panels; ++panel)
      volume += slice_volume(section, angle, from + panel * width, from + (panel + 1) * width);
  }
  return volume;
}

// The volume is integrated in two parts, because the width of a fillet begins like a square root at the hub and ends
// with a kink.
double blade_volume(const Wheel& wheel, BladeKind kind, int first_station) {
  const WheelGeometry& geometry = *wheel.geometry;
  std::map<double, double> ends;  // by station; each is needed at many heights
  const auto end_at = [&](double station) {
    const auto [known, is_new] = ends.try_emplace(station, 0.0);
    if (is_new) known->second = geometry.fillet_end(station);
    return known->second;
  };
  const auto part = [&](const std::function<double(double end, double x)>& span) {
    const auto at = [&](double station, double x) { return span(end_at(station), x); };
    return volume_between(
        wheel.plan, first_station,
        [&](double station, double x) { return geometry.blade_point(station, at(station, x)); },
        [&](double station, double x) { return 2.0 * geometry.half_width(kind, station, at(station, x)); });
  };
  const double above = part([](double end, double x) { return end + (1.0 - end) * x; });
  return wheel.plan.elements.fillet == 0 ? above : above + part([](double end, double x) { return end * x * x; });
}

// The normal of the face that is turned away from the axis, at one of its nodes.
Eigen::Vector3d tip_normal(const MeshedSector& mesh, const SectorCell& cell, std::size_t node) {
  const CellKind& kind = mesh.kind();
  Eigen::Matrix3Xd places(3, cell.nodes.size());
  for (std::size_t n = 0; n < cell.nodes.size(); ++n)
    places.col(static_cast<Eigen::Index>(n)) = mesh.nodes[cell.nodes[n]];
  const Eigen::Matrix3d jacobian = places * kind.gradient(kind.places[node]);
  return jacobian.col(0).cross(jacobian.col(1)).normalized();
}

Eigen::Vector3d turned(const MeshedSector& mesh, std::size_t node) {
  return Eigen::AngleAxisd(2.0 * std::numbers::pi / mesh.sector_count, Eigen::Vector3d::UnitZ()) * mesh.nodes[node];
}

}  // namespace

double geometry_volume(const Wheel& wheel) {
  const WheelGeometry& geometry = *wheel.geometry;
  const SectorPlan& plan = wheel.plan;
  const Section disc = [&](double station, double height) { return geometry.disc_point(station, height); };
  double volume = 0.0;
  if (plan.has_disc()) volume += volume_between(plan, 0, disc, [&](double, double) { return plan.pitch(); });
  if (plan.blades != Blades::none) volume += blade_volume(wheel, BladeKind::main, 0);
  if (plan.blades == Blades::main_and_splitter)
    volume += blade_volume(wheel, BladeKind::splitter, plan.elements.upstream);
  return volume;
}

std::set<std::size_t> nodes_on(const MeshedSector& mesh, const std::string& surface) {
  const std::vector<std::size_t>& nodes = mesh.surface(surface).face_nodes;
  return {nodes.begin(), nodes.end()};
}

std::vector<std::array<std::size_t, 2>> cyclic_pairs(const MeshedSector& mesh) {
  const std::set<std::size_t> highs = nodes_on(mesh, "cyclic_high");
  std::vector<std::array<std::size_t, 2>> pairs;
  for (const std::size_t low : nodes_on(mesh, "cyclic_low")) {
    const Eigen::Vector3d place = turned(mesh, low);
    const auto nearer = [&](std::size_t a, std::size_t b) {
      return (mesh.nodes[a] - place).norm() < (mesh.nodes[b] - place).norm();
    };
    pairs.push_back({low, *std::min_element(highs.begin(), highs.end(), nearer)});
  }
  return pairs;
}

double pairing_mismatch(const MeshedSector& mesh) {
  double mismatch = 0.0;
  for (const auto& [low, high] : cyclic_pairs(mesh))
    mismatch = std::max(mismatch, (turned(mesh, low) - mesh.nodes[high]).norm());
  return mismatch;
}

std::vector<Eigen::Vector3d> contact_normals(const MeshedSector& mesh) {
  std::vector<Eigen::Vector3d> sums(mesh.contact.size(), Eigen::Vector3d::Zero());
  const int top_layer = std::max_element(mesh.cells.begin(), mesh.cells.end(), [](const auto& a, const auto& b) {
                          return a.layer < b.layer;
                        })->layer;
  for (const SectorCell& cell : mesh.cells) {
    if (cell.layer != top_layer || cell.region == Region::splitter) continue;
    for (std::size_t n = 0; n < cell.nodes.size(); ++n) {
      const auto found = std::find(mesh.contact.begin(), mesh.contact.end(), cell.nodes[n]);
      if (found != mesh.contact.end()) sums[found - mesh.contact.begin()] += tip_normal(mesh, cell, n);
    }
  }
  for (Eigen::Vector3d& sum : sums) sum.normalize();
  return sums;
}

double angle_from_radial_deg(const Eigen::Vector3d& normal, const Eigen::Vector3d& at) {
  const double radial = normal.head<2>().dot(at.head<2>()) / at.head<2>().norm();
  return std::atan2(-normal[2], radial) * 180.0 / std::numbers::pi;
}

}  // namespace tiprub::mesh::test
