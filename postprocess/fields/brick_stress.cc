// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/brick_stress.h"

#include <cmath>

namespace tiprub {

namespace {

constexpr int serendipity_nodes = 20, points_per_direction = 2;
constexpr double flat = 1e-12;  // Jacobian determinant, of its norm cubed: rounding, far from the thinnest brick
const double gauss_place = 1 / std::sqrt(3.0);

/// One factor of a shape function, and its derivative.
struct Factor {
  double value, derivative;
};

Factor lagrange(int node, double x) {
  if (node < 0) return {0.5 * x * (x - 1), x - 0.5};
  if (node > 0) return {0.5 * x * (x + 1), x + 0.5};
  return {1 - x * x, -2 * x};
}

Factor serendipity(int node, double x) {
  if (node == 0) return {1 - x * x, -2 * x};
  return {1 + node * x, static_cast<double>(node)};
}

/// Of f0 f1 f2.
Eigen::RowVector3d product_gradient(const std::array<Factor, 3>& f) {
  return {f[0].derivative * f[1].value * f[2].value, f[0].value * f[1].derivative * f[2].value,
          f[0].value * f[1].value * f[2].derivative};
}

/// Derivatives of the shape functions in the reference cube; nodes x 3.
Eigen::Matrix<double, Eigen::Dynamic, 3> reference_gradient(int nodes, const Eigen::Vector3d& point) {
  Eigen::Matrix<double, Eigen::Dynamic, 3> gradient(nodes, 3);
  for (int k = 0; k < nodes; ++k) {
    const std::array<int, 3>& node = brick_reference_nodes()[k];
    std::array<Factor, 3> f;
    for (int d = 0; d < 3; ++d)
      f[d] = nodes == serendipity_nodes ? serendipity(node[d], point[d]) : lagrange(node[d], point[d]);
    gradient.row(k) = product_gradient(f);
    if (nodes != serendipity_nodes) continue;
    if (k >= 8) {
      gradient.row(k) *= 0.25;
      continue;
    }
    const Eigen::Vector3d sign(node[0], node[1], node[2]);  // corners: (f0 f1 f2) (sum of sign x - 2) / 8
    const double product = f[0].value * f[1].value * f[2].value;
    gradient.row(k) = 0.125 * (gradient.row(k) * (sign.dot(point) - 2) + product * sign.transpose());
  }
  return gradient;
}

std::array<Eigen::Vector3d, 8> gauss_points() {
  std::array<Eigen::Vector3d, 8> points;
  for (int k = 0; k < 8; ++k) {
    const std::array<int, 3>& corner = brick_reference_nodes()[k];
    points[k] = gauss_place * Eigen::Vector3d(corner[0], corner[1], corner[2]);
  }
  return points;
}

/// Trilinear through the values at the Gauss points, at the nodes.
Eigen::MatrixXd gauss_to_nodes(int nodes) {
  Eigen::MatrixXd weights(nodes, 8);
  for (int k = 0; k < nodes; ++k)
    for (int g = 0; g < 8; ++g) {
      weights(k, g) = 1;
      for (int d = 0; d < 3; ++d)
        weights(k, g) *= 0.5 * (1 + brick_reference_nodes()[g][d] * brick_reference_nodes()[k][d] / gauss_place);
    }
  return weights;
}

}  // namespace

const std::array<std::array<int, 3>, 27>& brick_reference_nodes() {
  static constexpr std::array<std::array<int, 3>, 27> nodes = {
      {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1},  {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1},
       {-1, 1, 1},   {0, -1, -1}, {1, 0, -1},  {0, 1, -1},  {-1, 0, -1}, {0, -1, 1}, {1, 0, 1},
       {0, 1, 1},    {-1, 0, 1},  {-1, -1, 0}, {1, -1, 0},  {1, 1, 0},   {-1, 1, 0}, {-1, 0, 0},
       {1, 0, 0},    {0, -1, 0},  {0, 1, 0},   {0, 0, -1},  {0, 0, 1},   {0, 0, 0}}};
  return nodes;
}

BrickStress::BrickStress(const SectorFields& sector)
    : cells_(sector.cells),
      lambda_(sector.young * sector.poisson / ((1 + sector.poisson) * (1 - 2 * sector.poisson))),
      mu_(sector.young / (2 * (1 + sector.poisson))),
      to_nodes_(gauss_to_nodes(static_cast<int>(sector.cells.rows()))),
      gradient_(static_cast<std::size_t>(sector.cells.cols())),
      bricks_(Eigen::VectorXi::Zero(sector.nodes.cols())),
      volumes_(Eigen::VectorXd::Zero(sector.cells.cols())) {
  const int nodes = static_cast<int>(cells_.rows());
  std::array<Gradient, 8> reference;
  for (int g = 0; g < 8; ++g) reference[g] = reference_gradient(nodes, gauss_points()[g]);
  Eigen::Matrix3Xd place(3, nodes);
  for (Eigen::Index cell = 0; cell < cells_.cols(); ++cell) {
    for (int k = 0; k < nodes; ++k) {
      place.col(k) = sector.nodes.col(cells_(k, cell));
      ++bricks_[cells_(k, cell)];
    }
    for (int g = 0; g < 8; ++g) {
      const Eigen::Matrix3d jacobian = place * reference[g];  // dx/dxi
      gradient_[static_cast<std::size_t>(cell)][g] = reference[g] * jacobian.inverse();
      volumes_[cell] += jacobian.determinant();
      const bool sound = jacobian.determinant() > flat * std::pow(jacobian.norm(), 3);
      if (!sound && !degenerate_) degenerate_ = cell;
    }
  }
}

Tensors BrickStress::sum(const Eigen::Matrix3Xd& displacement) const {
  Tensors stress = Tensors::Zero(6, displacement.cols());
  Eigen::Matrix3Xd moved(3, cells_.rows());
  Eigen::Matrix<double, 6, 8> at_points;
  for (Eigen::Index cell = 0; cell < cells_.cols(); ++cell) {
    for (Eigen::Index k = 0; k < cells_.rows(); ++k) moved.col(k) = displacement.col(cells_(k, cell));
    for (int g = 0; g < 8; ++g) {
      const Eigen::Matrix3d slope = moved * gradient_[static_cast<std::size_t>(cell)][g];
      const double pressure = lambda_ * slope.trace();
      at_points.col(g) << pressure + 2 * mu_ * slope(0, 0), pressure + 2 * mu_ * slope(1, 1),
          pressure + 2 * mu_ * slope(2, 2), mu_ * (slope(0, 1) + slope(1, 0)), mu_ * (slope(1, 2) + slope(2, 1)),
          mu_ * (slope(2, 0) + slope(0, 2));
    }
    const Eigen::Matrix<double, 6, Eigen::Dynamic> at_nodes = at_points * to_nodes_.transpose();
    for (Eigen::Index k = 0; k < cells_.rows(); ++k) stress.col(cells_(k, cell)) += at_nodes.col(k);
  }
  return stress;
}

Tensors BrickStress::average(const Eigen::Matrix3Xd& displacement) const {
  return sum(displacement).array().rowwise() / bricks_.transpose().cast<double>().array();
}

Eigen::VectorXd von_mises(const Tensors& stress) {
  const auto s = stress.array();
  return (0.5 * ((s.row(0) - s.row(1)).square() + (s.row(1) - s.row(2)).square() + (s.row(2) - s.row(0)).square()) +
          3 * (s.row(3).square() + s.row(4).square() + s.row(5).square()))
      .sqrt()
      .transpose();
}

namespace {

/// R sigma R' on the six components; R turns x towards y.
Eigen::Matrix<double, 6, 6> turning(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  matrix.row(0) << c * c, s * s, 0, -2 * c * s, 0, 0;
  matrix.row(1) << s * s, c * c, 0, 2 * c * s, 0, 0;
  matrix(2, 2) = 1;
  matrix.row(3) << c * s, -c * s, 0, c * c - s * s, 0, 0;
  matrix.row(4) << 0, 0, 0, 0, c, s;
  matrix.row(5) << 0, 0, 0, 0, -s, c;
  return matrix;
}

}  // namespace

ComplexTensors turned(const ComplexTensors& tensors, double angle) {
  return turning(angle) * tensors;
}

Tensors turned(const Tensors& tensors, double angle) {
  return turning(angle) * tensors;
}

}  // namespace tiprub
