// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/cut_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>

#include "cases/program/errors.h"

namespace tiprub {

namespace {

double radius(const Eigen::Vector3d& point_at) {
  return std::hypot(point_at.x(), point_at.y());
}

/// [rad] more than 0, from a node of the lower face to the nearest one on the upper face with the same r and z.
double angle_between_faces(const SectorMesh& mesh) {
  int outermost = mesh.cyclic_low.front();
  for (const int node : mesh.cyclic_low)
    if (radius(mesh.nodes.col(node)) > radius(mesh.nodes.col(outermost))) outermost = node;
  const Eigen::Vector3d low = mesh.nodes.col(outermost);
  const auto distance = [&](int node) {
    const Eigen::Vector3d high = mesh.nodes.col(node);
    return std::hypot(radius(high) - radius(low), high.z() - low.z());
  };
  const int partner = *std::min_element(mesh.cyclic_high.begin(), mesh.cyclic_high.end(),
                                        [&](int a, int b) { return distance(a) < distance(b); });
  const Eigen::Vector3d high = mesh.nodes.col(partner);
  const double angle = std::atan2(high.y(), high.x()) - std::atan2(low.y(), low.x());
  return angle > 0 ? angle : angle + 2 * std::numbers::pi;
}

/// N, or 0 if the angle is no whole fraction of a turn.
int sectors_of(double angle) {
  constexpr double whole_number_tolerance = 1e-3;
  const double count = 2 * std::numbers::pi / angle;
  return std::abs(count - std::round(count)) > whole_number_tolerance * count ? 0
                                                                              : static_cast<int>(std::lround(count));
}

/// The partners of the nodes of the lower face.
struct Pairing {
  int sector_count = 0;
  std::vector<int> partners;  ///< of cyclic_low; -1 where there is none
  double mismatch = 0;        ///< [m] largest

  std::ptrdiff_t alone() const { return std::count(partners.begin(), partners.end(), -1); }
  bool holds(const SectorMesh& mesh) const {
    return sector_count > 0 && alone() == 0 && mesh.cyclic_low.size() == mesh.cyclic_high.size();
  }
};

/// Partners are found by z first, then by distance.
Pairing pair(const SectorMesh& mesh, double tolerance) {
  Pairing found;
  found.sector_count = sectors_of(angle_between_faces(mesh));
  if (found.sector_count == 0) return found;
  const double reach = tolerance * mesh.nodes.topRows<2>().colwise().norm().maxCoeff();
  std::multimap<double, int> by_height;
  for (const int node : mesh.cyclic_high) by_height.emplace(mesh.nodes(2, node), node);
  const Eigen::AngleAxisd turn(2 * std::numbers::pi / found.sector_count, Eigen::Vector3d::UnitZ());
  for (const int low : mesh.cyclic_low) {
    const Eigen::Vector3d target = turn * mesh.nodes.col(low);
    double nearest = reach;
    int partner = -1;
    for (auto at = by_height.lower_bound(target.z() - reach);
         at != by_height.end() && at->first <= target.z() + reach; ++at)
      if (const double gap = (mesh.nodes.col(at->second) - target).norm(); gap <= nearest) {
        nearest = gap;
        partner = at->second;
      }
    found.mismatch = std::max(found.mismatch, partner < 0 ? 0.0 : nearest);
    found.partners.push_back(partner);
  }
  return found;
}

Eigen::Vector3d centre(const SectorMesh& mesh, const std::vector<int>& nodes) {
  return mesh.nodes(Eigen::all, nodes).rowwise().mean();
}

std::string in_metres(double length) {
  std::ostringstream text;
  text << length;
  return text.str();
}

/// [m] the largest distance from a node of cyclic_low, turned, to the nearest one of cyclic_high.
double largest_mismatch(const SectorMesh& mesh, int sector_count) {
  const Eigen::AngleAxisd turn(2 * std::numbers::pi / sector_count, Eigen::Vector3d::UnitZ());
  const Eigen::Matrix3Xd high = mesh.nodes(Eigen::all, mesh.cyclic_high);
  double largest = 0;
  for (const int low : mesh.cyclic_low) {
    const Eigen::Vector3d target = turn * mesh.nodes.col(low);
    largest = std::max(largest, (high.colwise() - target).colwise().norm().minCoeff());
  }
  return largest;
}

/// Says that one face is shifted against the other, if it is; else empty.
std::string shift(const SectorMesh& mesh, int sector_count, double tolerance) {
  const Eigen::AngleAxisd turn(2 * std::numbers::pi / sector_count, Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d by = centre(mesh, mesh.cyclic_high) - turn * centre(mesh, mesh.cyclic_low);
  SectorMesh other = mesh;
  for (const int node : mesh.cyclic_high) other.nodes.col(node) -= by;
  if (!pair(other, tolerance).holds(other)) return "";
  std::ostringstream text;
  text << "cyclic_high is cyclic_low turned by 360/" << sector_count << " degrees about z and then shifted by x "
       << by.x() << ", y " << by.y() << ", z " << by.z()
       << " m; the axis of rotation must be z through the origin: shift the mesh, or re-mesh the faces";
  return text.str();
}

/// Says why the faces don't pair, if they would in another frame or under other names; else empty.
std::string cause(const SectorMesh& mesh, double tolerance) {
  SectorMesh other = mesh;
  std::swap(other.cyclic_low, other.cyclic_high);
  if (const Pairing exchanged = pair(other, tolerance); exchanged.holds(other))
    return "cyclic_low and cyclic_high are exchanged: cyclic_high must be cyclic_low turned by +360/" +
           std::to_string(exchanged.sector_count) + " degrees about z; exchange their names";
  constexpr std::array<const char*, 2> axes = {"x", "y"};
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const std::array<int, 3> order = axis == 0 ? std::array{1, 2, 0} : std::array{2, 0, 1};  // the axis comes last
    other.nodes = mesh.nodes(order, Eigen::all);
    for (int exchanged = 0; exchanged < 2; ++exchanged, std::swap(other.cyclic_low, other.cyclic_high))
      if (pair(other, tolerance).holds(other))
        return std::string("the wheel turns about ") + axes[axis] + "; the axis of rotation must be z: turn the mesh";
  }
  const int sector_count = pair(mesh, tolerance).sector_count;
  return sector_count == 0 ? "" : shift(mesh, sector_count, tolerance);
}

}  // namespace

void pair_cut_faces(SectorMesh& mesh, double tolerance) {
  Pairing found = pair(mesh, tolerance);
  if (!found.holds(mesh)) {
    if (const std::string why = cause(mesh, tolerance); !why.empty()) throw InputError(mesh.file + ": " + why);
    if (found.sector_count == 0)
      throw InputError(mesh.file + ": cyclic_high lies " +
                       std::to_string(angle_between_faces(mesh) * 180 / std::numbers::pi) +
                       " degrees after cyclic_low, which is no whole fraction of a turn; re-mesh");
    throw InputError(mesh.file + ": " + std::to_string(found.alone()) + " of " +
                     std::to_string(mesh.cyclic_low.size()) + " nodes on cyclic_low have no partner among the " +
                     std::to_string(mesh.cyclic_high.size()) + " on cyclic_high, turned by 360/" +
                     std::to_string(found.sector_count) + " degrees, within tolerance; the farthest is " +
                     in_metres(largest_mismatch(mesh, found.sector_count)) +
                     " m from the nearest; re-mesh, or raise [reduce] cyclic_tolerance");
  }
  mesh.sector_count = found.sector_count;
  mesh.cyclic_high = std::move(found.partners);
  mesh.pairing_mismatch = found.mismatch;
}

}  // namespace tiprub
