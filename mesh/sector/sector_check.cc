// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sector/sector_check.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "cases/program/errors.h"
#include "cases/program/text.h"
#include "mesh/cells/gauss_points.h"

namespace tiprub::mesh {

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

/// Where a cell is measured: its integration points, and its corners, which have no weight.
struct Sample {
  Eigen::MatrixX3d gradient;
  double weight;
};

std::vector<Sample> samples_of(const CellKind& kind) {
  std::vector<Sample> samples;
  for (const ReferencePoint& point : kind.integration) samples.push_back({kind.gradient(point.at), point.weight});
  for (int corner = 0; corner < kind.corners; ++corner)
    samples.push_back({kind.gradient(kind.places[static_cast<std::size_t>(corner)]), 0.0});
  return samples;
}

Eigen::Matrix3Xd places_of(const MeshedSector& mesh, const SectorCell& cell) {
  Eigen::Matrix3Xd places(3, cell.nodes.size());
  for (std::size_t n = 0; n < cell.nodes.size(); ++n)
    places.col(static_cast<Eigen::Index>(n)) = mesh.nodes[cell.nodes[n]];
  return places;
}

double scaled_jacobian(const Eigen::Matrix3d& jacobian) {
  return jacobian.determinant() / (jacobian.col(0).norm() * jacobian.col(1).norm() * jacobian.col(2).norm());
}

void measure_cells(const MeshedSector& mesh, SectorReport& report) {
  report.worst_scaled_jacobian = 1.0;
  report.worst_cell = 0;
  report.mesh_volume = 0.0;
  const std::vector<Sample> samples = samples_of(mesh.kind());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const Eigen::Matrix3Xd places = places_of(mesh, mesh.cells[c]);
    for (const Sample& sample : samples) {
      const Eigen::Matrix3d jacobian = places * sample.gradient;
      report.mesh_volume += sample.weight * jacobian.determinant();
      const double scaled = scaled_jacobian(jacobian);
      if (scaled >= report.worst_scaled_jacobian) continue;
      report.worst_scaled_jacobian = scaled;
      report.worst_cell = c;
    }
  }
}

void measure_dimensions(const MeshedSector& mesh, SectorReport& report) {
  double z_low = mesh.nodes[0][2], z_high = z_low;
  report.smallest_radius = report.largest_radius = mesh.nodes[0].head<2>().norm();
  for (const Eigen::Vector3d& x : mesh.nodes) {
    report.smallest_radius = std::min(report.smallest_radius, x.head<2>().norm());
    report.largest_radius = std::max(report.largest_radius, x.head<2>().norm());
    z_low = std::min(z_low, x[2]);
    z_high = std::max(z_high, x[2]);
  }
  report.axial_extent = z_high - z_low;
}

void measure_pairing(const MeshedSector& mesh, SectorReport& report) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2.0 * std::numbers::pi / mesh.sector_count, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  report.pairing_mismatch = 0.0;
  for (const auto& [low, high] : mesh.low_and_high_nodes)
    report.pairing_mismatch =
        std::max(report.pairing_mismatch, (turn * mesh.nodes[low] - mesh.nodes[high]).norm() / report.largest_radius);
}

std::set<std::size_t> nodes_on(const MeshedSector& mesh, const std::string& name) {
  const std::vector<std::size_t>& nodes = mesh.surface(name).face_nodes;
  return {nodes.begin(), nodes.end()};
}

void count_clamp(const MeshedSector& mesh, SectorReport& report) {
  const std::set<std::size_t> clamped = nodes_on(mesh, "clamped");
  report.clamped_nodes = clamped.size();
  report.clamped_cyclic_nodes = 0;
  for (const auto& pair : mesh.low_and_high_nodes)
    for (std::size_t node : pair) report.clamped_cyclic_nodes += clamped.count(node);
}

const char* name_of(Region region) {
  switch (region) {
    case Region::disc:
      return "disc";
    case Region::main_blade:
      return "main blade";
    case Region::splitter:
      return "splitter";
  }
  return "";
}

std::string place_of(const SectorCell& cell, const Wheel& wheel) {
  return text_of(name_of(cell.region), ", at ", wheel.plan.station(2 * cell.station + 1),
                 " of the meridional length (station ", cell.station + 1, " of ", wheel.plan.elements.chord,
                 ", layer ", cell.layer + 1, ", column ", cell.column + 1, ")");
}

void refuse_inverted(const SectorReport& report, const MeshedSector& mesh, const Wheel& wheel) {
  if (report.worst_scaled_jacobian > 0.0) return;
  const SectorCell& cell = mesh.cells[report.worst_cell];
  throw InputError(text_of("inverted element in the ", place_of(cell, wheel), ": scaled Jacobian ",
                           report.worst_scaled_jacobian, ", must be more than 0; look at [mesh] ",
                           wheel.geometry->keys_that_shape(cell.region)));
}

// The normal of the face that is turned away from the axis, at one of its nodes.
Eigen::Vector3d tip_normal(const MeshedSector& mesh, const SectorCell& cell, std::size_t node) {
  const CellKind& kind = mesh.kind();
  const Eigen::Matrix3d jacobian = places_of(mesh, cell) * kind.gradient(kind.places[node]);
  return jacobian.col(0).cross(jacobian.col(1)).normalized();
}

double angle_from_radial_deg(const Eigen::Vector3d& normal, const Eigen::Vector3d& at) {
  const double radial = normal.head<2>().dot(at.head<2>()) / at.head<2>().norm();
  return std::atan2(-normal[2], radial) * 180.0 / std::numbers::pi;
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

SectorReport measure_sector(const MeshedSector& mesh, const Wheel& wheel) {
  SectorReport report{};
  measure_cells(mesh, report);
  refuse_inverted(report, mesh, wheel);
  measure_dimensions(mesh, report);
  measure_pairing(mesh, report);
  count_clamp(mesh, report);
  report.geometry_volume = geometry_volume(wheel);
  const std::vector<Eigen::Vector3d> normals = contact_normals(mesh);
  report.normal_angle_leading_deg = angle_from_radial_deg(normals.front(), mesh.nodes[mesh.contact.front()]);
  report.normal_angle_trailing_deg = angle_from_radial_deg(normals.back(), mesh.nodes[mesh.contact.back()]);
  return report;
}

std::string describe(const SectorReport& report, const MeshedSector& mesh, const Wheel& wheel) {
  const ElementCounts& elements = wheel.plan.elements;
  std::ostringstream text;
  text << "radii " << report.smallest_radius << " to " << report.largest_radius << " m, axial extent "
       << report.axial_extent << " m, 1 of " << mesh.sector_count << " sectors\n"
       << mesh.nodes.size() << " nodes, " << mesh.cells.size() << " cells, " << 3 * mesh.nodes.size() << " dofs; "
       << elements.chord << " elements along the chord";
  if (wheel.plan.has_disc()) text << ", " << elements.disc << " through the disc";
  if (wheel.plan.blades != Blades::none)
    text << ", " << elements.blade << " through the blade, " << elements.span << " along its span";
  if (elements.fillet > 0) text << " (" << elements.fillet << " of them along the fillet)";
  if (wheel.plan.blades == Blades::main_and_splitter) text << ", " << elements.splitter << " through the splitter";
  text << "\nworst scaled Jacobian " << report.worst_scaled_jacobian << ", in the "
       << place_of(mesh.cells[report.worst_cell], wheel) << "\nlargest pairing mismatch " << report.pairing_mismatch
       << " R over " << mesh.low_and_high_nodes.size() << " pairs\nvolume " << report.mesh_volume
       << " m^3, relative error against the geometry " << std::abs(report.mesh_volume / report.geometry_volume - 1.0)
       << "\n"
       << report.clamped_nodes << " nodes clamped, " << report.clamped_cyclic_nodes
       << " of them on cyclic faces (the clamp wins)\n"
       << mesh.contact.size() << " contact nodes"
       << (mesh.contact_splitter.empty()
               ? ""
               : " and " + std::to_string(mesh.contact_splitter.size()) + " on the splitter")
       << ", normal " << report.normal_angle_leading_deg << " deg from radial at the leading edge, "
       << report.normal_angle_trailing_deg << " deg at the trailing edge";
  return text.str();
}

}  // namespace tiprub::mesh
