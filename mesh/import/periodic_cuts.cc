// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/periodic_cuts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "cases/program/errors.h"

namespace tiprub::mesh {

namespace {

constexpr double tolerance = 1e-5;    // of the largest radius
constexpr double least_share = 0.02;  // of a unit normal, along the circle
constexpr int fewest_faces = 2;
constexpr double whole_number_tolerance = 1e-4;

Eigen::Vector3d centre(const CellMesh& mesh, const FreeFace& face) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < face.corners(); ++k) sum += mesh.nodes.col(face.nodes[k]);
  return sum / static_cast<double>(face.corners());
}

/// The component of a face's normal along the circle through its centre.
double along_circle(const FreeFace& face, const Eigen::Vector3d& at) {
  const double r = std::hypot(at.x(), at.y());
  return r > 0 ? (face.normal.y() * at.x() - face.normal.x() * at.y()) / r : 0.0;
}

class Search {
 public:
  explicit Search(const CellMesh& mesh) : mesh_(mesh), reach_(tolerance * mesh.largest_radius()) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const Eigen::Vector3d at = centre(mesh, mesh.faces[f]);
      const double share = along_circle(mesh.faces[f], at);
      if (share < -least_share) low_.push_back({static_cast<int>(f), at});
      if (share > least_share) high_.emplace(at.z(), Face{static_cast<int>(f), at});
    }
  }

  /// Among the faces of two given cuts only, however these lie to the circle.
  Search(const CellMesh& mesh, const PeriodicCuts& cuts) : mesh_(mesh), reach_(tolerance * mesh.largest_radius()) {
    const auto at = [&](int face) { return centre(mesh, mesh.faces[static_cast<std::size_t>(face)]); };
    for (const int face : cuts.low) low_.push_back({face, at(face)});
    for (const int face : cuts.high) high_.emplace(at(face).z(), Face{face, at(face)});
  }

  /// The faces that have a partner for this number of sectors.
  PeriodicCuts of(int sector_count) const {
    PeriodicCuts cuts;
    cuts.sector_count = sector_count;
    const Eigen::AngleAxisd turn(2 * std::numbers::pi / sector_count, Eigen::Vector3d::UnitZ());
    for (const Face& face : low_)
      if (const auto partner = face_at(turn * face.at)) {
        cuts.low.push_back(face.number);
        cuts.high.push_back(*partner);
      }
    return cuts;
  }

  PeriodicCuts best() const {
    std::map<int, int> counts;  // by N
    for (const Face& face : low_)
      for (auto at = high_.lower_bound(face.at.z() - reach_); at != high_.end() && at->first <= face.at.z() + reach_;
           ++at)
        if (const int count = sectors_between(face.at, at->second.at); count > 1) ++counts[count];
    for (const auto& [count, faces] : counts)
      if (faces >= fewest_faces) return of(count);
    return {};
  }

 private:
  struct Face {
    int number;
    Eigen::Vector3d at;
  };

  std::optional<int> face_at(const Eigen::Vector3d& place) const {
    for (auto at = high_.lower_bound(place.z() - reach_); at != high_.end() && at->first <= place.z() + reach_; ++at)
      if ((at->second.at - place).norm() <= reach_) return at->second.number;
    return std::nullopt;
  }

  /// N if the angle from one place to another with the same r and z is 2 pi/N; else 0.
  int sectors_between(const Eigen::Vector3d& low, const Eigen::Vector3d& high) const {
    if (std::abs(low.head<2>().norm() - high.head<2>().norm()) > reach_) return 0;
    double angle = std::atan2(high.y(), high.x()) - std::atan2(low.y(), low.x());
    if (angle <= 0) angle += 2 * std::numbers::pi;
    const double count = 2 * std::numbers::pi / angle;
    const bool whole = std::abs(count - std::round(count)) <= whole_number_tolerance * count && count < most_sectors;
    return whole ? static_cast<int>(std::lround(count)) : 0;
  }

  const CellMesh& mesh_;
  double reach_;
  std::vector<Face> low_;
  std::multimap<double, Face> high_;  // by z
};

[[noreturn]] void refuse_part(const CellMesh& mesh, int sector_count, std::size_t paired, std::size_t all) {
  throw InputError(mesh.file + ": " + std::to_string(paired) + " of the " + std::to_string(all) +
                   " faces of a cut, turned by 360/" + std::to_string(sector_count) +
                   " degrees, are faces of the other; mesh both cuts alike (gmsh: Periodic Surface)");
}

}  // namespace

PeriodicCuts find_cuts(const CellMesh& mesh, int sector_count) {
  if (sector_count == 1) return {};
  const Search search(mesh);
  return sector_count > 1 ? search.of(sector_count) : search.best();
}

void require_whole(const CellMesh& mesh, const PeriodicCuts& cuts) {
  std::set<int> paired(cuts.low.begin(), cuts.low.end());
  paired.insert(cuts.high.begin(), cuts.high.end());
  for (const std::vector<int>* cut : {&cuts.low, &cuts.high}) {
    const std::vector<int> patch = surface_patch(mesh.faces, *cut);
    const auto alone = std::count_if(patch.begin(), patch.end(), [&](int face) { return !paired.contains(face); });
    if (alone > 0) refuse_part(mesh, cuts.sector_count, cut->size(), cut->size() + static_cast<std::size_t>(alone));
  }
}

void require_pairs(const CellMesh& mesh, const PeriodicCuts& cuts) {
  const std::size_t paired = Search(mesh, cuts).of(cuts.sector_count).low.size();
  const std::size_t all = std::max(cuts.low.size(), cuts.high.size());
  if (paired < all) refuse_part(mesh, cuts.sector_count, paired, all);
}

}  // namespace tiprub::mesh
