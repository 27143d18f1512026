// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/finite_elements.h"

#include <deal.II/base/multithread_info.h>
#include <deal.II/base/work_stream.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/grid/tria.h>
#include <deal.II/hp/fe_values.h>
#include <deal.II/lac/affine_constraints.h>

#include <algorithm>
#include <map>
#include <optional>

#include "mesh/cells/cell_kind.h"
#include "reduce/sector/cell_checks.h"
#include "reduce/sector/deal_element.h"
#include "reduce/sector/parallel_for.h"

namespace tiprub::reduce {

namespace {

using dealii::Point;
using Dof = dealii::types::global_dof_index;

constexpr int none = no_node;

/// The isoparametric mapping whose points are the nodes of the file.
class FileGeometry : public dealii::MappingFE<3> {
 public:
  FileGeometry(const DealElement& element, const SectorMesh& mesh, const std::vector<int>& in_mesh)
      : MappingFE(*element.geometry), element_(element), mesh_(mesh), in_mesh_(in_mesh) {}
  std::unique_ptr<dealii::Mapping<3>> clone() const override { return std::make_unique<FileGeometry>(*this); }

 protected:
  std::vector<Point<3>> compute_mapping_support_points(
      const dealii::Triangulation<3>::cell_iterator& cell) const override {
    const auto nodes = nodes_of(mesh_.cells, in_mesh_[cell->active_cell_index()]);
    const Eigen::Matrix3Xd places = mesh_.nodes(Eigen::all, nodes) * element_.from_nodes.transpose();
    std::vector<Point<3>> points;
    for (const auto& place : places.colwise()) points.emplace_back(place[0], place[1], place[2]);
    return points;
  }

 private:
  const DealElement& element_;
  const SectorMesh& mesh_;
  const std::vector<int>& in_mesh_;
};

using DofCell = dealii::DoFHandler<3>::active_cell_iterator;

std::vector<Dof> dofs_of(const DofCell& cell) {
  std::vector<Dof> dofs(cell->get_fe().n_dofs_per_cell());
  cell->get_dof_indices(dofs);
  return dofs;
}

/// A dof of a cell moves with a node by this weight.
struct Follower {
  unsigned int dof;
  Eigen::Index node;  ///< in the cell's list
  double weight;
};

/// Collects the shape functions of the nodes from those of the dofs that follow them.
void collect(const dealii::FEValues<3>& values, const std::vector<Follower>& followers, CellPoints& points) {
  const auto nodes = static_cast<Eigen::Index>(points.nodes.size());
  points.shape.setZero(nodes, values.n_quadrature_points);
  points.gradient.resize(values.n_quadrature_points);
  points.weight.resize(values.n_quadrature_points);
  points.position.resize(3, values.n_quadrature_points);
  for (const unsigned int q : values.quadrature_point_indices()) {
    points.weight[q] = values.JxW(q);
    auto& gradient = points.gradient[q];
    gradient.setZero(nodes, 3);
    for (const auto& [dof, node, weight] : followers) {
      points.shape(node, q) += weight * values.shape_value(dof, q);
      const dealii::Tensor<1, 3> slope = values.shape_grad(dof, q);
      for (int d = 0; d < 3; ++d) gradient(node, d) += weight * slope[d];
    }
    for (int d = 0; d < 3; ++d) points.position(d, q) = values.quadrature_point(q)[d];
  }
}

/// A pyramid, which deal.II doesn't have, by the table of cell_kind.h.
void evaluate_by_table(const SectorMesh& mesh, CellPoints& points) {
  const auto listed = nodes_of(mesh.cells, points.cell);
  points.nodes.assign(listed.begin(), listed.end());
  const CellKind& kind = cell_kind(static_cast<int>(listed.size()));
  const auto count = static_cast<Eigen::Index>(kind.integration.size());
  const Eigen::Matrix3Xd places = mesh.nodes(Eigen::all, listed);
  points.shape.resize(kind.nodes(), count);
  points.gradient.resize(kind.integration.size());
  points.weight.resize(count);
  for (Eigen::Index q = 0; q < count; ++q) {
    const ReferencePoint& point = kind.integration[static_cast<std::size_t>(q)];
    const Eigen::MatrixX3d slopes = kind.gradient(point.at);
    const Eigen::Matrix3d jacobian = places * slopes;  // dx/dxi
    points.shape.col(q) = kind.shape(point.at);
    points.gradient[static_cast<std::size_t>(q)] = slopes * jacobian.inverse();
    points.weight[q] = point.weight * jacobian.determinant();
  }
  points.position = places * points.shape;
}

}  // namespace

class FiniteElements::Space {
 public:
  explicit Space(const SectorMesh& mesh) : mesh_(mesh) {
    list_elements();
    triangulate();
    number();
    if (mesh.cubic == nullptr) constrain();
  }

  /// The working memory of one thread.
  struct Scratch {
    explicit Scratch(const Space& of)
        : space(of),
          values(of.mappings_, of.spaces_, of.quadratures_,
                 dealii::update_values | dealii::update_gradients | dealii::update_JxW_values |
                     dealii::update_quadrature_points) {}
    Scratch(const Scratch& other) : Scratch(other.space) {}
    const Space& space;
    dealii::hp::FEValues<3> values;
    std::vector<Follower> followers;
    CellPoints points;
  };

  int cell_count() const { return mesh_.cell_count(); }
  const CellPoints& evaluate(int cell, Scratch& scratch) const;

 private:
  void list_elements();
  void triangulate();
  void number();
  void constrain();
  void follow_nodes(const DofCell& cell, Scratch& scratch) const;
  void follow_functions(const DofCell& cell, Scratch& scratch) const;

  const SectorMesh& mesh_;
  std::vector<DealElement> elements_;  ///< of the kinds that the mesh has
  std::vector<int> element_of_;        ///< of each mesh cell; none of pyramids
  std::vector<int> in_mesh_;           ///< cell of the mesh, by cell of the triangulation
  std::vector<int> in_triangulation_;  ///< and the other way
  dealii::hp::FECollection<3> spaces_;
  dealii::hp::QCollection<3> quadratures_;
  dealii::hp::MappingCollection<3> mappings_;
  dealii::Triangulation<3> triangulation_;
  dealii::DoFHandler<3> dofs_;
  std::vector<DofCell> cells_;
  std::vector<int> node_of_;  ///< by dof; none where it is constrained
  dealii::AffineConstraints<double> constraints_;
};

void FiniteElements::Space::list_elements() {
  std::map<int, int> by_nodes;
  for (int cell = 0; cell < mesh_.cell_count(); ++cell) {
    const int count = static_cast<int>(nodes_of(mesh_.cells, cell).size());
    const auto [known, is_new] = by_nodes.try_emplace(count, none);
    const Degree degree = mesh_.cubic != nullptr ? Degree::cubic : Degree::quadratic;
    if (std::optional<DealElement> element = is_new ? deal_element(cell_kind(count), degree) : std::nullopt) {
      known->second = static_cast<int>(elements_.size());
      elements_.push_back(std::move(*element));
    }
    element_of_.push_back(known->second);
  }
  for (const DealElement& element : elements_) {
    spaces_.push_back(*element.displacement);
    quadratures_.push_back(element.points);
    mappings_.push_back(FileGeometry(element, mesh_, in_mesh_));
  }
}

/// The triangulation has the corners only; the mapping adds the other nodes.
void FiniteElements::Space::triangulate() {
  std::vector<Point<3>> corners;
  std::vector<int> corner_of(mesh_.node_count(), none);
  std::vector<dealii::CellData<3>> cells;
  for (int cell = 0; cell < mesh_.cell_count(); ++cell) {
    in_triangulation_.push_back(none);
    if (element_of_[cell] == none) continue;
    const DealElement& element = elements_[element_of_[cell]];
    dealii::CellData<3> data(element.kind->corners);
    for (std::size_t v = 0; v < data.vertices.size(); ++v) {
      const int node = mesh_.cells(element.node[v], cell);
      if (corner_of[node] == none) {
        corner_of[node] = static_cast<int>(corners.size());
        corners.emplace_back(mesh_.nodes(0, node), mesh_.nodes(1, node), mesh_.nodes(2, node));
      }
      data.vertices[v] = corner_of[node];
    }
    in_triangulation_.back() = static_cast<int>(cells.size());
    in_mesh_.push_back(cell);
    cells.push_back(data);
  }
  if (!cells.empty()) triangulation_.create_triangulation(corners, cells, {});
}

void FiniteElements::Space::number() {
  if (in_mesh_.empty()) return;
  dofs_.reinit(triangulation_);
  for (const auto& cell : dofs_.active_cell_iterators()) {
    cell->set_active_fe_index(element_of_[in_mesh_[cell->active_cell_index()]]);
    cells_.push_back(cell);
  }
  dofs_.distribute_dofs(spaces_);
  if (mesh_.cubic != nullptr) return;
  node_of_.assign(dofs_.n_dofs(), none);
  for (const auto& cell : cells_) {
    const DealElement& element = elements_[cell->active_fe_index()];
    const std::vector<Dof> dofs = dofs_of(cell);
    for (std::size_t i = 0; i < dofs.size(); ++i)
      if (element.node[i] != none)
        node_of_[dofs[i]] = mesh_.cells(element.node[i], in_mesh_[cell->active_cell_index()]);
  }
}

/// Constrains the dofs at which a brick of 20 nodes or a wedge of 15 has no node.
void FiniteElements::Space::constrain() {
  for (const auto& cell : cells_) {
    const DealElement& element = elements_[cell->active_fe_index()];
    const std::vector<Dof> dofs = dofs_of(cell);
    for (std::size_t i = 0; i < dofs.size(); ++i) {
      if (node_of_[dofs[i]] != none || constraints_.is_constrained(dofs[i])) continue;
      constraints_.add_line(dofs[i]);
      for (std::size_t j = 0; j < dofs.size(); ++j)
        if (element.node[j] != none)
          if (const double weight = element.from_nodes(static_cast<Eigen::Index>(i), element.node[j]); weight != 0)
            constraints_.add_entry(dofs[i], dofs[j], weight);
    }
  }
  constraints_.close();
}

void FiniteElements::Space::follow_nodes(const DofCell& cell, Scratch& scratch) const {
  std::vector<int>& nodes = scratch.points.nodes;
  nodes.clear();
  scratch.followers.clear();
  const auto follow = [&](unsigned int dof, Dof leader, double weight) {
    const auto at = std::ranges::find(nodes, node_of_[leader]);
    scratch.followers.push_back({dof, at - nodes.begin(), weight});
    if (at == nodes.end()) nodes.push_back(node_of_[leader]);
  };
  const std::vector<Dof> dofs = dofs_of(cell);
  for (unsigned int i = 0; i < dofs.size(); ++i) {
    if (const auto* leaders = constraints_.get_constraint_entries(dofs[i]))
      for (const auto& [leader, weight] : *leaders) follow(i, leader, weight);
    else
      follow(i, dofs[i], 1.0);
  }
}

/// The dofs of cubic displacements follow all functions of their cell.
void FiniteElements::Space::follow_functions(const DofCell& cell, Scratch& scratch) const {
  const Eigen::MatrixXd& from_cubic = elements_[cell->active_fe_index()].from_cubic;
  scratch.points.nodes = mesh_.moving_nodes(scratch.points.cell);
  scratch.followers.clear();
  for (Eigen::Index function = 0; function < from_cubic.cols(); ++function)
    for (Eigen::Index dof = 0; dof < from_cubic.rows(); ++dof)
      if (const double weight = from_cubic(dof, function); weight != 0)
        scratch.followers.push_back({static_cast<unsigned int>(dof), function,
                                     weight * mesh_.cubic->cells.sign(function, scratch.points.cell)});
}

const CellPoints& FiniteElements::Space::evaluate(int cell, Scratch& scratch) const {
  scratch.points.cell = cell;
  if (in_triangulation_[cell] == none) {
    evaluate_by_table(mesh_, scratch.points);
    return scratch.points;
  }
  const DofCell& here = cells_[in_triangulation_[cell]];
  mesh_.cubic != nullptr ? follow_functions(here, scratch) : follow_nodes(here, scratch);
  scratch.values.reinit(here);
  collect(scratch.values.get_present_fe_values(), scratch.followers, scratch.points);
  return scratch.points;
}

FiniteElements::FiniteElements(const SectorMesh& mesh, int threads) : threads_(threads) {
  require_sound_cells(mesh);
  space_ = std::make_unique<const Space>(mesh);
  visit([&](const CellPoints& points) {
    for (Eigen::Index q = 0; q < points.weight.size(); ++q)
      if (!(points.weight[q] > 0)) refuse_inverted(mesh, points.cell, points.position.col(q));
  });
}

FiniteElements::~FiniteElements() = default;

int FiniteElements::cell_count() const {
  return space_->cell_count();
}

void FiniteElements::visit(const std::function<void(const CellPoints&)>& visitor) const {
  Space::Scratch scratch(*space_);
  for (int cell = 0; cell < cell_count(); ++cell) visitor(space_->evaluate(cell, scratch));
}

void FiniteElements::integrate(const std::vector<int>& cells,
                               const std::function<Eigen::MatrixXd(const CellPoints&)>& integral,
                               const std::function<void(const CellIntegral&)>& take) const {
  const OneBlasThread one_each;
  dealii::MultithreadInfo::set_thread_limit(threads_);
  FirstException failure;  // deal.II ends the program where a task throws
  dealii::WorkStream::run(
      cells.begin(), cells.end(),
      [&](const std::vector<int>::const_iterator& cell, Space::Scratch& scratch, CellIntegral& result) {
        failure.guard([&] {
          const CellPoints& points = space_->evaluate(*cell, scratch);
          result = {points.nodes, integral(points)};
        });
      },
      [&](const CellIntegral& result) { failure.guard([&] { take(result); }); }, Space::Scratch(*space_),
      CellIntegral());
  failure.raise();
}

}  // namespace tiprub::reduce
