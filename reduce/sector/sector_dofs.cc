// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/sector_dofs.h"

#include <metis.h>
#include <signal.h>

#include <algorithm>
#include <new>

#include "cases/program/errors.h"

namespace tiprub::reduce {

namespace {

enum class Place { interior, low, high, contact, clamped };

std::vector<Place> place_nodes(const SectorMesh& mesh, const std::vector<int>& contact) {
  std::vector<Place> places(mesh.node_count(), Place::interior);
  for (const int node : mesh.cyclic_low) places[node] = Place::low;
  for (const int node : mesh.cyclic_high) places[node] = Place::high;
  for (const int node : contact) {
    if (places[node] != Place::interior)
      refuse(mesh, "the contact node at ", mesh.place_of(node),
             " lies on a cyclic face; a contact node must be inside the sector");
    places[node] = Place::contact;
  }
  // A clamped node stays clamped on a cut face too, and its partner is clamped with it.
  for (const int node : mesh.clamped) {
    if (places[node] == Place::contact)
      refuse(mesh, "the contact node at ", mesh.place_of(node), " is clamped; a contact node must be free");
    places[node] = Place::clamped;
  }
  for (std::size_t k = 0; k < mesh.cyclic_low.size(); ++k)
    if (places[mesh.cyclic_low[k]] == Place::clamped || places[mesh.cyclic_high[k]] == Place::clamped)
      places[mesh.cyclic_low[k]] = places[mesh.cyclic_high[k]] = Place::clamped;
  return places;
}

std::vector<idx_t> order_by_metis(std::vector<idx_t>& start, std::vector<idx_t>& adjacent) {
  idx_t count = static_cast<idx_t>(start.size()) - 1;
  std::vector<idx_t> order(start.size() - 1), position(start.size() - 1);
  const int result =
      METIS_NodeND(&count, start.data(), adjacent.data(), nullptr, nullptr, order.data(), position.data());
  // METIS (Karypis and Kumar 1998) catches SIGTERM while it works, returns METIS_ERROR for it, and restores the
  // handler that was there: the signal is sent again, so that it ends the program as at any other time.
  if (result == METIS_ERROR) raise(SIGTERM);
  if (result == METIS_ERROR_MEMORY) throw std::bad_alloc();
  if (result != METIS_OK) throw RunError("METIS could not order the sector's nodes");
  return order;
}

/// Fill-reducing order of the interior nodes. Nodes, not dofs: a third of the graph.
std::vector<int> dissect(const std::vector<int>& interior, const std::vector<std::vector<int>>& neighbours) {
  std::vector<idx_t> local(neighbours.size(), -1);
  for (std::size_t i = 0; i < interior.size(); ++i) local[interior[i]] = static_cast<idx_t>(i);
  std::vector<idx_t> start = {0}, adjacent;
  for (const int node : interior) {
    for (const int other : neighbours[node])
      if (other != node && local[other] >= 0) adjacent.push_back(local[other]);
    start.push_back(static_cast<idx_t>(adjacent.size()));
  }
  if (adjacent.empty()) return interior;
  std::vector<int> ordered;
  for (const idx_t at : order_by_metis(start, adjacent)) ordered.push_back(interior[at]);
  return ordered;
}

}  // namespace

std::vector<std::vector<int>> node_neighbours(const SectorMesh& mesh) {
  std::vector<std::vector<int>> neighbours(mesh.node_count());
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const std::vector<int> nodes = mesh.moving_nodes(cell);
    for (const int node : nodes) neighbours[node].insert(neighbours[node].end(), nodes.begin(), nodes.end());
  }
  if (mesh.matrices != nullptr)
    for (const Eigen::SparseMatrix<double>* matrix : {&mesh.matrices->mass, &mesh.matrices->stiffness.front()})
      for (int column = 0; column < matrix->outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator at(*matrix, column); at; ++at)
          neighbours[column / 3].push_back(static_cast<int>(at.row()) / 3);
  for (auto& list : neighbours) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbours;
}

std::vector<std::vector<int>> lower_neighbours(const SectorMesh& mesh, const SectorDofs& dofs) {
  const std::vector<std::vector<int>> neighbours = node_neighbours(mesh);
  std::vector<std::vector<int>> lower(static_cast<std::size_t>(dofs.sector() / 3));
  for (int node = 0; node < mesh.node_count(); ++node) {
    if (dofs.first[node] < 0) continue;
    std::vector<int>& rows = lower[dofs.first[node] / 3];
    for (const int other : neighbours[node])
      if (dofs.first[other] >= dofs.first[node]) rows.push_back(dofs.first[other] / 3);
    std::ranges::sort(rows);
  }
  return lower;
}

// eq. 5: i first, then c (low, high), then b.
SectorDofs number_dofs(const SectorMesh& mesh, const std::vector<int>& contact) {
  const std::vector<Place> places = place_nodes(mesh, contact);
  SectorDofs dofs;
  dofs.contact = contact;
  dofs.first.assign(mesh.node_count(), -1);
  int next = 0;
  const auto number = [&](int node) {
    if (mesh.nodes.col(node).head<2>().norm() == 0.0)
      refuse(mesh, "the node at ", mesh.place_of(node), " lies on the axis and is free; clamp it, or bore the wheel");
    dofs.first[node] = next;
    next += 3;
  };
  std::vector<int> interior;
  for (int node = 0; node < mesh.node_count(); ++node)
    if (places[node] == Place::interior) interior.push_back(node);
  for (const int node : dissect(interior, node_neighbours(mesh))) number(node);
  dofs.interior = next;
  for (const auto* face : {&mesh.cyclic_low, &mesh.cyclic_high})
    for (const int node : *face)
      if (places[node] != Place::clamped) number(node);
  dofs.face = (next - dofs.interior) / 2;
  for (const int node : contact) number(node);
  dofs.contact_loads.resize(dofs.sector(), dofs.boundary());
  for (int k = 0; k < dofs.boundary(); ++k) dofs.contact_loads.insert(dofs.sector() - dofs.boundary() + k, k) = 1.0;
  dofs.contact_loads.makeCompressed();
  return dofs;
}

Eigen::Matrix3d cylindrical_frame(const Eigen::Vector3d& position) {
  const double r = position.head<2>().norm();
  const double c = r > 0 ? position.x() / r : 1.0, s = r > 0 ? position.y() / r : 0.0;
  Eigen::Matrix3d frame;
  frame << c, -s, 0, s, c, 0, 0, 0, 1;
  return frame;
}

Eigen::Matrix3Xd cartesian_displacement(const SectorMesh& mesh, const SectorDofs& dofs,
                                        const Eigen::VectorXd& sector_vector) {
  Eigen::Matrix3Xd displacement = Eigen::Matrix3Xd::Zero(3, mesh.node_count());
  for (int node = 0; node < mesh.node_count(); ++node)
    if (dofs.first[node] >= 0)
      displacement.col(node) = cylindrical_frame(mesh.nodes.col(node)) * sector_vector.segment<3>(dofs.first[node]);
  return displacement;
}

}  // namespace tiprub::reduce
