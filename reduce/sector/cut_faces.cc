// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/cut_faces.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cases/program/text.h"
#include "mesh/cells/cell_kind.h"
#include "mesh/cells/free_faces.h"

namespace tiprub::reduce {

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
  const int partner = *std::ranges::min_element(mesh.cyclic_high, {}, distance);
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

  std::ptrdiff_t alone() const { return std::ranges::count(partners, -1); }
  bool holds(const SectorMesh& mesh) const {
    return alone() == 0 && mesh.cyclic_low.size() == mesh.cyclic_high.size() && listed_twice(partners) < 0;
  }
};

/// With cyclic_low turned by an angle [rad]. Partners are found by z first, then by distance.
Pairing pair(const SectorMesh& mesh, double tolerance, double angle) {
  Pairing found;
  const double reach = tolerance * mesh.nodes.topRows<2>().colwise().norm().maxCoeff();
  std::multimap<double, int> by_height;
  for (const int node : mesh.cyclic_high) by_height.emplace(mesh.nodes(2, node), node);
  const Eigen::AngleAxisd turn(angle, Eigen::Vector3d::UnitZ());
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
    found.partners.push_back(partner);
  }
  return found;
}

/// With the angle between the faces, if that is a whole fraction of a turn; else nothing pairs.
Pairing pair(const SectorMesh& mesh, double tolerance) {
  const int sector_count = sectors_of(angle_between_faces(mesh));
  Pairing found = {0, std::vector<int>(mesh.cyclic_low.size(), -1)};
  if (sector_count > 0) found = pair(mesh, tolerance, 2 * std::numbers::pi / sector_count);
  found.sector_count = sector_count;
  return found;
}

Eigen::Vector3d centre(const SectorMesh& mesh, const std::vector<int>& nodes) {
  return mesh.nodes(Eigen::all, nodes).rowwise().mean();
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

/// Says that one face is shifted against the other, if it is; else empty. A shift across z is a turn about an axis
/// beside z: c with c - R c equal to it.
std::string shift(const SectorMesh& mesh, int sector_count, double tolerance) {
  const double angle = 2 * std::numbers::pi / sector_count;
  const Eigen::AngleAxisd turn(angle, Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d by = centre(mesh, mesh.cyclic_high) - turn * centre(mesh, mesh.cyclic_low);
  SectorMesh other = mesh;
  for (const int node : mesh.cyclic_high) other.nodes.col(node) -= by;
  if (!pair(other, tolerance, angle).holds(other)) return "";
  const Eigen::Vector2d axis =
      (Eigen::Matrix2d::Identity() - Eigen::Rotation2Dd(angle).toRotationMatrix()).inverse() * by.head<2>();
  return text_of("cyclic_high is cyclic_low turned by 360/", sector_count, " degrees about z and then shifted by x ",
                 by.x(), ", y ", by.y(), ", z ", by.z(),
                 " m; the axis of rotation must be z through the origin, and "
                 "these faces turn about x ",
                 axis.x(), ", y ", axis.y(), " m: shift the mesh, or re-mesh the faces");
}

/// About an axis beside z the measured angle is no whole fraction of a turn, but close to one.
std::string shift(const SectorMesh& mesh, double tolerance) {
  const int near = static_cast<int>(std::floor(2 * std::numbers::pi / angle_between_faces(mesh)));
  for (const int sector_count : {near, near + 1, near - 1, near + 2})
    if (sector_count > 1)
      if (const std::string found = shift(mesh, sector_count, tolerance); !found.empty()) return found;
  return "";
}

/// "cyclic_high lies 60.6 degrees after cyclic_low, ..."
std::string other_angle(const SectorMesh& mesh) {
  return "cyclic_high lies " + std::to_string(angle_between_faces(mesh) * 180 / std::numbers::pi) +
         " degrees after cyclic_low, which is no whole fraction of a turn; re-mesh";
}

/// Says why the faces don't pair, if they would in another frame or under other names; else empty.
std::string cause(const SectorMesh& mesh, double tolerance) {
  SectorMesh other = mesh;
  std::swap(other.cyclic_low, other.cyclic_high);
  if (const Pairing exchanged = pair(other, tolerance); exchanged.holds(other))
    return text_of("cyclic_low and cyclic_high are exchanged: cyclic_high must be cyclic_low turned by +360/",
                   exchanged.sector_count, " degrees about z; exchange their names");
  const double angle = angle_between_faces(mesh);
  if (sectors_of(angle) == 0 && pair(mesh, tolerance, angle).holds(mesh)) return other_angle(mesh);
  if (const std::string beside = shift(mesh, tolerance); !beside.empty()) return beside;
  constexpr std::array<const char*, 2> axes = {"x", "y"};
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const std::array<int, 3> order = axis == 0 ? std::array{1, 2, 0} : std::array{2, 0, 1};  // the axis comes last
    other.nodes = mesh.nodes(order, Eigen::all);
    for (int exchanged = 0; exchanged < 2; ++exchanged, std::swap(other.cyclic_low, other.cyclic_high))
      // A sector that is symmetric about x or y has cuts that a half turn about it exchanges.
      if (const Pairing turned = pair(other, tolerance); turned.sector_count > 2 && turned.holds(other))
        return std::string("the wheel turns about ") + axes[axis] + "; the axis of rotation must be z: turn the mesh";
  }
  return "";
}

/// A miss of the order of rounding may be allowed; nodes without a partner are those of another mesh.
std::string advice(double mismatch, double radius) {
  constexpr double rounding = 1e-5;  // of the radius: coordinates in a file of few digits
  return mismatch <= rounding * radius ? "raise [reduce] cyclic_tolerance, or write the mesh with more digits"
                                       : "mesh both cuts alike (gmsh: Periodic Surface)";
}

std::string not_one_to_one(const SectorMesh& mesh, const Pairing& found) {
  const std::string counts = text_of(mesh.cyclic_low.size(), " nodes on cyclic_low and ", mesh.cyclic_high.size(),
                                     " on cyclic_high do not pair one to one");
  const int twice = listed_twice(found.partners);
  if (twice < 0) return counts + "; mesh both cuts alike (gmsh: Periodic Surface)";
  return counts + ": two have the partner at " + mesh.place_of(twice) + "; merge nodes at the same place";
}

std::string alone(const SectorMesh& mesh, const Pairing& found) {
  if (found.alone() == 0) return not_one_to_one(mesh, found);
  const double farthest = largest_mismatch(mesh, found.sector_count);
  return text_of(found.alone(), " of ", mesh.cyclic_low.size(), " nodes on cyclic_low have no partner among the ",
                 mesh.cyclic_high.size(), " on cyclic_high, turned by 360/", found.sector_count,
                 " degrees, within tolerance; the farthest is ", farthest, " m from the nearest; ",
                 advice(farthest, mesh.nodes.topRows<2>().colwise().norm().maxCoeff()));
}

/// The free faces whose corners are all among these nodes.
std::vector<int> faces_among(const std::vector<FreeFace>& faces, const std::vector<int>& nodes) {
  const std::set<int> known(nodes.begin(), nodes.end());
  std::vector<int> found;
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (std::all_of(faces[f].nodes.begin(), faces[f].nodes.begin() + static_cast<std::ptrdiff_t>(faces[f].corners()),
                    [&](int node) { return known.contains(node); }))
      found.push_back(static_cast<int>(f));
  return found;
}

}  // namespace

void pair_cut_faces(SectorMesh& mesh, double tolerance) {
  Pairing found = pair(mesh, tolerance);
  if (!found.holds(mesh)) {
    if (const std::string why = cause(mesh, tolerance); !why.empty()) refuse(mesh, why);
    refuse(mesh, found.sector_count == 0 ? other_angle(mesh) : alone(mesh, found));
  }
  mesh.sector_count = found.sector_count;
  mesh.cyclic_high = std::move(found.partners);
}

void require_whole_cuts(const SectorMesh& mesh) {
  const std::vector<FreeFace> faces = free_faces(mesh.nodes, listed_cells(mesh.cells));
  const std::vector<int> low = faces_among(faces, mesh.cyclic_low), high = faces_among(faces, mesh.cyclic_high);
  std::set<int> named(low.begin(), low.end());
  named.insert(high.begin(), high.end());
  for (const auto& [name, cut] : {std::pair("cyclic_low", &low), std::pair("cyclic_high", &high)}) {
    const std::vector<int> patch = surface_patch(faces, *cut);
    const auto alone = std::ranges::count_if(patch, [&](int face) { return !named.contains(face); });
    if (alone > 0)
      refuse(mesh, name, " holds ", cut->size(), " of the ", cut->size() + static_cast<std::size_t>(alone),
             " faces of its surface; a cut is all of it: mesh both cuts alike (gmsh: Periodic Surface), and "
             "name all of their faces; where a slit continues it, cut the sector beside the slit");
  }
}

namespace {

/// The corners of the faces that lie on one of the cuts, in the places of their partners on the lower one.
std::set<std::vector<int>> corners_of_faces(const SectorMesh& mesh, const std::vector<int>& cut) {
  std::map<int, int> lower;
  for (std::size_t k = 0; k < cut.size(); ++k) lower[cut[k]] = mesh.cyclic_low[k];
  std::set<std::vector<int>> found;
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto nodes = nodes_of(mesh.cells, cell);
    for (const std::vector<int>& face : cell_kind(static_cast<int>(nodes.size())).faces) {
      std::vector<int> corners;
      for (const int corner : face)
        if (const auto known = lower.find(nodes[corner]); known != lower.end()) corners.push_back(known->second);
      std::ranges::sort(corners);
      if (corners.size() == face.size()) found.insert(corners);
    }
  }
  return found;
}

}  // namespace

bool cut_faces_are_equal(const SectorMesh& mesh) {
  return corners_of_faces(mesh, mesh.cyclic_low) == corners_of_faces(mesh, mesh.cyclic_high);
}

}  // namespace tiprub::reduce
