// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/rotating_elasticity.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tiprub::reduce {

namespace {

using Strain = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Green-Lagrange strain per nodal displacement at the deformation gradient F:
/// dE_ij = (F_ki dN_a/dX_j + F_kj dN_a/dX_i) / 2 du_ka; shears doubled. 6 x 3 nodes.
void strain_operator(const Eigen::Matrix<double, Eigen::Dynamic, 3>& gradient, const Eigen::Matrix3d& F,
                     Eigen::Ref<Strain> B) {
  for (Eigen::Index a = 0; a < gradient.rows(); ++a)
    for (int k = 0; k < 3; ++k) {
      const double gx = gradient(a, 0), gy = gradient(a, 1), gz = gradient(a, 2);
      const double fx = F(k, 0), fy = F(k, 1), fz = F(k, 2);
      B.col(3 * a + k) << fx * gx, fy * gy, fz * gz, fx * gy + fy * gx, fy * gz + fz * gy, fz * gx + fx * gz;
    }
}

/// Stress of a displacement gradient H = du_i/dX_j [Pa]: of the linear strain, or of the Green-Lagrange strain
/// E = (H + H' + H'H)/2 (then the second Piola-Kirchhoff stress).
Eigen::Matrix3d stress(const Eigen::Matrix3d& H, const Material& material, Prestress prestress) {
  const double shear = material.young / (2 * (1 + material.poisson));
  const double lame = 2 * shear * material.poisson / (1 - 2 * material.poisson);
  Eigen::Matrix3d E = 0.5 * (H + H.transpose());
  if (prestress == Prestress::nonlinear) E += 0.5 * H.transpose() * H;
  return lame * E.trace() * Eigen::Matrix3d::Identity() + 2 * shear * E;
}

/// Adds `factor * scalar(a, b)` times a diagonal 3 x 3 matrix to each node pair's block.
void add_blocks(const Eigen::MatrixXd& scalar, const Eigen::Vector3d& diagonal, Eigen::MatrixXd& matrix) {
  for (Eigen::Index b = 0; b < scalar.cols(); ++b)
    for (Eigen::Index a = 0; a < scalar.rows(); ++a)
      for (int k = 0; k < 3; ++k) matrix(3 * a + k, 3 * b + k) += diagonal[k] * scalar(a, b);
}

/// A'A, by half of a product's work.
Eigen::MatrixXd square_of(const Eigen::MatrixXd& A) {
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(A.cols(), A.cols());
  square.selfadjointView<Eigen::Lower>().rankUpdate(A.transpose());
  square.triangularView<Eigen::StrictlyUpper>() = square.transpose();
  return square;
}

/// The displacement gradient H of each field at an integration point, and the stress S of its linear strain [Pa].
struct GradientAndStress {
  Eigen::Matrix3d H, S;
};

std::vector<GradientAndStress> fields_at(const CellPoints& points, Eigen::Index q,
                                         const std::vector<Eigen::Matrix3Xd>& fields, const Material& material) {
  std::vector<GradientAndStress> found;
  for (const Eigen::Matrix3Xd& field : fields) {
    const Eigen::Matrix3d H = field(Eigen::all, points.nodes) * points.gradient[q];
    found.push_back({H, stress(H, material, Prestress::linear)});
  }
  return found;
}

/// The third derivative of the strain energy density at rest is linear in each of three fields:
///     S_k : H_a'H_b + S_a : sym(H_b'H_k) + S_b : sym(H_k'H_a) = S_k : H_a'H_b + H_k : (H_b S_a + H_a S_b).
/// A row [S_k | H_k] of directions_at() times a row [H_a'H_b | H_b S_a + H_a S_b] of pairs_at() is this sum.
constexpr int tensor = 9;

Eigen::MatrixXd directions_at(const CellPoints& points, Eigen::Index q, const std::vector<Eigen::Matrix3Xd>& along,
                              const Material& material) {
  Eigen::MatrixXd rows(along.size(), 2 * tensor);
  Eigen::Index k = 0;
  for (const auto& [H, S] : fields_at(points, q, along, material))
    rows.row(k++) << S.reshaped<Eigen::ColMajor>().transpose(), H.reshaped<Eigen::ColMajor>().transpose();
  return rows;
}

/// One row for each ordered pair of shapes.
Eigen::MatrixXd pairs_at(const CellPoints& points, Eigen::Index q, const std::vector<Eigen::Matrix3Xd>& shapes,
                         const Material& material) {
  const std::vector<GradientAndStress> fields = fields_at(points, q, shapes, material);
  Eigen::MatrixXd rows(fields.size() * fields.size(), 2 * tensor);
  Eigen::Index row = 0;
  for (const GradientAndStress& a : fields)
    for (const GradientAndStress& b : fields) {
      const Eigen::Matrix3d both = a.H.transpose() * b.H, crossed = b.H * a.S + a.H * b.S;
      rows.row(row++) << both.reshaped<Eigen::ColMajor>().transpose(),
          crossed.reshaped<Eigen::ColMajor>().transpose();
    }
  return rows;
}

// Here and below, a product of three matrices is taken in two steps: as one expression, Eigen's product of a product
// takes seconds to compile for each kind of factors.
Eigen::MatrixXd consistent_mass(const CellPoints& points, double density) {
  const Eigen::MatrixXd weighted = density * points.shape * points.weight.asDiagonal();
  return weighted * points.shape.transpose();
}

}  // namespace

SymmetricMatrix zero_matrix(const SectorMesh& mesh, const SectorDofs& dofs) {
  const std::vector<std::vector<int>> lower = lower_neighbours(mesh, dofs);
  const int nodes = static_cast<int>(lower.size());
  SymmetricMatrix matrix(dofs.sector(), dofs.sector());
  Eigen::VectorXi sizes(dofs.sector());
  for (int column = 0; column < nodes; ++column)
    for (int k = 0; k < 3; ++k) sizes[3 * column + k] = static_cast<int>(3 * lower[column].size()) - k;
  matrix.reserve(sizes);
  for (int column = 0; column < nodes; ++column)
    for (int k = 0; k < 3; ++k)
      for (const int row : lower[column])
        for (int i = row == column ? k : 0; i < 3; ++i) matrix.insert(3 * row + i, 3 * column + k) = 0.0;
  matrix.makeCompressed();
  return matrix;
}

Eigen::Matrix<double, 6, 6> Material::elasticity() const {
  const double shear = young / (2 * (1 + poisson));
  const double lame = 2 * shear * poisson / (1 - 2 * poisson);
  Eigen::Matrix<double, 6, 6> C = Eigen::Matrix<double, 6, 6>::Zero();
  C.topLeftCorner<3, 3>().setConstant(lame);
  C.diagonal() << lame + 2 * shear, lame + 2 * shear, lame + 2 * shear, shear, shear, shear;
  return C;
}

RotatingElasticity::RotatingElasticity(const SectorMesh& mesh, const SectorDofs& dofs, const Material& material,
                                       int threads)
    : mesh_(mesh),
      dofs_(dofs),
      material_(material),
      elements_(mesh, threads),
      zero_(zero_matrix(mesh, dofs)),
      all_cells_(elements_.cell_count()) {
  std::iota(all_cells_.begin(), all_cells_.end(), 0);
}

SymmetricMatrix RotatingElasticity::assemble(const std::vector<int>& cells, const Integral& integral) const {
  SymmetricMatrix matrix = zero_;
  elements_.integrate(cells, integral, [&](const CellIntegral& cell) { scatter(cell.value, cell.nodes, matrix); });
  return matrix;
}

SymmetricMatrix RotatingElasticity::assemble(const Integral& integral) const {
  return assemble(all_cells_, integral);
}

void RotatingElasticity::scatter(const Eigen::MatrixXd& cell_matrix, const std::vector<int>& nodes,
                                 SymmetricMatrix& into) const {
  const int count = static_cast<int>(nodes.size());
  std::vector<Eigen::Matrix3d> frames(count);
  for (int a = 0; a < count; ++a) frames[a] = cylindrical_frame(mesh_.nodes.col(nodes[a]));
  const int* starts = into.outerIndexPtr();
  const int* rows = into.innerIndexPtr();
  for (int b = 0; b < count; ++b)
    for (int a = 0; a < count; ++a) {
      const int row = dofs_.first[nodes[a]], column = dofs_.first[nodes[b]];
      if (row < column || column < 0) continue;
      const Eigen::Matrix3d block = frames[a].transpose() * cell_matrix.block<3, 3>(3 * a, 3 * b) * frames[b];
      for (int k = 0; k < 3; ++k) {
        const int skip = row == column ? k : 0;
        const int* at = std::lower_bound(rows + starts[column + k], rows + starts[column + k + 1], row + skip);
        double* value = into.valuePtr() + (at - rows);
        for (int i = skip; i < 3; ++i) value[i - skip] += block(i, k);
      }
    }
}

SymmetricMatrix RotatingElasticity::mass() const {
  return assemble([&](const CellPoints& points) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * points.shape.rows(), 3 * points.shape.rows());
    add_blocks(consistent_mass(points, material_.density), Eigen::Vector3d::Ones(), matrix);
    return matrix;
  });
}

SymmetricMatrix RotatingElasticity::stiffness(double speed, const Eigen::Matrix3Xd& displacement, Prestress prestress,
                                              SpinSoftening softening) const {
  const Eigen::Matrix<double, 6, 6> root = material_.elasticity().llt().matrixU();  // C = root' root
  const double square = softening == SpinSoftening::on ? speed * speed : 0.0;
  const Eigen::Vector3d softened(-square, -square, 0.0);
  return assemble([&](const CellPoints& points) {
    const Eigen::Index count = points.shape.rows(), gauss = points.weight.size();
    const Eigen::Matrix3Xd moved = displacement(Eigen::all, points.nodes);
    Eigen::MatrixXd roots(6 * gauss, 3 * count), stress_stiffness = Eigen::MatrixXd::Zero(count, count);
    Strain B(6, 3 * count);
    for (Eigen::Index q = 0; q < gauss; ++q) {
      const Eigen::Matrix3d H = moved * points.gradient[q];  // du_i/dX_j
      Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
      if (prestress != Prestress::stress_only) F += H;
      strain_operator(points.gradient[q], F, B);
      roots.middleRows<6>(6 * q) = std::sqrt(points.weight[q]) * root * B;
      const Eigen::MatrixX3d pulled = points.weight[q] * points.gradient[q] * stress(H, material_, prestress);
      stress_stiffness += pulled * points.gradient[q].transpose();
    }
    Eigen::MatrixXd matrix = square_of(roots);                                 // material stiffness, int B' C B
    add_blocks(stress_stiffness, Eigen::Vector3d::Ones(), matrix);             // K_sigma
    add_blocks(consistent_mass(points, material_.density), softened, matrix);  // spin softening, -Omega^2 M_perp
    return matrix;
  });
}

Eigen::VectorXd RotatingElasticity::assemble_forces(const Integral& nodal_forces) const {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(dofs_.sector());
  elements_.integrate(all_cells_, nodal_forces, [&](const CellIntegral& cell) {
    for (std::size_t a = 0; a < cell.nodes.size(); ++a)
      if (const int first = dofs_.first[cell.nodes[a]]; first >= 0)
        forces.segment<3>(first) += cylindrical_frame(mesh_.nodes.col(cell.nodes[a])).transpose() *
                                    cell.value.col(static_cast<Eigen::Index>(a));
  });
  return forces;
}

Eigen::VectorXd RotatingElasticity::centrifugal_load() const {
  return centrifugal_load(Eigen::Matrix3Xd::Zero(3, mesh_.node_count()));
}

Eigen::VectorXd RotatingElasticity::centrifugal_load(const Eigen::Matrix3Xd& displacement) const {
  return assemble_forces([&](const CellPoints& points) -> Eigen::MatrixXd {
    Eigen::Matrix3Xd radius = points.position + displacement(Eigen::all, points.nodes) * points.shape;
    radius.row(2).setZero();
    const Eigen::Matrix3Xd weighted = material_.density * radius * points.weight.asDiagonal();
    return weighted * points.shape.transpose();
  });
}

Eigen::VectorXd RotatingElasticity::internal_force(const Eigen::Matrix3Xd& displacement) const {
  return assemble_forces([&](const CellPoints& points) {
    const Eigen::Matrix3Xd moved = displacement(Eigen::all, points.nodes);
    Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(3, moved.cols());
    for (Eigen::Index q = 0; q < points.weight.size(); ++q) {
      const Eigen::Matrix3d H = moved * points.gradient[q];
      // F S dN/dX: the first Piola-Kirchhoff stress on the shape functions' gradients.
      const Eigen::Matrix3d piola =
          points.weight[q] * (Eigen::Matrix3d::Identity() + H) * stress(H, material_, Prestress::nonlinear);
      forces += piola * points.gradient[q].transpose();
    }
    return forces;
  });
}

std::vector<Eigen::MatrixXd> RotatingElasticity::stiffness_change(const std::vector<Eigen::Matrix3Xd>& along,
                                                                  const std::vector<Eigen::Matrix3Xd>& shapes) const {
  const auto count = static_cast<Eigen::Index>(along.size()), p = static_cast<Eigen::Index>(shapes.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(count, p * p);
  const auto integral = [&](const CellPoints& points) {
    Eigen::MatrixXd value = Eigen::MatrixXd::Zero(count, p * p);
    for (Eigen::Index q = 0; q < points.weight.size(); ++q)
      value += points.weight[q] * directions_at(points, q, along, material_) *
               pairs_at(points, q, shapes, material_).transpose();
    return value;
  };
  elements_.integrate(all_cells_, integral, [&](const CellIntegral& cell) { sum += cell.value; });
  std::vector<Eigen::MatrixXd> matrices;
  for (Eigen::Index k = 0; k < count; ++k) matrices.emplace_back(sum.row(k).reshaped(p, p));
  return matrices;
}

SymmetricMatrix RotatingElasticity::stiffness_of(const std::vector<int>& cells) const {
  const Eigen::Matrix<double, 6, 6> C = material_.elasticity();
  return assemble(cells, [&](const CellPoints& points) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * points.shape.rows(), 3 * points.shape.rows());
    Strain B(6, 3 * points.shape.rows());
    for (Eigen::Index q = 0; q < points.weight.size(); ++q) {
      strain_operator(points.gradient[q], Eigen::Matrix3d::Identity(), B);
      const Strain stresses = points.weight[q] * C * B;
      matrix += B.transpose() * stresses;
    }
    return matrix;
  });
}

Eigen::VectorXd RotatingElasticity::von_mises(const Eigen::Matrix3Xd& displacement, Prestress prestress) const {
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(elements_.cell_count());
  elements_.visit([&](const CellPoints& points) {
    for (Eigen::Index q = 0; q < points.weight.size(); ++q) {
      const Eigen::Matrix3d H = displacement(Eigen::all, points.nodes) * points.gradient[q];
      const Eigen::Matrix3d F = Eigen::Matrix3d::Identity() + H;
      Eigen::Matrix3d cauchy = stress(H, material_, prestress);
      if (prestress == Prestress::nonlinear) cauchy = F * cauchy * F.transpose() / F.determinant();
      const Eigen::Matrix3d deviator = cauchy - cauchy.trace() / 3 * Eigen::Matrix3d::Identity();
      largest[points.cell] = std::max(largest[points.cell], std::sqrt(1.5) * deviator.norm());  // sqrt(3/2 s : s)
    }
  });
  return largest;
}

double RotatingElasticity::volume() const {
  double sum = 0;
  elements_.visit([&](const CellPoints& points) { sum += points.weight.sum(); });
  return sum;
}

}  // namespace tiprub::reduce
