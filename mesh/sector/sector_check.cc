// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sector/sector_check.h"

#include <Eigen/LU>
#include <array>
#include <set>
#include <sstream>

#include "cases/program/errors.h"
#include "cases/program/text.h"

namespace tiprub::mesh {

namespace {

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
  const Eigen::Map<const Eigen::Matrix3Xd> nodes(mesh.nodes.front().data(), 3, std::ssize(mesh.nodes));
  const Eigen::RowVectorXd radii = nodes.topRows<2>().colwise().norm();
  report.smallest_radius = radii.minCoeff();
  report.largest_radius = radii.maxCoeff();
  report.axial_extent = nodes.row(2).maxCoeff() - nodes.row(2).minCoeff();
}

std::string place_of(const SectorCell& cell, const Wheel& wheel) {
  constexpr std::array names = {"disc", "main blade", "splitter"};  // in the order of Region
  return text_of(names.at(static_cast<std::size_t>(cell.region)), ", at ", wheel.plan.station(2 * cell.station + 1),
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

}  // namespace

SectorReport measure_sector(const MeshedSector& mesh, const Wheel& wheel) {
  SectorReport report{};
  measure_cells(mesh, report);
  refuse_inverted(report, mesh, wheel);
  measure_dimensions(mesh, report);
  const std::vector<std::size_t>& clamped = mesh.surface("clamped").face_nodes;
  report.clamped_nodes = std::set(clamped.begin(), clamped.end()).size();
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
       << place_of(mesh.cells[report.worst_cell], wheel) << "\nvolume " << report.mesh_volume << " m^3, "
       << report.clamped_nodes << " nodes clamped, " << mesh.contact.size() << " contact nodes";
  if (!mesh.contact_splitter.empty()) text << " and " << mesh.contact_splitter.size() << " on the splitter";
  return text.str();
}

}  // namespace tiprub::mesh
