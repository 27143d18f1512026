// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/cyclic_transformation.h"

#include <algorithm>
#include <cassert>
#include <complex>
#include <numbers>
#include <type_traits>

#include "cases/program/vector_lanes.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub::reduce {

namespace {

constexpr int strip_width = 16;

constexpr int node_dofs = 3;

/// One strip of right sides, row by row, `strip_width` of them. The matrix couples nodes by full blocks of 3 x 3 (see
/// SectorDofs): a block is used for its own rows and, turned, for its columns, while the strip's rows of the column
/// node stay in registers.
struct MultiplyStrip {
  template <class Set>
  TIPRUB_INLINE static void run(int columns, const int* starts, const int* rows, const double* values,
                                const double* right, double* product) {
    using Lanes = typename Set::Register;
    constexpr int lanes = sizeof(Lanes) / sizeof(double), parts = strip_width / lanes;
    const auto row_of = [](auto* strip, int row) { return strip + static_cast<std::ptrdiff_t>(row) * strip_width; };
    for (int node = 0; node < columns; node += node_dofs) {
      // The first three entries of a node's column 0 couple the node with itself, and so do two of column 1 and one
      // of column 2.
      const double* column[node_dofs] = {values + starts[node], values + starts[node + 1], values + starts[node + 2]};
      const int blocks = (starts[node + 1] - starts[node] - node_dofs) / node_dofs;
      const int* row = rows + starts[node] + node_dofs;
      for (int part = 0; part < parts; ++part) {
        const auto* x = reinterpret_cast<const Lanes*>(row_of(right, node) + part * lanes);
        auto* y = reinterpret_cast<Lanes*>(row_of(product, node) + part * lanes);
        const Lanes x0 = x[0], x1 = x[parts], x2 = x[2 * parts];
        Lanes y0 = column[0][0] * x0 + column[0][1] * x1 + column[0][2] * x2;
        Lanes y1 = column[0][1] * x0 + column[1][0] * x1 + column[1][1] * x2;
        Lanes y2 = column[0][2] * x0 + column[1][1] * x1 + column[2][0] * x2;
        const double *a = column[0] + 3, *b = column[1] + 2, *c = column[2] + 1;
        for (int block = 0; block < blocks; ++block, a += node_dofs, b += node_dofs, c += node_dofs) {
          const int other = row[block * node_dofs];
          const auto* z = reinterpret_cast<const Lanes*>(row_of(right, other) + part * lanes);
          auto* w = reinterpret_cast<Lanes*>(row_of(product, other) + part * lanes);
          const Lanes z0 = z[0], z1 = z[parts], z2 = z[2 * parts];
          y0 += a[0] * z0 + a[1] * z1 + a[2] * z2;
          y1 += b[0] * z0 + b[1] * z1 + b[2] * z2;
          y2 += c[0] * z0 + c[1] * z1 + c[2] * z2;
          w[0] += a[0] * x0 + b[0] * x1 + c[0] * x2;
          w[parts] += a[1] * x0 + b[1] * x1 + c[1] * x2;
          w[2 * parts] += a[2] * x0 + b[2] * x1 + c[2] * x2;
        }
        y[0] += y0;
        y[parts] += y1;
        y[2 * parts] += y2;
      }
    }
  }
};

/// Complex columns side by side in a strip, real and imaginary part in turn; a standing wave has real ones only.
template <class Scalar>
using Strip = Eigen::Matrix<Scalar, Eigen::Dynamic, strip_width * sizeof(double) / sizeof(Scalar), Eigen::RowMajor>;

template <class Scalar, class Columns>
auto parts(const Columns& columns) {
  if constexpr (std::is_same_v<Scalar, double>)
    return columns.real();
  else
    return columns;
}

/// Calls body(first, count) for some rows at a time, so that the change of order between a strip and columns stays in
/// the cache.
template <class Body>
void in_cache(Eigen::Index rows, const Body& body) {
  constexpr Eigen::Index at_once = 256;
  for (Eigen::Index first = 0; first < rows; first += at_once) body(first, std::min(at_once, rows - first));
}

/// T^H Y T x for real or complex x; T is `low` on the low face and `factor` on the high one.
template <class Scalar>
void multiply(const SymmetricMatrix& matrix, const SectorDofs& dofs, double low, std::complex<double> factor,
              const Eigen::MatrixXcd& independent, Eigen::MatrixXcd& result) {
  const Eigen::Index high = dofs.interior + dofs.face, below = dofs.boundary();
  const Scalar phase = parts<Scalar>(factor);
  constexpr Eigen::Index width = Strip<Scalar>::ColsAtCompileTime;
  Strip<Scalar> moved = Strip<Scalar>::Zero(dofs.sector(), width), product(dofs.sector(), width);
  for (Eigen::Index at = 0; at < independent.cols(); at += width) {
    const Eigen::Index columns = std::min(width, independent.cols() - at);
    const auto x = independent.middleCols(at, columns);
    in_cache(high, [&](Eigen::Index row, Eigen::Index rows) {  // T x
      moved.block(row, 0, rows, columns) = parts<Scalar>(x.middleRows(row, rows));
    });
    auto low_face = moved.block(dofs.interior, 0, dofs.face, columns);
    moved.block(high, 0, dofs.face, columns) = phase * low_face;
    low_face *= low;
    moved.block(high + dofs.face, 0, below, columns) = parts<Scalar>(x.bottomRows(below));
    product.setZero();
    in_eights<MultiplyStrip>(static_cast<int>(matrix.cols()), matrix.outerIndexPtr(), matrix.innerIndexPtr(),
                             matrix.valuePtr(), reinterpret_cast<const double*>(moved.data()),
                             reinterpret_cast<double*>(product.data()));
    product.middleRows(dofs.interior, dofs.face) =  // T^H y
        low * product.middleRows(dofs.interior, dofs.face) +
        Eigen::numext::conj(phase) * product.middleRows(high, dofs.face);
    auto y = result.middleCols(at, columns);
    in_cache(high, [&](Eigen::Index row, Eigen::Index rows) {
      y.middleRows(row, rows) = product.block(row, 0, rows, columns).template cast<std::complex<double>>();
    });
    y.bottomRows(below) = product.bottomRows(below).leftCols(columns).template cast<std::complex<double>>();
  }
}

}  // namespace

CyclicTransformation::CyclicTransformation(const SectorDofs& dofs, int sector_count, int nodal_diameter)
    : dofs_(dofs) {
  // e^{i n alpha} is exactly real for n = 0 and n = N/2, and so are their matrices.
  const double angle = 2 * std::numbers::pi * nodal_diameter / sector_count;
  phase_ = std::polar(1.0, angle);
  if (is_standing(nodal_diameter, sector_count)) phase_ = nodal_diameter == 0 ? 1.0 : -1.0;
}

CyclicTransformation CyclicTransformation::of_held_faces(const SectorDofs& dofs) {
  CyclicTransformation alone(dofs, 1, 0);
  alone.low_ = 0.0;
  alone.phase_ = 0.0;
  return alone;
}

CyclicTransformation CyclicTransformation::with(const SectorDofs& dofs) const {
  CyclicTransformation other = *this;
  other.dofs_ = dofs;
  return other;
}

Eigen::MatrixXcd CyclicTransformation::expand_interface(const Eigen::MatrixXcd& independent) const {
  Eigen::MatrixXcd sector(dofs_.interface(), independent.cols());
  sector << low_ * independent.topRows(dofs_.face), phase_ * independent.topRows(dofs_.face),
      independent.bottomRows(dofs_.boundary());
  return sector;
}

Eigen::MatrixXcd CyclicTransformation::gather_interface(const Eigen::MatrixXcd& sector) const {
  Eigen::MatrixXcd independent(dofs_.face + dofs_.boundary(), sector.cols());
  independent << low_ * sector.topRows(dofs_.face) + std::conj(phase_) * sector.middleRows(dofs_.face, dofs_.face),
      sector.bottomRows(dofs_.boundary());
  return independent;
}

Eigen::MatrixXcd CyclicTransformation::expand(const Eigen::MatrixXcd& independent) const {
  Eigen::MatrixXcd sector(dofs_.sector(), independent.cols());
  sector << independent.topRows(dofs_.interior),
      expand_interface(independent.bottomRows(dofs_.face + dofs_.boundary()));
  return sector;
}

Eigen::MatrixXcd CyclicTransformation::gather(const Eigen::MatrixXcd& sector) const {
  Eigen::MatrixXcd independent(dofs_.independent(), sector.cols());
  independent << sector.topRows(dofs_.interior), gather_interface(sector.bottomRows(dofs_.interface()));
  return independent;
}

// eq. 6: the block of n, applied and never formed.
Eigen::MatrixXcd CyclicTransformation::apply(const SymmetricMatrix& matrix,
                                             const Eigen::MatrixXcd& independent) const {
  assert(!is_real() || independent.imag().isZero(0.0));
  Eigen::MatrixXcd result(independent.rows(), independent.cols());
  is_real() ? multiply<double>(matrix, dofs_, low_, phase_, independent, result)
            : multiply<std::complex<double>>(matrix, dofs_, low_, phase_, independent, result);
  return result;
}

}  // namespace tiprub::reduce
