// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/contact_unknowns.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>

#include "mesh/cells/cell_kind.h"
#include "mesh/cells/gauss_points.h"
#include "reduce/sector/added_functions.h"
#include "reduce/sector/contact_line.h"
#include "reduce/sector/cubic_bricks.h"

namespace tiprub::reduce {

namespace {

struct FacePoint {
  FacePoint(int nodes, double s, double t, double share)
      : shape(face_shape(nodes, s, t)),
        cubic(cubic_shape(Eigen::Vector2d(s, t))),
        added(AddedFunctions::on_face(nodes, s, t)),
        weight(share) {}
  Eigen::MatrixX3d shape;     // N, dN/ds, dN/dt; nodes x 3
  Eigen::VectorXd cubic;      // the functions of a cubic brick's face
  std::vector<double> added;  // see AddedFunctions::on_face()
  double weight;
};

/// The hats have kinks inside faces, so each face is integrated in parts, with 3 x 3 Gauss points in each. A triangle
/// is a square of which one side is drawn together.
std::vector<FacePoint> face_points(int nodes) {
  constexpr int parts = 8, triangle_nodes = 6;
  const auto gauss = [](int k) { return gauss_points(3)[static_cast<std::size_t>(k % 3)]; };
  const auto at = [&](int k) {
    const int part = k / 3;
    return (2 * part + 1 + gauss(k).x) / parts - 1;
  };
  std::vector<FacePoint> points;
  for (int i = 0; i < 3 * parts; ++i)
    for (int j = 0; j < 3 * parts; ++j) {
      const double share = gauss(i).weight * gauss(j).weight / (parts * parts), s = (1 + at(i)) / 2,
                   t = (1 + at(j)) / 2;
      if (nodes == triangle_nodes)
        points.emplace_back(nodes, s, (1 - s) * t, share * (1 - s) / 4);
      else
        points.emplace_back(nodes, at(i), at(j), share);
    }
  return points;
}

/// The tip of one blade, and the names of its groups.
struct BladeTip {
  const char *faces_group, *line_group, *blade;
  const Eigen::MatrixXi& faces;
  const std::vector<int>& line;
  const SignedNodes* cubic;  ///< of the faces of cubic bricks; else null
};

/// The tip's nodes, and the weights of the segments on them before they are scaled: int N w_k dA.
class TipIntegrals {
 public:
  TipIntegrals(const SectorMesh& mesh, const BladeTip& tip, int count) : mesh_(mesh), count_(count) {
    for (const int node : tip.faces.reshaped())
      if (node >= 0) number_.try_emplace(node, 0);
    if (tip.cubic != nullptr)
      for (const int node : tip.cubic->node.reshaped()) number_.try_emplace(node, 0);
    for (auto& [node, number] : number_) {
      number = static_cast<int>(nodes.size());
      nodes.push_back(node);
      points += mesh.cubic == nullptr || node < mesh.cubic->points;
    }
    arc_length = arc_lengths_beside(mesh, tip.line, nodes);
    length_ = arc_lengths_beside(mesh, tip.line, {tip.line.back()})[0];
    loads = Eigen::MatrixXd::Zero(count, static_cast<Eigen::Index>(nodes.size()));
    for (Eigen::Index face = 0; face < tip.faces.cols(); ++face) add(tip, face);
  }

  /// The place of a node in `nodes`.
  int number(int node) const { return number_.at(node); }
  /// [m] Of the blade's own line.
  double length() const { return length_; }

  std::vector<int> nodes;  ///< points, then those that stand for odd functions of cubic bricks
  Eigen::Index points = 0;
  Eigen::VectorXd arc_length;                               ///< [m] of each node, along the blade's own line
  Eigen::MatrixXd loads;                                    ///< [m^2] segments x nodes
  std::map<std::vector<int>, Eigen::VectorXd> added_loads;  ///< [m^2] likewise of the functions that the cells lack

 private:
  /// w_k dA at a point of a face, of the two segments that are not zero there.
  struct Hats {
    int before;
    double first, second;
  };

  void add(const BladeTip& tip, Eigen::Index face) {
    const Eigen::VectorXi corners = nodes_of(tip.faces, face);
    const int count = static_cast<int>(corners.size());
    std::vector<FacePoint>& places = places_[count];
    if (places.empty()) places = face_points(count);
    const std::vector<AddedToFace> added = added_to(corners);
    for (const FacePoint& place : places) {
      const Eigen::VectorXd quadratic = place.shape.col(0);
      const Hats hats = hats_at(corners, place);
      if (tip.cubic == nullptr)
        add(corners, quadratic, hats);
      else
        add(tip.cubic->node.col(face), place.cubic.cwiseProduct(tip.cubic->sign.col(face)), hats);
      for (std::size_t f = 0; f < added.size(); ++f) {
        const double value = added[f].sign * place.added[f];
        (*added[f].loads)[hats.before] += value * hats.first;
        if (count_ > 1) (*added[f].loads)[hats.before + 1] += value * hats.second;
      }
    }
  }

  struct AddedToFace {
    double sign;
    Eigen::VectorXd* loads;
  };

  /// In the order of AddedFunctions::of_face().
  std::vector<AddedToFace> added_to(const Eigen::VectorXi& face) {
    constexpr int triangle_nodes = 6;
    const int corners = face.size() == triangle_nodes ? 3 : 4;
    const auto least = [&](const std::vector<int>& side) {
      int number = std::numeric_limits<int>::max();
      for (const int corner : side) number = std::min(number, face[corner]);
      return number;
    };
    std::vector<AddedToFace> found;
    for (const AddedFunctions::OfFace& function : AddedFunctions::of_face(static_cast<int>(face.size()))) {
      std::vector<int> key;
      for (const int edge : function.edges) key.push_back(face[corners + edge]);
      std::ranges::sort(key);
      found.push_back({least(function.sides[1]) < least(function.sides[0]) ? -1.0 : 1.0,
                       &added_loads.try_emplace(key, Eigen::VectorXd::Zero(count_)).first->second});
    }
    return found;
  }

  void add(const Eigen::VectorXi& moving, const Eigen::VectorXd& shape, const Hats& hats) {
    for (Eigen::Index i = 0; i < moving.size(); ++i) {
      const int node = number_.at(moving[i]);
      loads(hats.before, node) += shape[i] * hats.first;
      if (count_ > 1) loads(hats.before + 1, node) += shape[i] * hats.second;
    }
  }

  Hats hats_at(const Eigen::VectorXi& face, const FacePoint& point) const {
    const Eigen::Matrix3Xd corners = mesh_.nodes(Eigen::all, face);
    const Eigen::Vector3d along_xi = corners * point.shape.col(1), along_eta = corners * point.shape.col(2);
    const double area = point.weight * along_xi.cross(along_eta).norm();
    double s = 0;
    for (Eigen::Index i = 0; i < face.size(); ++i) s += point.shape(i, 0) * arc_length[number_.at(face[i])];
    const double knot = std::clamp(s / length_, 0.0, 1.0) * (count_ - 1);
    const int before = std::min(static_cast<int>(knot), std::max(count_ - 2, 0));
    return {before, area * (1 - (knot - before)), area * (knot - before)};
  }

  const SectorMesh& mesh_;
  int count_;
  double length_ = 0;                             // [m] of the contact line
  std::map<int, int> number_;                     // of a node, in `nodes`
  std::map<int, std::vector<FacePoint>> places_;  // of a face with so many nodes
};

/// The weights, scaled so that the sum of each row over the points is one.
Eigen::MatrixXd scaled(const SectorMesh& mesh, const BladeTip& blade, const TipIntegrals& tip) {
  constexpr double least_share = 1e-3;  // of an even part of the tip
  const Eigen::VectorXd areas = tip.loads.leftCols(tip.points).rowwise().sum();
  for (Eigen::Index k = 0; k < areas.size(); ++k)
    if (!(areas[k] > least_share * areas.mean()))
      refuse(mesh, "the faces of the surface group \"", blade.faces_group, "\" leave out a stretch of the line \"",
             blade.line_group, "\", segment ", k + 1, " of ", areas.size(), "; it must hold all of the ", blade.blade,
             "'s tip, and no other surface");
  return areas.cwiseInverse().asDiagonal() * tip.loads;
}

/// Whether the displacements of the segments are independent of each other.
bool independent(const Eigen::MatrixXd& weights) {
  constexpr double least_pivot = 1e-2;  // of the largest; 0.3 or more up to the nodes along a tip, below 1e-5 beyond
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

/// The nodes of a blade's contact line that are nearest to some arc lengths of the main blade's line.
std::vector<int> nearest_nodes(const SectorMesh& mesh, const std::vector<int>& line,
                               const Eigen::VectorXd& arc_length) {
  const Eigen::VectorXd lengths = arc_lengths_beside(mesh, mesh.contact_line, line);
  std::vector<int> nodes;
  for (const double s : arc_length) {
    Eigen::Index nearest = 0;
    (lengths.array() - s).abs().minCoeff(&nearest);
    nodes.push_back(line[nearest]);
  }
  return nodes;
}

void require_tip(const SectorMesh& mesh, const BladeTip& blade) {
  if (blade.faces.size() == 0)
    refuse(mesh, "has no surface group \"", blade.faces_group, "\" with the faces of the ", blade.blade,
           "'s tip (of the cells' own kind), over which [reduce] contact = \"segments\" spreads its forces; name it "
           "in the mesher, or take \"points\"");
  if (blade.line.size() < 2)
    refuse(mesh, "the line \"", blade.line_group,
           "\" has one node, of which [reduce] contact = \"segments\" can't be made; name the whole tip "
           "line in the mesher, or take \"points\"");
}

/// [m^2] In the direction r, theta, z of the middle of a face: its normal times its area.
Eigen::Vector3d area_of(const Eigen::Matrix3Xd& corners) {
  const Eigen::Vector3d normal = corners.cols() == 3
                                     ? (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0))
                                     : (corners.col(2) - corners.col(0)).cross(corners.col(3) - corners.col(1));
  const Eigen::Vector3d middle = corners.rowwise().mean();
  const double angle = std::atan2(middle.y(), middle.x());
  return Eigen::AngleAxisd(-angle, Eigen::Vector3d::UnitZ()) * normal / 2;
}

/// The faces must be those of the tip that the line runs along, from end to end, and no flanks of the blade.
void require_faces_along_line(const SectorMesh& mesh, const BladeTip& blade, const TipIntegrals& tip,
                              const Eigen::MatrixX3d& normals) {
  constexpr double least_facing = 0.5;  // cosine between the normals of a face and of the casing beside it
  constexpr double most_beyond = 0.3;   // of the tip's area, beyond the ends of the line
  const std::string group = std::string("surface group \"") + blade.faces_group + "\"",
                    line = std::string("line \"") + blade.line_group + "\"";
  double beyond = 0, all = 0, largest = 0;
  for (Eigen::Index face = 0; face < blade.faces.cols(); ++face) {
    const Eigen::VectorXi nodes = nodes_of(blade.faces, face), corners = nodes.head(nodes.size() == 6 ? 3 : 4);
    const Eigen::Vector3d area = area_of(mesh.nodes(Eigen::all, corners));
    Eigen::RowVector3d casing = Eigen::RowVector3d::Zero();
    double s = 0;
    for (const int node : corners) {
      casing += normals.row(tip.number(node));
      s += tip.arc_length[tip.number(node)] / static_cast<double>(corners.size());
    }
    if (std::abs(casing.normalized().dot(area)) < least_facing * area.norm())
      refuse(mesh, "the face at ", mesh.place_of(corners[0]), " of the ", group,
             " does not face the casing, the surface of revolution of the ", line, "; the group must hold the ",
             blade.blade, "'s tip, and no other surface");
    all += area.norm();
    largest = std::max(largest, (mesh.nodes.col(corners[0]) - mesh.nodes.col(corners[2])).norm());
    if (s < 0 || s > tip.length()) beyond += area.norm();
  }
  const Eigen::Matrix3Xd places =
      mesh.nodes(Eigen::all, std::vector<int>(tip.nodes.begin(), tip.nodes.begin() + tip.points));
  for (const int node : blade.line)
    if ((places.colwise() - mesh.nodes.col(node)).colwise().norm().minCoeff() > largest)
      refuse(mesh, "the node at ", mesh.place_of(node), " of the ", line, " is not on the ", group,
             "; both must be those of the ", blade.blade, "'s tip");
  if (beyond > most_beyond * all)
    refuse(mesh, "the ", line, " ends before the ", group, ", of which ", std::lround(100 * beyond / all),
           " % lie beyond its ends; it must run along all of the ", blade.blade,
           "'s tip, from leading to trailing edge");
}

ContactUnknowns segments_of(const SectorMesh& mesh, const BladeTip& blade, int count) {
  require_tip(mesh, blade);
  const TipIntegrals tip(mesh, blade, count);
  const std::vector<int> points(tip.nodes.begin(), tip.nodes.begin() + tip.points);
  const Eigen::VectorXd beside = arc_lengths_beside(mesh, mesh.contact_line, points);
  const Eigen::MatrixX3d normals = normals_beside(describe_contact(mesh, blade.line), beside);
  const auto refuse_count = [&] {
    refuse(mesh, "[reduce] contact_nodes = ", count, " asks for more segments than the ", tip.nodes.size(),
           " nodes of the ", blade.blade, "'s tip can tell apart; ask for fewer, or refine the mesh along the blade");
  };
  if (count > tip.points) refuse_count();
  const Eigen::MatrixXd weights = scaled(mesh, blade, tip);
  if (!independent(weights)) refuse_count();
  require_faces_along_line(mesh, blade, tip, normals);
  const Eigen::MatrixXd means = weights.leftCols(tip.points);
  ContactLine line;
  line.kind = ContactKind::segments;
  line.position = means * cylindrical_places(mesh, points);
  line.arc_length = means * beside;
  line.normal = (means * normals).rowwise().normalized();
  line.static_shift.terms = {Eigen::MatrixX3d::Zero(count, 3)};
  ContactUnknowns unknowns{nearest_nodes(mesh, blade.line, line.arc_length), line, tip.nodes, weights};
  const Eigen::VectorXd areas = tip.loads.leftCols(tip.points).rowwise().sum();
  for (const auto& [middles, loads] : tip.added_loads) unknowns.added_weights[middles] = loads.cwiseQuotient(areas);
  return unknowns;
}

/// The segments of the main blade, then those of the splitter.
ContactUnknowns joined(const ContactUnknowns& main, const ContactUnknowns& splitter) {
  const auto below = [](const auto& first, const auto& second) {
    Eigen::MatrixXd all(first.rows() + second.rows(), first.cols());
    all << first, second;
    return all;
  };
  ContactUnknowns all = main;
  all.nodes.insert(all.nodes.end(), splitter.nodes.begin(), splitter.nodes.end());
  all.tip.insert(all.tip.end(), splitter.tip.begin(), splitter.tip.end());
  all.weights = Eigen::MatrixXd::Zero(main.weights.rows() + splitter.weights.rows(),
                                      main.weights.cols() + splitter.weights.cols());
  all.weights.topLeftCorner(main.weights.rows(), main.weights.cols()) = main.weights;
  all.weights.bottomRightCorner(splitter.weights.rows(), splitter.weights.cols()) = splitter.weights;
  for (auto& [middles, weights] : all.added_weights) {
    weights.conservativeResize(all.weights.rows());
    weights.tail(splitter.weights.rows()).setZero();
  }
  for (const auto& [middles, weights] : splitter.added_weights) {
    Eigen::VectorXd& tail = all.added_weights[middles] = Eigen::VectorXd::Zero(all.weights.rows());
    tail.tail(weights.size()) = weights;
  }
  all.line.splitter_nodes = splitter.line.size();
  all.line.position = below(main.line.position, splitter.line.position);
  all.line.normal = below(main.line.normal, splitter.line.normal);
  all.line.arc_length = below(main.line.arc_length, splitter.line.arc_length);
  all.line.static_shift.terms = {Eigen::MatrixX3d::Zero(all.line.size(), 3)};
  return all;
}

ContactKind usual_kind(const SectorMesh& mesh) {
  const bool main = mesh.tip_faces.size() > 0 && mesh.contact_line.size() > 1;
  const bool splitter =
      mesh.splitter_line.empty() || (mesh.splitter_faces.size() > 0 && mesh.splitter_line.size() > 1);
  return main && splitter ? ContactKind::segments : ContactKind::points;
}

}  // namespace

SectorDofs number_dofs(const SectorMesh& mesh, const ContactUnknowns& contact) {
  if (contact.line.kind == ContactKind::points) return number_dofs(mesh, contact.nodes);
  SectorDofs dofs = number_dofs(mesh, std::vector<int>());
  dofs.contact_loads.resize(dofs.sector(), 3 * contact.weights.rows());
  for (Eigen::Index i = 0; i < contact.weights.cols(); ++i) {
    const int first = dofs.first[contact.tip[i]];
    if (first < 0 || first >= dofs.interior)
      refuse(mesh, "the node at ", mesh.place_of(contact.tip[i]), " of the surface group \"",
             (mesh.splitter_faces.array() == contact.tip[i]).any() ? "splitter_tip" : "blade_tip",
             "\" is clamped or lies on a cyclic face; the tip must be free and inside the sector");
    for (Eigen::Index k = 0; k < contact.weights.rows(); ++k)
      for (int d = 0; d < 3; ++d)
        if (const double weight = contact.weights(k, i); weight != 0)
          dofs.contact_loads.coeffRef(first + d, 3 * k + d) = weight;
  }
  dofs.contact_loads.makeCompressed();
  return dofs;
}

ContactUnknowns choose_contact(const SectorMesh& mesh, std::optional<ContactKind> kind, int count) {
  if (kind.value_or(usual_kind(mesh)) == ContactKind::points) {
    const std::vector<int> nodes = choose_contact_nodes(mesh, count);
    return {nodes, describe_contact(mesh, nodes)};
  }
  const CubicFunctions* cubic = mesh.cubic.get();
  const BladeTip main = {"blade_tip",    "contact",         "main blade",
                         mesh.tip_faces, mesh.contact_line, cubic == nullptr ? nullptr : &cubic->tip_faces};
  if (mesh.splitter_line.empty()) return segments_of(mesh, main, count);
  const BladeTip splitter = {"splitter_tip",     "contact_splitter",
                             "splitter",         mesh.splitter_faces,
                             mesh.splitter_line, cubic == nullptr ? nullptr : &cubic->splitter_faces};
  return joined(segments_of(mesh, main, count), segments_of(mesh, splitter, count));
}

}  // namespace tiprub::reduce
