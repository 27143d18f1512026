// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/sector_factor.h"

#include <cholmod.h>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "cases/program/errors.h"
#include "reduce/operators/supernodal_solve.h"

/// U U' of an upper triangular matrix in its own place, part of LAPACK.
extern "C" void dlauum_(const char* uplo, const int* size, double* matrix, const int* rows, int* info);

namespace tiprub::reduce {

namespace {

using Supernode = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using Rows = Eigen::Matrix<std::int64_t, Eigen::Dynamic, 1>;
static_assert(std::is_same_v<SuiteSparse_long, std::int64_t>);
}  // namespace

void require_factor(int status, Eigen::Index dofs) {
  const std::string sector = "a sector of " + std::to_string(dofs) + " dofs";
  if (status == CHOLMOD_TOO_LARGE)
    throw RunError(sector + " is too large for CHOLMOD and the BLAS, whatever the memory; coarsen the mesh");
  if (status == CHOLMOD_OUT_OF_MEMORY)
    throw RunError("not enough memory to factorize " + sector +
                   "; coarsen the mesh, or take a machine with more memory");
  if (status < CHOLMOD_OK)
    throw RunError("CHOLMOD could not factorize " + sector + " (its status is " + std::to_string(status) + ")");
}

struct SectorFactor::Cholmod {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  int interior = 0;
  int interface = 0;
  std::vector<int> position;  ///< place in the factor of each sector dof

  Cholmod() {
    cholmod_l_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.final_ll = 1;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_NATURAL;
    common.print = 0;
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;
  ~Cholmod() {
    cholmod_l_free_factor(&factor, &common);
    cholmod_l_finish(&common);
  }

  void factorize(const SymmetricMatrix& stiffness, double shift);
  /// Calls body(first column, rows below the diagonal block, diagonal block, block below) for each supernode of
  /// L_FF, all counted from the first interface dof in the factor's order. The entries above the diagonal of the
  /// diagonal block are not used.
  template <class Body>
  void for_each_interface_block(const Body& body) const;
  /// L_FF L_FF' in the order of the factor, from the last dof to the first.
  Eigen::MatrixXd interface_product() const;
  /// L_FF x and L_FF' x, straight from the supernodes.
  Eigen::MatrixXd multiply_interface(const Eigen::MatrixXd& x) const;
  Eigen::MatrixXd multiply_interface_transposed(const Eigen::MatrixXd& x) const;
  Supernodes supernodes() const;
};

void SectorFactor::Cholmod::factorize(const SymmetricMatrix& stiffness, double shift) {
  Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t> shifted = stiffness;
  for (int dof = interior; dof < interior + interface; ++dof)
    shifted.valuePtr()[shifted.outerIndexPtr()[dof]] += shift;  // the diagonal is a column's first entry
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(shifted.rows());
  view.nzmax = static_cast<std::size_t>(shifted.nonZeros());
  view.p = shifted.outerIndexPtr();
  view.i = shifted.innerIndexPtr();
  view.x = shifted.valuePtr();
  view.stype = -1;  // lower triangle
  view.itype = CHOLMOD_LONG;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  factor = cholmod_l_analyze(&view, &common);
  if (factor != nullptr) cholmod_l_factorize(&view, factor, &common);
  require_factor(common.status, stiffness.rows());
  if (common.status == CHOLMOD_NOT_POSDEF || factor->minor < factor->n)
    throw RunError("the stiffness is not positive definite: the rotor is unstable, or a part of it is not held");
  position.resize(factor->n);
  for (std::size_t k = 0; k < factor->n; ++k)
    position[static_cast<const std::int64_t*>(factor->Perm)[k]] = static_cast<int>(k);
  // The elimination tree's postorder may move dofs, but the interface is one clique at its root and stays last.
  if (std::any_of(position.begin() + interior, position.end(), [&](int at) { return at < interior; }))
    throw RunError("the sector falls into parts that the cut faces don't join; mesh it as one piece");
}

Supernodes SectorFactor::Cholmod::supernodes() const {
  const auto indices = [](const void* of) { return static_cast<const std::int64_t*>(of); };
  return {static_cast<std::int64_t>(factor->nsuper),
          indices(factor->super),
          indices(factor->pi),
          indices(factor->px),
          indices(factor->s),
          static_cast<const double*>(factor->x)};
}

template <class Body>
void SectorFactor::Cholmod::for_each_interface_block(const Body& body) const {
  const Supernodes of = supernodes();
  for (std::int64_t block = 0; block < of.count; ++block) {
    const std::int64_t first = std::max<std::int64_t>(of.first[block], interior);
    const std::int64_t width = of.first[block + 1] - first;
    if (width <= 0) continue;
    const std::int64_t count = of.row_start[block + 1] - of.row_start[block], offset = first - of.first[block];
    const std::int64_t below = count - offset - width;
    const double* corner = of.values + of.value_start[block] + offset + offset * count;
    const Eigen::OuterStride<> stride(count);
    const Rows below_rows =
        Eigen::Map<const Rows>(of.rows + of.row_start[block] + offset + width, below).array() - interior;
    body(first - interior, below_rows, Supernode(corner, width, width, stride),
         Supernode(corner + width, below, width, stride));
  }
}

// A third of the work of the full product, and no second matrix of its size, which is a gigabyte for 11,600 dofs.
// LAPACK makes U U' and L' L in place; L_FF from the last row and column to the first is upper triangular.
Eigen::MatrixXd SectorFactor::Cholmod::interface_product() const {
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(interface, interface);
  auto lower = product.reverse();
  for_each_interface_block(
      [&](Eigen::Index first, const Rows& rows, const Supernode& diagonal, const Supernode& below) {
        for (Eigen::Index column = 0; column < diagonal.cols(); ++column) {
          const Eigen::Index rest = diagonal.rows() - column;
          lower.col(first + column).segment(first + column, rest) = diagonal.col(column).tail(rest);
        }
        lower(rows, Eigen::seqN(first, below.cols())) = below;
      });
  int info = 0;
  dlauum_("U", &interface, product.data(), &interface, &info);
  assert(info == 0);
  product.triangularView<Eigen::StrictlyLower>() = product.transpose();
  return product;
}

Eigen::MatrixXd SectorFactor::Cholmod::multiply_interface(const Eigen::MatrixXd& x) const {
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(interface, x.cols());
  for_each_interface_block(
      [&](Eigen::Index first, const Rows& rows, const Supernode& diagonal, const Supernode& below) {
        const auto part = x.middleRows(first, diagonal.cols());
        product.middleRows(first, diagonal.cols()) += diagonal.triangularView<Eigen::Lower>() * part;
        const Eigen::MatrixXd moved = below * part;
        product(rows, Eigen::all) += moved;
      });
  return product;
}

Eigen::MatrixXd SectorFactor::Cholmod::multiply_interface_transposed(const Eigen::MatrixXd& x) const {
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(interface, x.cols());
  for_each_interface_block(
      [&](Eigen::Index first, const Rows& rows, const Supernode& diagonal, const Supernode& below) {
        auto part = product.middleRows(first, diagonal.cols());
        part = diagonal.triangularView<Eigen::Lower>().transpose() * x.middleRows(first, diagonal.cols());
        const Eigen::MatrixXd gathered = x(rows, Eigen::all);
        part.noalias() += below.transpose() * gathered;
      });
  return product;
}

SectorFactor::SectorFactor(const SymmetricMatrix& stiffness, const SectorDofs& dofs)
    : cholmod_(std::make_unique<Cholmod>()) {
  cholmod_->interior = dofs.interior;
  cholmod_->interface = dofs.interface();
  const bool alone = dofs.interface() == 0;  // one blade with contact by segments
  const double shift = alone ? 0.0 : stiffness.diagonal().tail(dofs.interface()).maxCoeff();
  cholmod_->factorize(stiffness, shift);
  if (alone) return;
  schur_ = cholmod_->interface_product();
  schur_.diagonal().array() -= shift;
  const Eigen::VectorXi place =  // in this product
      dofs.sector() - 1 -
      Eigen::Map<const Eigen::VectorXi>(cholmod_->position.data() + dofs.interior, dofs.interface()).array();
  for (auto column : schur_.colwise()) column = Eigen::VectorXd(column)(place).eval();
  schur_ = schur_ * Eigen::PermutationMatrix<Eigen::Dynamic>(place);  // Eigen exchanges columns in place
}

SectorFactor::~SectorFactor() = default;
SectorFactor::SectorFactor(SectorFactor&&) noexcept = default;

SectorFactor::Eliminated SectorFactor::eliminate(const Eigen::MatrixXd& interior_load) const {
  const Cholmod& of = *cholmod_;
  Eliminated result;
  result.state.setZero(of.interior + of.interface, interior_load.cols());
  for (int dof = 0; dof < of.interior; ++dof) result.state.row(of.position[dof]) = interior_load.row(dof);
  solve_lower(of.supernodes(), result.state);
  const Eigen::MatrixXd reached =  // L_FF y_F = -L_FI y_I
      of.multiply_interface(result.state.bottomRows(of.interface));
  result.interface_load.resize(of.interface, interior_load.cols());
  for (int dof = 0; dof < of.interface; ++dof)
    result.interface_load.row(dof) = reached.row(of.position[of.interior + dof] - of.interior);
  return result;
}

Eigen::MatrixXd SectorFactor::back_substitute(Eliminated&& eliminated, const Eigen::MatrixXd& interface) const {
  const Cholmod& of = *cholmod_;
  Eigen::MatrixXd placed(of.interface, interface.cols());
  for (int dof = 0; dof < of.interface; ++dof)
    placed.row(of.position[of.interior + dof] - of.interior) = interface.row(dof);
  eliminated.state.bottomRows(of.interface) = of.multiply_interface_transposed(placed);
  solve_lower_transposed(of.supernodes(), eliminated.state);
  Eigen::MatrixXd result(eliminated.state.rows(), eliminated.state.cols());
  for (Eigen::Index dof = 0; dof < result.rows(); ++dof) result.row(dof) = eliminated.state.row(of.position[dof]);
  return result;
}

}  // namespace tiprub::reduce
