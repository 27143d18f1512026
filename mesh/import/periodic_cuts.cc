// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/periodic_cuts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "cases/program/errors.h"
#include "cases/program/text.h"

namespace tiprub::mesh {

namespace {

constexpr double tolerance = 1e-5;    // of the largest radius
constexpr double least_share = 0.02;  // of a unit normal, along the circle
constexpr std::size_t fewest_faces = 2;
constexpr double whole_number_tolerance = 1e-4;
constexpr double most_faces = 0.9;          // of the smaller cut
constexpr double unlike_cuts_agree = 0.01;  // of the largest radius, their centres
constexpr double unlike_pitch = 0.005;      // of the angle between cuts that are meshed differently

/// The centre of area of a cut: differently meshed cuts of the same shape have the same one.
Eigen::Vector3d centre(const CellMesh& mesh, const std::vector<int>& cut) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double whole = 0;
  for (const int f : cut) {
    const FreeFace& face = mesh.faces[f];
    sum += area(mesh, face) * centre(mesh, face);
    whole += area(mesh, face);
  }
  return sum / whole;
}

/// From the centre of one cut to that of the other, from -pi to pi.
double angle_between(const CellMesh& mesh, const PeriodicCuts& cuts) {
  const Eigen::Vector3d low = centre(mesh, cuts.low), high = centre(mesh, cuts.high);
  return std::remainder(std::atan2(high.y(), high.x()) - std::atan2(low.y(), low.x()), 2 * std::numbers::pi);
}

/// Whether the centres of both cuts have the same r and z.
bool at_one_place(const CellMesh& mesh, const PeriodicCuts& cuts) {
  const Eigen::Vector3d low = centre(mesh, cuts.low), high = centre(mesh, cuts.high);
  const double apart = std::hypot(low.head<2>().norm() - high.head<2>().norm(), low.z() - high.z());
  return apart <= unlike_cuts_agree * mesh.largest_radius();
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
    const auto at = [&](int face) { return centre(mesh, mesh.faces[face]); };
    for (const int face : cuts.low) low_.push_back({face, at(face)});
    for (const int face : cuts.high) high_.emplace(at(face).z(), Face{face, at(face)});
  }

  /// The faces that have a partner for this number of sectors.
  PeriodicCuts of(int sector_count) const {
    PeriodicCuts cuts = turned_by(2 * std::numbers::pi / sector_count);
    cuts.sector_count = sector_count;
    return cuts;
  }

  /// The faces that have a partner at this angle [rad].
  PeriodicCuts turned_by(double angle) const {
    PeriodicCuts cuts;
    const Eigen::AngleAxisd turn(angle, Eigen::Vector3d::UnitZ());
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
      if (static_cast<std::size_t>(faces) >= fewest_faces) return of(count);
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

bool are_most(const PeriodicCuts& pairs, const PeriodicCuts& cuts) {
  const std::size_t smaller = std::min(cuts.low.size(), cuts.high.size());
  return smaller > 0 && static_cast<double>(pairs.low.size()) >= most_faces * static_cast<double>(smaller);
}

/// What is wrong with the angle between two cuts; empty if it is 2 pi/N, as far as can be seen.
std::string wrong_pitch(const CellMesh& mesh, const PeriodicCuts& cuts) {
  const double angle = std::abs(angle_between(mesh, cuts)), count = 2 * std::numbers::pi / angle;
  if (!(count <= most_sectors)) return "the cuts are at the same angle about the axis; is axis right?";
  const bool alike = are_most(Search(mesh, cuts).turned_by(angle), cuts);
  if (!alike && std::abs(count - std::round(count)) <= unlike_pitch * count) return "";
  return text_of("the cuts are ", angle * 180 / std::numbers::pi, " degrees apart, which is 360/", count,
                 "; a sector needs 360/N");
}

}  // namespace

PeriodicCuts named_cuts(const CellMesh& mesh, const std::vector<int>& low, const std::vector<int>& high,
                        int sector_count) {
  PeriodicCuts cuts = {sector_count, low, high};
  const double angle = angle_between(mesh, cuts), least = 2 * std::numbers::pi / most_sectors;
  if (angle < 0) std::swap(cuts.low, cuts.high);
  if (sector_count == 0)
    cuts.sector_count = static_cast<int>(std::lround(2 * std::numbers::pi / std::max(std::abs(angle), least)));
  return cuts;
}

PeriodicCuts whole_cuts(const CellMesh& mesh, const PeriodicCuts& pairs) {
  return {pairs.sector_count, surface_patch(mesh.faces, pairs.low), surface_patch(mesh.faces, pairs.high)};
}

PeriodicCuts pairs_of(const CellMesh& mesh, const PeriodicCuts& cuts) {
  return Search(mesh, cuts).of(cuts.sector_count);
}

bool mostly_pair(const CellMesh& mesh, const PeriodicCuts& cuts) {
  return are_most(pairs_of(mesh, cuts), cuts);
}

bool could_be_meant(const CellMesh& mesh, const PeriodicCuts& cuts) {
  constexpr int half_turn = 2;
  return cuts.low.size() >= fewest_faces && cuts.sector_count > half_turn && mostly_pair(mesh, cuts);
}

std::string why_unpaired(const CellMesh& mesh, const PeriodicCuts& cuts) {
  if (!at_one_place(mesh, cuts))
    return "their centres differ in r or z; is each name that of a whole cut, and is axis right?";
  const std::string pitch = wrong_pitch(mesh, cuts);
  return pitch.empty() ? "mesh both cuts alike (gmsh: Periodic Surface)" : pitch;
}

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
    const auto alone = std::ranges::count_if(patch, [&](int face) { return !paired.contains(face); });
    if (alone > 0) refuse_part(mesh, cuts.sector_count, cut->size(), cut->size() + static_cast<std::size_t>(alone));
  }
}

void require_pairs(const CellMesh& mesh, const PeriodicCuts& cuts) {
  const std::size_t paired = pairs_of(mesh, cuts).low.size();
  const std::size_t all = std::max(cuts.low.size(), cuts.high.size());
  if (paired < all) refuse_part(mesh, cuts.sector_count, paired, all);
}

}  // namespace tiprub::mesh
