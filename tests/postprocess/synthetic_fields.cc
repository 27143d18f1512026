// SPDX-License-Identifier: GPL-3.0-or-later
#include "synthetic_fields.h"

#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

#include "mesh/cells/cell_kind.h"
#include "reduce/model/nodal_diameter.h"
#include "reduce/model/reduced_model.h"

namespace tiprub::postprocess::synthetic {

namespace {

constexpr int along = 6, around = 4, inward = 2;  // half bricks
constexpr double widening_1 = 1e-10, widening_2 = 1e-17;
constexpr double poisson = 0.25;

/// Where a node is in the ring, in half bricks: along the tip, around, away from it.
using Place = std::array<int, 3>;

/// r, theta, z [m, rad, m]; the contact nodes of model() at {2 k, 2, 0}.
Eigen::Vector3d position(const Place& at, double alpha) {
  const double turn = 0.5 * std::numbers::pi * at[0] / along, radius = 0.04 + 0.0075 * at[2];
  return {0.1 - radius * std::cos(turn), 0.075 * at[0] + alpha * (static_cast<double>(at[1]) / around - 0.5),
          radius * std::sin(turn)};
}

double pitch(const ReducedModel& model) {
  return 2 * std::numbers::pi / model.sector_count;
}

struct Ring {
  std::map<Place, int> number;
  std::vector<Place> places;
  Eigen::MatrixXi cells{20, along / 2 * around / 2};
};

Ring ring() {
  Ring made;
  int cell = 0;
  for (int i = 1; i < along; i += 2)
    for (int k = 1; k < around; k += 2, ++cell)
      for (int node = 0; node < made.cells.rows(); ++node) {
        const Eigen::Vector3i corner = cell_kind(20).places[static_cast<std::size_t>(node)].cast<int>();
        const Place at = {i + corner[0], k + corner[1], 1 + corner[2]};
        const auto [known, is_new] = made.number.try_emplace(at, static_cast<int>(made.places.size()));
        if (is_new) made.places.push_back(at);
        made.cells(node, cell) = known->second;
      }
  return made;
}

/// Shape of a dof at a node, r, theta, z: hats around the contact nodes, then waves that vanish on the tip line.
Eigen::Vector3cd shape(Eigen::Index dof, int nodal_diameter, const ReducedModel& model, const Place& at) {
  const std::complex<double> i(0, 1);
  const Eigen::Vector3d place = position(at, pitch(model));
  if (nodal_diameter == 2 && dof == model.contact_dofs())
    return place[0] * std::exp(2.0 * i * place[1]) * Eigen::Vector3cd(1, i, 0);
  const std::complex<double> wave =
      std::exp(i * (nodal_diameter * pitch(model) * (static_cast<double>(at[1]) / around - 0.5)));
  const double size = dof < model.contact_dofs()
                          ? std::max(0.0, 1 - 0.5 * std::abs(at[0] - 2 * static_cast<int>(dof / 3)))
                          : 0.3 * at[2] * std::sin(1.0 + static_cast<double>(dof) * at[0]);
  return size * wave * Eigen::Vector3cd::Unit(dof % 3);
}

}  // namespace

double spin_strain(double speed) {
  return widening_1 * speed * speed + widening_2 * std::pow(speed, 4);
}

double vibration_strain(double speed) {
  return 1.2e-7 * speed;
}

double mean_strain(double speed) {
  return 0.4e-7 * speed;
}

double alternating_strain(double speed) {
  return 1.6e-7 * speed;
}

SectorFields sector_fields(const ReducedModel& model) {
  const Ring made = ring();
  const auto nodes = static_cast<Eigen::Index>(made.places.size());
  SectorFields sector;
  sector.sector_count = model.sector_count;
  sector.young = 2 * shear_modulus * (1 + poisson);
  sector.poisson = poisson;
  sector.density = 4400;
  sector.cells = made.cells;
  sector.nodes.resize(3, nodes);
  sector.static_displacement.terms.assign(2, Eigen::Matrix3Xd::Zero(3, nodes));
  for (const char* name : {"clamped", "contact", "cyclic_low", "cyclic_high"}) sector.node_sets[name];
  for (int node = 0; node < nodes; ++node) {
    const Place& at = made.places[static_cast<std::size_t>(node)];
    const Eigen::Vector3d place = position(at, pitch(model));
    sector.nodes.col(node) << place[0] * std::cos(place[1]), place[0] * std::sin(place[1]), place[2];
    sector.static_displacement[1](0, node) = widening_1 * place[0];
    sector.static_displacement[2](0, node) = widening_2 * place[0];
    if (at[2] == inward) sector.node_sets["clamped"].push_back(node);
    if (at[1] != 0) continue;
    sector.node_sets["cyclic_low"].push_back(node);
    sector.node_sets["cyclic_high"].push_back(made.number.at({at[0], around, at[2]}));
  }
  for (int k = 0; k < model.contact.size(); ++k)
    sector.node_sets["contact"].push_back(made.number.at({2 * k, around / 2, 0}));
  for (int cell = 0; cell < made.cells.cols(); ++cell) sector.parts["ring"].push_back(cell);
  return sector;
}

void write_fields(const ReducedModel& model, const std::filesystem::path& path) {
  write_fields(model, sector_fields(model), path);
}

void write_fields(const ReducedModel& model, const SectorFields& sector, const std::filesystem::path& path) {
  const Ring made = ring();
  FieldsWriter writer(path, "test");
  writer.write_sector(sector);
  for (int n = 0; n <= model.nodal_diameter_max(); ++n) {
    const bool standing = is_standing(n, model.sector_count);
    writer.write_basis(
        n, model.nodal_diameters[static_cast<std::size_t>(n)].M.rows(), standing, [&](Eigen::Index dof) {
          Eigen::VectorXcd column(3 * static_cast<Eigen::Index>(made.places.size()));
          for (std::size_t node = 0; node < made.places.size(); ++node)
            column.segment<3>(3 * static_cast<Eigen::Index>(node)) = shape(dof, n, model, made.places[node]);
          if (standing) column.imag().setZero();
          return column;
        });
  }
  writer.close(digest(model));
}

void add_snapshots(const ReducedModel& model, Response& response) {
  const std::vector<int>& moving = response.scene.nodal_diameters;
  for (SpeedResponse& at : response.speeds) {
    if (!at.failure.empty()) continue;
    RotorSnapshot snapshot;
    const double of_independent = at.contact_force.rowwise().sum().maxCoeff(&snapshot.sample);
    snapshot.force = of_independent * response.scene.sector_count / response.scene.independent_sectors;
    for (const int n : moving) {
      snapshot.displacement.emplace_back(
          Eigen::VectorXcd::Zero(model.nodal_diameters[static_cast<std::size_t>(n)].M.rows()));
      if (n == 2) snapshot.displacement.back()[model.contact_dofs()] = vibration_strain(at.speed);
    }
    at.snapshot = std::move(snapshot);
  }
}

void add_cycles(const ReducedModel& model, Response& response) {
  for (SpeedResponse& at : response.speeds) {
    if (!at.failure.empty()) continue;
    RotorCycle cycle;
    const Eigen::Index samples = at.samples_per_revolution;
    cycle.first_sample = static_cast<int>(at.displacement.rows() - samples);
    Eigen::Index hardest = 0;
    at.contact_force.bottomRows(samples).rowwise().sum().maxCoeff(&hardest);
    for (const int n : response.scene.nodal_diameters) {
      const Eigen::Index dofs = model.nodal_diameters[static_cast<std::size_t>(n)].M.rows();
      cycle.displacement.emplace_back(Eigen::MatrixXcd::Zero(dofs, samples));
      for (Eigen::Index s = 0; n == 2 && s < samples; ++s)
        cycle.displacement.back()(model.contact_dofs(), s) =
            mean_strain(at.speed) +
            std::polar(
                alternating_strain(at.speed),
                2 * std::numbers::pi * (static_cast<double>(s - hardest) / static_cast<double>(samples) + 0.5));
    }
    at.cycle = std::move(cycle);
  }
}

}  // namespace tiprub::postprocess::synthetic
