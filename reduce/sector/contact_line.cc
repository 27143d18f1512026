// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/contact_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "reduce/sector/sector_dofs.h"

namespace tiprub::reduce {

namespace {

Eigen::Vector2d meridional(const Eigen::Vector3d& position) {
  return {position.head<2>().norm(), position.z()};
}

/// Arc length of the meridional curve through a line's nodes.
std::vector<double> arc_lengths(const SectorMesh& mesh, const std::vector<int>& line) {
  std::vector<double> lengths = {0.0};
  for (std::size_t k = 1; k < line.size(); ++k)
    lengths.push_back(lengths.back() +
                      (meridional(mesh.nodes.col(line[k])) - meridional(mesh.nodes.col(line[k - 1]))).norm());
  return lengths;
}

/// Derivative at the middle of three points (or at an end, by the same parabola) over arc length. A single
/// node has no direction; the casing is taken as a cylinder there.
Eigen::Vector2d tangent(const SectorMesh& mesh, const std::vector<int>& line, const std::vector<double>& lengths,
                        std::size_t at) {
  if (line.size() == 1) return {0.0, 1.0};
  if (line.size() == 2) return meridional(mesh.nodes.col(line.back())) - meridional(mesh.nodes.col(line.front()));
  const std::size_t middle = std::clamp<std::size_t>(at, 1, line.size() - 2);
  const double a = lengths[middle - 1], b = lengths[middle], c = lengths[middle + 1], s = lengths[at];
  return meridional(mesh.nodes.col(line[middle - 1])) * ((s - b) + (s - c)) / ((a - b) * (a - c)) +
         meridional(mesh.nodes.col(line[middle])) * ((s - a) + (s - c)) / ((b - a) * (b - c)) +
         meridional(mesh.nodes.col(line[middle + 1])) * ((s - a) + (s - b)) / ((c - a) * (c - b));
}

/// The second derivative of the line over its arc length, along a straight continuation at its ends. Every second
/// node counts: those between the corners of the cells may lie on straight edges.
Eigen::Vector2d bend(const SectorMesh& mesh, const std::vector<int>& line, std::size_t at) {
  const std::size_t apart = line.size() < 7 ? 1 : 2, last = line.size() - 1;
  if (last < 2 * apart) return Eigen::Vector2d::Zero();
  const auto inside = [&](std::size_t k) -> Eigen::Vector2d {
    const auto point = [&](std::size_t i) { return meridional(mesh.nodes.col(line[i])); };
    const Eigen::Vector2d before = point(k) - point(k - apart), after = point(k + apart) - point(k);
    return 2 * (after.normalized() - before.normalized()) / (after.norm() + before.norm());
  };
  const std::size_t nearest = std::clamp(at, apart, last - apart);
  const std::size_t next = std::clamp(2 * nearest - at, apart, last - apart);
  return nearest == next ? inside(nearest) : Eigen::Vector2d(2 * inside(nearest) - inside(next));
}

/// Whether a normal at a node points out of the blade. Of the nodes that share a cell with it, the one that is most
/// nearly in line with the normal must lie behind it. Most of them may lie in front, where the tip bends towards the
/// casing and the cells are flat.
bool leads_outward(const SectorMesh& mesh, int node, const std::vector<int>& neighbours,
                   const Eigen::Vector2d& normal) {
  constexpr double round_the_axis = 1e-6;  // of the largest distance; a shorter way leads round the axis
  Eigen::Matrix2Xd ways(2, neighbours.size());
  for (std::size_t k = 0; k < neighbours.size(); ++k)
    ways.col(static_cast<Eigen::Index>(k)) =
        meridional(mesh.nodes.col(neighbours[k])) - meridional(mesh.nodes.col(node));
  const double largest = ways.colwise().norm().maxCoeff();
  double best = 0.0;  // cosine
  for (const auto& way : ways.colwise()) {
    const double cosine = way.norm() > round_the_axis * largest ? way.dot(normal) / way.norm() : 0.0;
    if (std::abs(cosine) > std::abs(best)) best = cosine;
  }
  return best <= 0.0;
}

constexpr const char *main_group = "contact", *splitter_group = "contact_splitter";

void require_one_way(const SectorMesh& mesh, const std::vector<int>& line, const char* group) {
  const auto step_to = [&](std::size_t k) -> Eigen::Vector2d {
    return meridional(mesh.nodes.col(line[k])) - meridional(mesh.nodes.col(line[k - 1]));
  };
  const auto refuse_at = [&](std::size_t k, const std::string& what) {
    refuse(mesh, "the line \"", group, "\" ", what, " at its point ", k + 1, " of ", line.size(), ", ",
           mesh.place_of(line[k]),
           "; it must run once from leading to trailing edge: put its points, or its curves, in that order");
  };
  constexpr double least_step = 1e-9;  // of the radius
  for (std::size_t k = 1; k < line.size(); ++k) {
    if (step_to(k).norm() <= least_step * meridional(mesh.nodes.col(line[k]))[0])
      refuse_at(k, "has two points at the same radius and z");
    if (k > 1 && step_to(k).dot(step_to(k - 1)) <= 0) refuse_at(k - 1, "turns back");
  }
}

std::vector<int> chosen_nodes(const SectorMesh& mesh, const std::vector<int>& line, const char* group, int count) {
  if (static_cast<int>(line.size()) < count)
    refuse(mesh, "the line \"", group, "\" has ", line.size(), " nodes, [reduce] contact_nodes = ", count,
           " asks for more; ask for fewer, or refine the mesh along the blade");
  if (count == 1) return {line.front()};
  const std::vector<double> lengths = arc_lengths(mesh, line);
  std::vector<int> chosen;
  std::size_t first_left = 0;
  for (int k = 0; k < count; ++k) {
    const double target = lengths.back() * k / (count - 1);
    const std::size_t last_left = line.size() - static_cast<std::size_t>(count - k);  // room for those that follow
    std::size_t best = first_left;
    for (std::size_t i = first_left; i <= last_left; ++i)
      if (std::abs(lengths[i] - target) < std::abs(lengths[best] - target)) best = i;
    chosen.push_back(line[best]);
    first_left = best + 1;
  }
  return chosen;
}

/// Unit normal of the casing at a line's node, components r and z.
Eigen::Vector2d normal_at(const SectorMesh& mesh, const std::vector<int>& line, const std::vector<double>& lengths,
                          std::size_t at, const std::vector<int>& neighbours) {
  const Eigen::Vector2d along = tangent(mesh, line, lengths, at).normalized();
  const Eigen::Vector2d normal(along.y(), -along.x());
  return leads_outward(mesh, line[at], neighbours, normal) ? normal : Eigen::Vector2d(-normal);
}

/// Adds the nodes of one blade from row `first` on; their arc lengths are left to the caller.
void describe_nodes(const SectorMesh& mesh, const std::vector<int>& line, const std::vector<int>& nodes,
                    Eigen::Index first, ContactLine& described) {
  const std::vector<double> lengths = arc_lengths(mesh, line);
  const std::vector<std::vector<int>> neighbours = node_neighbours(mesh);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const auto k = first + static_cast<Eigen::Index>(n);
    const auto at = static_cast<std::size_t>(std::ranges::find(line, nodes[n]) - line.begin());
    const Eigen::Vector3d position = mesh.nodes.col(nodes[n]);
    const Eigen::Vector2d normal = normal_at(mesh, line, lengths, at, neighbours[nodes[n]]);
    described.position.row(k) << position.head<2>().norm(), std::atan2(position.y(), position.x()), position.z();
    described.normal.row(k) << normal.x(), 0.0, normal.y();
    described.arc_length[k] = lengths[at];
  }
}

void require_forward(const SectorMesh& mesh, const ContactLine& line, const std::vector<int>& nodes) {
  for (int k = line.size() - line.splitter_nodes + 1; k < line.size(); ++k)
    if (line.arc_length[k] <= line.arc_length[k - 1])
      refuse(mesh, "the line \"", splitter_group, "\" doesn't go on along the line \"", main_group, "\" at ",
             mesh.place_of(nodes[k]), "; both must run from leading to trailing edge, below one casing");
}

}  // namespace

void require_one_way(const SectorMesh& mesh) {
  require_one_way(mesh, mesh.contact_line, main_group);
  require_one_way(mesh, mesh.splitter_line, splitter_group);
}

std::vector<int> choose_contact_nodes(const SectorMesh& mesh, int count) {
  std::vector<int> chosen = chosen_nodes(mesh, mesh.contact_line, main_group, count);
  if (mesh.splitter_line.empty()) return chosen;
  const std::vector<int> splitter = chosen_nodes(mesh, mesh.splitter_line, splitter_group, count);
  chosen.insert(chosen.end(), splitter.begin(), splitter.end());
  return chosen;
}

Eigen::VectorXd arc_lengths_beside(const SectorMesh& mesh, const std::vector<int>& line,
                                   const std::vector<int>& nodes) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const std::vector<double> lengths = arc_lengths(mesh, line);
  Eigen::VectorXd found = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Eigen::Vector2d at = meridional(mesh.nodes.col(nodes[k]));
    double nearest = infinite;
    for (std::size_t i = 1; i < lengths.size(); ++i) {
      const Eigen::Vector2d start = meridional(mesh.nodes.col(line[i - 1]));
      const Eigen::Vector2d step = meridional(mesh.nodes.col(line[i])) - start;
      const double least = i == 1 ? -infinite : 0.0, most = i + 1 == lengths.size() ? infinite : 1.0;
      const double along = std::clamp((at - start).dot(step) / step.squaredNorm(), least, most);
      const double distance = (at - start - along * step).norm();
      if (distance >= nearest) continue;
      nearest = distance;
      found[static_cast<Eigen::Index>(k)] = lengths[i - 1] + along * (lengths[i] - lengths[i - 1]);
    }
  }
  return found;
}

Eigen::MatrixXd normal_forces(const ContactLine& line) {
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(3 * line.size(), line.size());
  for (int k = 0; k < line.size(); ++k) forces.block<3, 1>(3 * k, k) = line.normal.row(k).transpose();
  return forces;
}

Eigen::VectorXd meridional_curvature(const SectorMesh& mesh, const std::vector<int>& contact,
                                     const Eigen::MatrixX3d& normals) {
  Eigen::VectorXd curvature(normals.rows());
  for (Eigen::Index k = 0; k < normals.rows(); ++k) {
    const int node = contact[static_cast<std::size_t>(k)];
    const auto& main = mesh.contact_line;
    const auto& line = std::ranges::find(main, node) != main.end() ? main : mesh.splitter_line;
    const auto at = static_cast<std::size_t>(std::ranges::find(line, node) - line.begin());
    curvature[k] = -Eigen::Vector2d(normals(k, 0), normals(k, 2)).dot(bend(mesh, line, at));
  }
  return curvature;
}

ContactLine describe_contact(const SectorMesh& mesh, const std::vector<int>& contact) {
  const auto first_of_splitter = std::ranges::find_if(
      contact, [&](int node) { return std::ranges::find(mesh.contact_line, node) == mesh.contact_line.end(); });
  const std::vector<int> main(contact.begin(), first_of_splitter), splitter(first_of_splitter, contact.end());
  const auto count = static_cast<Eigen::Index>(contact.size()),
             on_splitter = static_cast<Eigen::Index>(splitter.size());
  ContactLine line;
  line.splitter_nodes = static_cast<int>(splitter.size());
  line.position.resize(count, 3);
  line.normal.resize(count, 3);
  line.arc_length.resize(count);
  line.static_shift.terms = {Eigen::MatrixX3d::Zero(count, 3)};
  describe_nodes(mesh, mesh.contact_line, main, 0, line);
  if (splitter.empty()) return line;
  describe_nodes(mesh, mesh.splitter_line, splitter, count - on_splitter, line);
  line.arc_length.tail(on_splitter) = arc_lengths_beside(mesh, mesh.contact_line, splitter);
  require_forward(mesh, line, contact);
  return line;
}

}  // namespace tiprub::reduce
