// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/cubic_bricks.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "mesh/cells/cell_kind.h"

namespace tiprub::reduce {

namespace {

constexpr int absent = -1;
/// The functions along an axis.
struct Along {
  enum Function { low, high, middle, odd };
};
constexpr int functions_along = 4, values_along = 3;  // of which the latter are one at a node

int power(int base, int exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

int digit(int number, int base, int axis) {
  return number / power(base, axis) % base;
}

/// The function along an axis that is one at -1, 0 or 1.
int value_at(double x) {
  return x < -0.5 ? Along::low : x > 0.5 ? Along::high : Along::middle;
}

/// A brick or a quadrangle: the nodes of the file by the functions along its axes that are one there, or absent.
struct Lattice {
  int dimensions;
  std::vector<int> nodes;  ///< 3^dimensions

  int node(const std::vector<int>& at) const {
    int index = 0;
    for (int axis = dimensions - 1; axis >= 0; --axis)
      index = values_along * index + at[static_cast<std::size_t>(axis)];
    return nodes[static_cast<std::size_t>(index)];
  }
};

/// What neighbours know a function by: the corners of its edge, face or cell, and for each axis along which it is odd
/// the corner beside the first one.
using FunctionKey = std::pair<std::vector<int>, std::vector<int>>;

struct Function {
  FunctionKey key;
  std::vector<int> nodes;  ///< of the file, on its edge, face or cell
  bool is_odd;
  double sign;         ///< against that along the axes which neighbours agree on
  Eigen::VectorXd at;  ///< the middle of its edge, face or cell
};

class CubicBricks {
 public:
  explicit CubicBricks(const SectorMesh& mesh) : given_(mesh), raised_(mesh), rank_(mesh.node_count()) {
    for (int node = 0; node < mesh.node_count(); ++node) rank_[node] = node;
    for (std::size_t k = 0; k < mesh.cyclic_low.size(); ++k) {
      rank_[mesh.cyclic_high[k]] = mesh.cyclic_low[k];
      partner_[mesh.cyclic_low[k]] = mesh.cyclic_high[k];
    }
  }

  SectorMesh run() {
    for (int cell = 0; cell < given_.cell_count(); ++cell) require_brick(cell);
    for (int cell = 0; cell < given_.cell_count(); ++cell) note(cell);
    number();
    extend_groups();
    raised_.cubic =
        std::make_shared<CubicFunctions>(CubicFunctions{given_.node_count(), points_, table(3, given_.cells),
                                                        table(2, given_.tip_faces), table(2, given_.splitter_faces)});
    return std::move(raised_);
  }

 private:
  struct Known {
    int node;  ///< its number in the end; absent at first, if it is new
    std::vector<int> nodes;
    bool is_odd;
    Eigen::Vector3d place;
  };

  void require_brick(int cell) const {
    const CellKind& kind = cell_kind(static_cast<int>(nodes_of(given_.cells, cell).size()));
    if (constexpr int brick = 8; kind.corners != brick)
      refuse(given_, given_.name_of_cell(cell), " is a ", kind.name,
             "; [reduce] element_order = 3 takes bricks of 20 or 27 nodes only: leave element_order at 2, "
             "or set refine = 1");
  }

  /// By its corners, from first to last; a cell has 3 dimensions, a face 2.
  static Lattice lattice(int dimensions, const std::vector<int>& nodes) {
    constexpr std::array<std::array<double, 2>, 9> around = {
        {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}}};  // of face_shape()
    Lattice found{dimensions, std::vector<int>(static_cast<std::size_t>(power(values_along, dimensions)), absent)};
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Eigen::Vector3d at = dimensions == 3 ? cell_kind(static_cast<int>(nodes.size())).places[k]
                                                 : Eigen::Vector3d(around[k][0], around[k][1], -1);
      int place = 0;
      for (int axis = dimensions - 1; axis >= 0; --axis) place = values_along * place + value_at(at[axis]);
      found.nodes[static_cast<std::size_t>(place)] = nodes[k];
    }
    return found;
  }

  bool comes_before(int a, int b) const { return std::pair(rank_[a], a) < std::pair(rank_[b], b); }

  Function function(const Lattice& of, int number) const;
  std::vector<int> nodes_around(const Lattice& of, const std::vector<int>& at) const;

  void note(int cell) {
    const auto listed = nodes_of(given_.cells, cell);
    const CellKind& kind = cell_kind(static_cast<int>(listed.size()));
    const Lattice nodes = lattice(3, {listed.begin(), listed.end()});
    for (int number = 0; number < power(functions_along, 3); ++number) {
      Function f = function(nodes, number);
      if (known_.contains(f.key)) continue;
      const int node = f.is_odd ? absent : nodes.node(axes(number, 3));
      known_.emplace(std::move(f.key), Known{node, std::move(f.nodes), f.is_odd,
                                             given_.nodes(Eigen::all, listed) * kind.shape(Eigen::Vector3d(f.at))});
    }
  }

  static std::vector<int> axes(int number, int dimensions) {
    std::vector<int> at;
    for (int axis = 0; axis < dimensions; ++axis) at.push_back(digit(number, functions_along, axis));
    return at;
  }

  /// Points first, then odd functions.
  void number() {
    int next = given_.node_count();
    std::vector<Eigen::Vector3d> places;
    for (const bool is_odd : {false, true}) {
      for (auto& [key, entry] : known_)
        if (entry.node == absent && entry.is_odd == is_odd) {
          entry.node = next++;
          places.push_back(entry.place);
          added_.push_back(&key);
        }
      if (!is_odd) points_ = next;
    }
    raised_.nodes.conservativeResize(Eigen::NoChange, next);
    for (std::size_t k = 0; k < places.size(); ++k)
      raised_.nodes.col(given_.node_count() + static_cast<Eigen::Index>(k)) = places[k];
  }

  /// A function belongs to a group if all nodes of its edge, face or cell do.
  void extend_groups() {
    const std::set<int> clamped(given_.clamped.begin(), given_.clamped.end());
    for (const FunctionKey* key : added_) {
      const Known& entry = known_.at(*key);
      const auto all = [&](const auto& group) {
        return std::ranges::all_of(entry.nodes, [&](int node) { return group.contains(node); });
      };
      if (all(clamped)) raised_.clamped.push_back(entry.node);
      if (!all(partner_)) continue;
      const auto high_entry = known_.find({turned(key->first), turned(key->second)});
      if (high_entry == known_.end())
        refuse(given_, "the cells divide cyclic_low and cyclic_high differently near ", place_text(entry.place),
               ", so that [reduce] element_order = 3 can't pair them; re-mesh");
      raised_.cyclic_low.push_back(entry.node);
      raised_.cyclic_high.push_back(high_entry->second.node);
    }
  }

  std::vector<int> turned(std::vector<int> corners) const {
    for (int& corner : corners) corner = partner_.at(corner);
    std::ranges::sort(corners);
    return corners;
  }

  SignedNodes table(int dimensions, const Eigen::MatrixXi& given) const {
    const int count = power(functions_along, dimensions);
    SignedNodes found{Eigen::MatrixXi(count, given.cols()), Eigen::MatrixXd(count, given.cols())};
    for (Eigen::Index column = 0; column < given.cols(); ++column) {
      const auto listed = nodes_of(given, column);
      const Lattice nodes = lattice(dimensions, {listed.begin(), listed.end()});
      for (int number = 0; number < count; ++number) {
        const Function f = function(nodes, number);
        const auto known = known_.find(f.key);
        if (known == known_.end())
          refuse(given_, "the face of a tip at ", given_.place_of(nodes.nodes.front()),
                 " is no face of a cell; name faces of cells in the mesher");
        found.node(number, column) = known->second.node;
        found.sign(number, column) = f.sign;
      }
    }
    return found;
  }

  const SectorMesh& given_;
  SectorMesh raised_;
  std::vector<int> rank_;       // of a node in the order of corners
  std::map<int, int> partner_;  // on cyclic_high
  std::map<FunctionKey, Known> known_;
  std::vector<const FunctionKey*> added_;
  int points_ = 0;
};

/// All nodes of the file on the edge, face or cell of the function with these functions along the axes.
std::vector<int> CubicBricks::nodes_around(const Lattice& of, const std::vector<int>& at) const {
  std::vector<int> found;
  for (int point = 0; point < power(values_along, of.dimensions); ++point) {
    bool is_on = of.nodes[static_cast<std::size_t>(point)] != absent;
    for (int axis = 0; axis < of.dimensions; ++axis) {
      const int along = at[static_cast<std::size_t>(axis)];
      is_on = is_on && (along == Along::middle || along == Along::odd || along == digit(point, values_along, axis));
    }
    if (is_on) found.push_back(of.nodes[static_cast<std::size_t>(point)]);
  }
  return found;
}

Function CubicBricks::function(const Lattice& of, int number) const {
  const std::vector<int> at = axes(number, of.dimensions);
  Function f{{}, nodes_around(of, at), false, 1.0, Eigen::VectorXd::Zero(of.dimensions)};
  std::vector<int> first;  // corner, by its side along each axis
  for (int corner = 0; corner < power(2, of.dimensions); ++corner) {
    bool is_on = true;
    const std::vector<int> sides = {digit(corner, 2, 0), digit(corner, 2, 1), digit(corner, 2, 2)};
    for (int axis = 0; axis < of.dimensions; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      is_on = is_on && (at[a] == Along::middle || at[a] == Along::odd || at[a] == sides[a]);
    }
    if (!is_on) continue;
    f.key.first.push_back(of.node(sides));
    if (first.empty() || comes_before(of.node(sides), of.node(first))) first = sides;
  }
  for (int axis = 0; axis < of.dimensions; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    if (at[a] == Along::low || at[a] == Along::high) f.at[axis] = at[a] == Along::low ? -1 : 1;
    if (at[a] != Along::odd) continue;
    f.is_odd = true;
    if (first[a] == Along::high) f.sign = -f.sign;
    std::vector<int> beside = first;
    beside[a] = 1 - beside[a];
    f.key.second.push_back(of.node(beside));
  }
  std::ranges::sort(f.key.first);
  std::ranges::sort(f.key.second);
  return f;
}

}  // namespace

SectorMesh with_cubic_bricks(const SectorMesh& mesh) {
  return CubicBricks(mesh).run();
}

Eigen::VectorXd cubic_shape(const Eigen::VectorXd& at) {
  Eigen::VectorXd shape = Eigen::VectorXd::Ones(power(functions_along, static_cast<int>(at.size())));
  for (Eigen::Index k = 0; k < shape.size(); ++k)
    for (int axis = 0; axis < at.size(); ++axis) {
      const double x = at[axis];
      const std::array<double, functions_along> along = {x * (x - 1) / 2, x * (x + 1) / 2, 1 - x * x,
                                                         x * (1 - x * x)};
      shape[k] *= along[static_cast<std::size_t>(digit(static_cast<int>(k), functions_along, axis))];
    }
  return shape;
}

}  // namespace tiprub::reduce
