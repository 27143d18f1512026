// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/explore/page_data.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "mesh/cells/cell_kind.h"
#include "postprocess/fields/sector_geometry.h"
#include "postprocess/tables/packing.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

using nlohmann::json;

constexpr std::size_t most_nodes = 5000;  // of a sector's surface; beyond it only corners of faces are drawn

/// The free surface of a sector in triangles.
struct Surface {
  std::vector<int> nodes;              ///< the sector's nodes on the surface
  std::vector<std::uint32_t> corners;  ///< three for each triangle: indices into `nodes`
  std::vector<std::uint32_t> edges;    ///< two for each straight piece of a face's edge, likewise
};

Surface surface_of(const std::vector<SurfaceFace>& faces, Eigen::Index nodes, bool corners_only) {
  // Triangles of a face by its number of corners: of the corners only, and with the mid-side nodes.
  static const std::map<int, std::vector<int>> coarse = {{3, {0, 1, 2}}, {4, {0, 1, 2, 0, 2, 3}}};
  static const std::map<int, std::vector<int>> fine = {{3, {0, 3, 5, 1, 4, 3, 2, 5, 4, 3, 4, 5}},
                                                       {4, {0, 4, 7, 1, 5, 4, 2, 6, 5, 3, 7, 6, 4, 5, 6, 4, 6, 7}}};
  std::vector<int> place(static_cast<std::size_t>(nodes), -1);
  Surface surface;
  const auto drawn = [&](int node) {
    int& at = place[static_cast<std::size_t>(node)];
    if (at < 0) {
      at = static_cast<int>(surface.nodes.size());
      surface.nodes.push_back(node);
    }
    return static_cast<std::uint32_t>(at);
  };
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const SurfaceFace& face : faces) {
    if (face.side != SurfaceFace::Side::free) continue;
    const auto at = [&](int k) { return drawn(face.nodes[static_cast<std::size_t>(k)]); };
    for (const int k : (corners_only ? coarse : fine).at(face.corners())) surface.corners.push_back(at(k));
    for (int k = 0; k < face.corners(); ++k) {
      const std::uint32_t first = at(k), last = at((k + 1) % face.corners()),
                          middle = corners_only ? last : at(face.corners() + k);
      edges.insert(std::minmax(first, middle));
      if (!corners_only) edges.insert(std::minmax(middle, last));
    }
  }
  for (const auto& [from, to] : edges) surface.edges.insert(surface.edges.end(), {from, to});
  return surface;
}

Surface surface_of(const SectorFields& sector) {
  const std::vector<SurfaceFace> faces = sector_surface(sector);
  Surface surface = surface_of(faces, sector.nodes.cols(), false);
  return surface.nodes.size() > most_nodes ? surface_of(faces, sector.nodes.cols(), true) : surface;
}

/// Which of these nodes of the sector are drawn, as indices into the surface's nodes.
std::vector<std::uint32_t> drawn_of(const Surface& surface, const std::set<int>& nodes) {
  std::vector<std::uint32_t> drawn;
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
    if (nodes.contains(surface.nodes[i])) drawn.push_back(static_cast<std::uint32_t>(i));
  return drawn;
}

/// The nodes of the disc; empty if the mesh does not name its parts.
std::set<int> disc_nodes(const SectorFields& sector) {
  std::set<int> nodes;
  if (const auto disc = sector.parts.find(disc_part); disc != sector.parts.end() && sector.parts.size() > 1)
    for (const int cell : disc->second)
      for (const int node : nodes_of(sector.cells, cell)) nodes.insert(node);
  return nodes;
}

void add_wave(PackedArrays& arrays, const std::string& place, const WaveField& wave, const std::vector<int>& nodes) {
  const Eigen::Matrix3Xcd displacement = wave.displacement(Eigen::all, nodes);
  arrays.add_coarse(place + "/re", displacement.real());
  arrays.add_coarse(place + "/im", displacement.imag());
}

json add_modes(PackedArrays& arrays, const FieldStudy& fields, const std::vector<int>& nodes) {
  json list = json::array();
  for (const ModeField& mode : fields.modes.drawn) {
    add_wave(arrays, "mode/" + std::to_string(list.size()), mode.wave, nodes);
    list.push_back(
        {{"nodal_diameter", mode.wave.nodal_diameter}, {"family", mode.family + 1}, {"hz", mode.frequency}});
  }
  return list;
}

/// [MPa] A limit that all but a few nodes stay below; single ones, at corners of the clamp, may lie far above it.
double stress_limit(Eigen::VectorXd stress) {
  constexpr double colour_quantile = 0.999;
  const auto place =
      stress.begin() + static_cast<std::ptrdiff_t>(colour_quantile * static_cast<double>(stress.size() - 1));
  std::nth_element(stress.begin(), place, stress.end());
  return std::max(*place * mpa_per_pa, 1e-9);
}

/// The drawn node that is nearest to a place r, theta, z [m, rad, m].
std::uint32_t nearest_node(const Eigen::Vector3d& place, const Eigen::Matrix3Xd& nodes) {
  const Eigen::Vector3d there(place[0] * std::cos(place[1]), place[0] * std::sin(place[1]), place[2]);
  Eigen::Index node = 0;
  (nodes.colwise() - there).colwise().squaredNorm().minCoeff(&node);
  return static_cast<std::uint32_t>(node);
}

/// To each contact node.
std::vector<std::uint32_t> nearest_nodes(const ContactLine& contact, const Eigen::Matrix3Xd& nodes) {
  std::vector<std::uint32_t> nearest;
  for (int k = 0; k < contact.size(); ++k) nearest.push_back(nearest_node(contact.position.row(k), nodes));
  return nearest;
}

/// Where and when the stress of the vibration is largest.
json worst_of(const FieldPeak& peak, const Eigen::Matrix3Xd& nodes) {
  return {{"node", nearest_node(peak.place, nodes)},
          {"sector", peak.sector},
          {"sample", peak.sample},
          {"mpa", peak.body.vibration * mpa_per_pa},
          {"where", peak.where}};
}

json add_motion(PackedArrays& arrays, const std::vector<SpeedResponse>& speeds, const FieldStudy& fields,
                const MovingWheel& moving, const std::vector<int>& nodes, const std::string& place) {
  const auto peak = std::ranges::find(fields.peaks, moving.speed, &FieldPeak::speed);
  const auto at = std::ranges::find(speeds, moving.speed, &SpeedResponse::speed);
  json waves = json::array();
  for (std::size_t i = 0; i < moving.waves.size(); ++i) {
    add_wave(arrays, place + "/" + std::to_string(i), moving.waves[i], nodes);
    waves.push_back({{"nodal_diameter", moving.waves[i].nodal_diameter},
                     {"order", moving.motion.waves[i].engine_order},
                     {"share", moving.motion.waves[i].share}});
  }
  arrays.add_coarse(place + "/vibration", moving.stress.vibration(nodes) * mpa_per_pa);
  arrays.add_coarse(place + "/spin", moving.stress.spin(nodes) * mpa_per_pa);
  arrays.add_coarse(place + "/both", moving.stress.both(nodes) * mpa_per_pa);
  arrays.add_coarse(place + "/force",
                    at->contact_force.middleRows(moving.motion.first_sample, moving.motion.samples));
  arrays.add(place + "/clearance", at->clearance);
  return {{"index", at - speeds.begin()},
          {"rpm", moving.speed * rpm_per_rad_s},
          {"first_sample", moving.motion.first_sample},
          {"samples", moving.motion.samples},
          {"samples_per_revolution", at->samples_per_revolution},
          {"left_out", moving.motion.left_out},
          {"largest", moving.stress.displacement.maxCoeff()},
          {"worst", worst_of(*peak, fields.sector.nodes(Eigen::all, nodes))},
          {"stress_limit", stress_limit(moving.stress.both)},
          {"waves", std::move(waves)}};
}

}  // namespace

std::string wheel_data(const Response& response, const ContactLine& contact, const FieldStudy& fields) {
  PackedArrays arrays;
  const Surface surface = surface_of(fields.sector);
  arrays.add_coarse("nodes", fields.sector.nodes(Eigen::all, surface.nodes));
  arrays.add("triangles", surface.corners);
  arrays.add("edges", surface.edges);
  const std::vector<int>& clamped = fields.sector.node_set("clamped");
  arrays.add("clamped", drawn_of(surface, {clamped.begin(), clamped.end()}));
  const std::vector<std::uint32_t> disc = drawn_of(surface, disc_nodes(fields.sector));
  arrays.add("disc", disc);
  arrays.add("contact/position", contact.position.transpose());
  arrays.add("contact/node", nearest_nodes(contact, fields.sector.nodes(Eigen::all, surface.nodes)));
  arrays.add("contact/normal", contact.normal.transpose());
  arrays.add("casing/angle", response.scene.casing_angle);
  arrays.add("casing/distortion", response.scene.casing_distortion);
  json motions = json::array();
  for (const MovingWheel& moving : fields.moving)
    motions.push_back(add_motion(arrays, response.speeds, fields, moving, surface.nodes,
                                 "motion/" + std::to_string(motions.size())));
  return arrays.packed({{"has_disc", !disc.empty()},
                        {"sectors", fields.sector.sector_count},
                        {"held", response.scene.independent_sectors},
                        {"contacts", contact.size()},
                        {"radius", outer_radius(fields.sector)},
                        {"rpm", fields.speed * rpm_per_rad_s},
                        {"modes", add_modes(arrays, fields, surface.nodes)},
                        {"motions", std::move(motions)}});
}

}  // namespace tiprub::postprocess
