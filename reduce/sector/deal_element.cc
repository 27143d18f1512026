// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/deal_element.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_wedge_p.h>

#include "reduce/sector/cubic_bricks.h"

namespace tiprub::reduce {

namespace {

using dealii::Point;

/// The points of a complete quadratic element in our reference cell: the nodes, and the middles of faces and cell
/// where a brick of 20 nodes or a wedge of 15 has no node.
std::vector<Eigen::Vector3d> complete_points(const CellKind& kind, std::size_t count) {
  const auto middle_of = [&](const std::vector<int>& corners) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int corner : corners) sum += kind.places[corner];
    return Eigen::Vector3d(sum / static_cast<double>(corners.size()));
  };
  std::vector<Eigen::Vector3d> points = kind.places;
  for (const std::vector<int>& face : kind.faces)
    if (face.size() == 4 && points.size() < count) points.push_back(middle_of(face));
  if (points.size() < count) points.emplace_back(0, 0, 0);
  return points;
}

/// The same point in deal.II's reference cell. Our bricks and wedges begin at -1, those of deal.II at 0.
Point<3> in_its_cell(const Eigen::Vector3d& at, int corners) {
  constexpr int tetrahedron = 4, brick = 8;
  const auto moved = [](double x, bool moves) { return moves ? (1 + x) / 2 : x; };
  return {moved(at[0], corners == brick), moved(at[1], corners == brick), moved(at[2], corners != tetrahedron)};
}

/// The symmetric rule of the second degree: 3 points in a triangle, 4 in a tetrahedron. QGaussSimplex has more.
template <int dim>
dealii::Quadrature<dim> simplex_points() {
  constexpr bool odd_degree = false;
  return dealii::QWitherdenVincentSimplex<dim>(1, odd_degree);
}

/// Nine points: three of a triangle on each of three levels.
dealii::Quadrature<3> wedge_points() {
  const dealii::Quadrature<2> triangle = simplex_points<2>();
  const dealii::QGauss<1> line(3);
  std::vector<Point<3>> points;
  std::vector<double> weights;
  for (unsigned int k = 0; k < line.size(); ++k)
    for (unsigned int i = 0; i < triangle.size(); ++i) {
      points.emplace_back(triangle.point(i)[0], triangle.point(i)[1], line.point(k)[0]);
      weights.push_back(triangle.weight(i) * line.weight(k));
    }
  return {points, weights};
}

DealElement quadratic(const CellKind& kind, const std::shared_ptr<const dealii::FiniteElement<3>>& fe,
                      dealii::Quadrature<3> points) {
  DealElement element{&kind, fe, fe, std::move(points), {}, {}, {}};
  // At each of these points one shape function is one and the others are zero, which tells the dof that stands there:
  // FE_WedgeP(2) doesn't list its support points.
  element.from_nodes.setZero(fe->n_dofs_per_cell(), kind.nodes());
  element.node.assign(fe->n_dofs_per_cell(), no_node);
  const std::vector<Eigen::Vector3d> places = complete_points(kind, element.node.size());
  for (std::size_t at = 0; at < places.size(); ++at) {
    unsigned int dof = 0;
    while (fe->shape_value(dof, in_its_cell(places[at], kind.corners)) < 0.5) ++dof;
    const Eigen::ArrayXd quarters = (4 * kind.shape(places[at]).array()).round();
    element.from_nodes.row(dof) = quarters.matrix().transpose() / 4;
    if (at < kind.places.size()) element.node[dof] = static_cast<int>(at);
  }
  return element;
}

/// FE_Q(3) has the values at its support points for dofs.
void make_cubic(DealElement& element) {
  constexpr int degree = 3;
  element.displacement = std::make_shared<dealii::FE_Q<3>>(degree);
  element.points = dealii::QGauss<3>(degree + 1);
  const std::vector<Point<3>>& support = element.displacement->get_unit_support_points();
  element.from_cubic.resize(static_cast<Eigen::Index>(support.size()), static_cast<Eigen::Index>(support.size()));
  for (std::size_t dof = 0; dof < support.size(); ++dof)
    element.from_cubic.row(static_cast<Eigen::Index>(dof)) =
        cubic_shape(Eigen::Vector3d(2 * support[dof][0] - 1, 2 * support[dof][1] - 1, 2 * support[dof][2] - 1));
}

}  // namespace

std::optional<DealElement> deal_element(const CellKind& kind, Degree degree) {
  constexpr int tetrahedron = 4, wedge = 6, brick = 8, order = 2;
  std::optional<DealElement> element;
  if (kind.corners == brick)
    element = quadratic(kind, std::make_shared<dealii::FE_Q<3>>(order), dealii::QGauss<3>(3));
  if (kind.corners == wedge) element = quadratic(kind, std::make_shared<dealii::FE_WedgeP<3>>(order), wedge_points());
  if (kind.corners == tetrahedron)
    element = quadratic(kind, std::make_shared<dealii::FE_SimplexP<3>>(order), simplex_points<3>());
  if (element && degree == Degree::cubic) make_cubic(*element);
  return element;
}

}  // namespace tiprub::reduce
