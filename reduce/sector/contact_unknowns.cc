// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/contact_unknowns.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "cases/program/errors.h"
#include "reduce/sector/contact_line.h"

namespace tiprub {

namespace {

constexpr int face_centre = 8;
constexpr std::array<std::array<int, 2>, 9> face_node = {
    {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}}};  // gmsh's order

/// Quadratic shape function of a line and its derivative, for the node at -1, 0 or 1.
std::array<double, 2> on_line(int node, double x) {
  if (node == 0) return {1 - x * x, -2 * x};
  return {x * (x + node) / 2, x + node / 2.0};
}

/// Shape functions N, dN/dxi, dN/deta of a face of 8 or 9 nodes; nodes x 3. With 8 the centre follows the
/// serendipity formula, -1/4 corners + 1/2 mid-sides.
Eigen::MatrixX3d shape_at(Eigen::Index nodes, double xi, double eta) {
  Eigen::MatrixX3d shape(9, 3);
  for (int i = 0; i < 9; ++i) {
    const auto [f, df] = on_line(face_node[i][0], xi);
    const auto [g, dg] = on_line(face_node[i][1], eta);
    shape.row(i) << f * g, df * g, f * dg;
  }
  if (nodes == 9) return shape;
  const Eigen::RowVector3d centre = shape.row(face_centre);
  for (int i = 0; i < nodes; ++i) shape.row(i) += (i < 4 ? -0.25 : 0.5) * centre;
  return shape.topRows(nodes);
}

/// The tip's nodes, and the weights of the segments on them before they are scaled: int N w_k dA.
class TipIntegrals {
 public:
  TipIntegrals(const SectorMesh& mesh, int count) : mesh_(mesh), count_(count) {
    for (const int node : mesh.tip_faces.reshaped()) number_.try_emplace(node, 0);
    for (auto& [node, number] : number_) {
      number = static_cast<int>(nodes.size());
      nodes.push_back(node);
    }
    arc_length = arc_lengths_beside(mesh, nodes);
    length_ = arc_lengths_beside(mesh, {mesh.contact_line.back()})[0];
    loads = Eigen::MatrixXd::Zero(count, static_cast<Eigen::Index>(nodes.size()));
    for (const auto& face : mesh.tip_faces.colwise()) add(face);
  }

  std::vector<int> nodes;
  Eigen::VectorXd arc_length;  ///< [m] of each node
  Eigen::MatrixXd loads;       ///< [m^2] segments x nodes

 private:
  /// Hats have kinks inside faces: each face in parts, with 3 x 3 Gauss points.
  void add(const Eigen::VectorXi& face) {
    constexpr int parts = 8;
    const std::array<double, 3> point = {-std::sqrt(0.6), 0.0, std::sqrt(0.6)}, weight = {5 / 9.0, 8 / 9.0, 5 / 9.0};
    for (int i = 0; i < 3 * parts; ++i)
      for (int j = 0; j < 3 * parts; ++j) {
        const auto at = [&](int k) {
          const int middle = 2 * (k / 3) + 1;
          return (middle + point[k % 3]) / parts - 1;
        };
        add_point(face, shape_at(face.size(), at(i), at(j)), weight[i % 3] * weight[j % 3] / (parts * parts));
      }
  }

  void add_point(const Eigen::VectorXi& face, const Eigen::MatrixX3d& shape, double weight) {
    const Eigen::Matrix3Xd corners = mesh_.nodes(Eigen::all, face);
    const Eigen::Vector3d along_xi = corners * shape.col(1), along_eta = corners * shape.col(2);
    const double area = weight * along_xi.cross(along_eta).norm();
    double s = 0;
    for (Eigen::Index i = 0; i < face.size(); ++i) s += shape(i, 0) * arc_length[number_.at(face[i])];
    const double knot = std::clamp(s / length_, 0.0, 1.0) * (count_ - 1);
    const int before = std::min(static_cast<int>(knot), std::max(count_ - 2, 0));
    for (Eigen::Index i = 0; i < face.size(); ++i) {
      const int node = number_.at(face[i]);
      loads(before, node) += area * shape(i, 0) * (1 - (knot - before));
      if (count_ > 1) loads(before + 1, node) += area * shape(i, 0) * (knot - before);
    }
  }

  const SectorMesh& mesh_;
  int count_;
  double length_ = 0;          // [m] of the contact line
  std::map<int, int> number_;  // of a node, in `nodes`
};

/// The weights, each row with the sum one.
Eigen::MatrixXd scaled(const SectorMesh& mesh, const TipIntegrals& tip) {
  constexpr double least_share = 1e-3;  // of an even part of the tip
  const Eigen::VectorXd areas = tip.loads.rowwise().sum();
  for (Eigen::Index k = 0; k < areas.size(); ++k)
    if (!(areas[k] > least_share * areas.mean()))
      throw InputError(mesh.file + ": the faces of the surface group \"blade_tip\" leave out a stretch of the line " +
                       "\"contact\", segment " + std::to_string(k + 1) + " of " + std::to_string(areas.size()) +
                       "; it must hold all of the main blade's tip, and no other surface");
  return areas.cwiseInverse().asDiagonal() * tip.loads;
}

/// Whether no segment's displacement follows from those of the others.
bool independent(const Eigen::MatrixXd& weights) {
  constexpr double least_pivot = 1e-6;  // of the largest
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(weights.transpose());
  qr.setThreshold(least_pivot);
  return qr.rank() == weights.rows();
}

/// r, theta, z; theta counted on from that of the first node, without a jump.
Eigen::MatrixX3d cylindrical_places(const SectorMesh& mesh, const std::vector<int>& nodes) {
  Eigen::MatrixX3d places(nodes.size(), 3);
  const auto angle = [&](int node) { return std::atan2(mesh.nodes(1, node), mesh.nodes(0, node)); };
  const double first = angle(nodes.front());
  for (std::size_t k = 0; k < nodes.size(); ++k)
    places.row(static_cast<Eigen::Index>(k)) << mesh.nodes.col(nodes[k]).head<2>().norm(),
        first + std::remainder(angle(nodes[k]) - first, 2 * std::numbers::pi), mesh.nodes(2, nodes[k]);
  return places;
}

/// Normals of the casing beside some arc lengths, from those at the line's nodes.
Eigen::MatrixX3d normals_beside(const ContactLine& line, const Eigen::VectorXd& arc_length) {
  Eigen::MatrixX3d normals(arc_length.size(), 3);
  for (Eigen::Index k = 0; k < arc_length.size(); ++k) {
    Eigen::Index next = 1;
    while (next + 1 < line.arc_length.size() && line.arc_length[next] < arc_length[k]) ++next;
    const double before = line.arc_length[next - 1], after = line.arc_length[next];
    const double share = std::clamp((arc_length[k] - before) / (after - before), 0.0, 1.0);
    normals.row(k) = (1 - share) * line.normal.row(next - 1) + share * line.normal.row(next);
  }
  return normals;
}

ContactLine describe_segments(const SectorMesh& mesh, const TipIntegrals& tip, const Eigen::MatrixXd& weights) {
  ContactLine segments;
  segments.kind = ContactKind::segments;
  segments.position = weights * cylindrical_places(mesh, tip.nodes);
  segments.arc_length = weights * tip.arc_length;
  const ContactLine line = describe_contact(mesh, mesh.contact_line);
  segments.normal = (weights * normals_beside(line, tip.arc_length)).rowwise().normalized();
  segments.static_shift_1 = segments.static_shift_2 = Eigen::MatrixX3d::Zero(weights.rows(), 3);
  return segments;
}

/// The nodes of the contact line that stand next to some arc lengths.
std::vector<int> nearest_nodes(const SectorMesh& mesh, const Eigen::VectorXd& arc_length) {
  const Eigen::VectorXd lengths = arc_lengths_beside(mesh, mesh.contact_line);
  std::vector<int> nodes;
  for (const double s : arc_length) {
    Eigen::Index nearest = 0;
    (lengths.array() - s).abs().minCoeff(&nearest);
    nodes.push_back(mesh.contact_line[nearest]);
  }
  return nodes;
}

}  // namespace

SectorDofs number_dofs(const SectorMesh& mesh, const ContactUnknowns& contact) {
  if (contact.line.kind == ContactKind::points) return number_dofs(mesh, contact.nodes);
  SectorDofs dofs = number_dofs(mesh, std::vector<int>());
  dofs.contact_loads.resize(dofs.sector(), 3 * contact.weights.rows());
  for (Eigen::Index i = 0; i < contact.weights.cols(); ++i) {
    const int first = dofs.first[contact.tip[i]];
    if (first < 0 || first >= dofs.interior)
      throw InputError(
          mesh.file + ": the node at " + mesh.place_of(contact.tip[i]) + " of the surface group " +
          "\"blade_tip\" is clamped or lies on a cyclic face; the tip must be free and inside the sector");
    for (Eigen::Index k = 0; k < contact.weights.rows(); ++k)
      for (int d = 0; d < 3; ++d)
        if (const double weight = contact.weights(k, i); weight != 0)
          dofs.contact_loads.coeffRef(first + d, 3 * k + d) = weight;
  }
  dofs.contact_loads.makeCompressed();
  return dofs;
}

ContactUnknowns choose_contact(const SectorMesh& mesh, ContactKind kind, int count) {
  const std::vector<int> nodes = choose_contact_nodes(mesh, count);
  if (kind == ContactKind::points) return {nodes, describe_contact(mesh, nodes)};
  if (mesh.tip_faces.size() == 0)
    throw InputError(mesh.file +
                     ": has no surface group \"blade_tip\" with the faces of the main blade's tip (8-node " +
                     "ones of 20-node bricks, 9-node ones of 27-node bricks), over which [reduce] contact = " +
                     "\"segments\" spreads its forces; name it in the mesher, or take \"points\"");
  if (mesh.contact_line.size() < 2)
    throw InputError(mesh.file +
                     ": the line \"contact\" has one node, of which [reduce] contact = \"segments\" can't " +
                     "be made; name the whole tip line in the mesher, or take \"points\"");
  const TipIntegrals tip(mesh, count);
  const Eigen::MatrixXd weights = scaled(mesh, tip);
  if (!independent(weights))
    throw InputError(mesh.file + ": [reduce] contact_nodes = " + std::to_string(count) +
                     " asks for more segments than the " + std::to_string(tip.nodes.size()) +
                     " nodes of the tip can tell apart; ask for fewer, or refine the mesh along the blade");
  ContactLine line = describe_segments(mesh, tip, weights);
  std::vector<int> centres = nearest_nodes(mesh, line.arc_length);
  return {std::move(centres), std::move(line), tip.nodes, weights};
}

}  // namespace tiprub
