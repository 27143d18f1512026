// SPDX-License-Identifier: GPL-3.0-or-later
#include <cholmod.h>

#include <Eigen/CholmodSupport>
#include <algorithm>
#include <cassert>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "cases/program/text.h"
#include "reduce/operators/factor_engine.h"
#include "reduce/operators/supernodal_solve.h"

/// U U' of an upper triangular matrix in its own place, part of LAPACK.
extern "C" void dlauum_(const char* uplo, const int* size, double* matrix, const int* rows, int* info);

namespace tiprub::reduce {

namespace {

static_assert(std::is_same_v<SuiteSparse_long, std::int64_t>);

/// What CHOLMOD allocates; it is freed also if a constructor fails.
struct CholmodMemory {
  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;

  CholmodMemory() { cholmod_l_start(&common_); }
  CholmodMemory(const CholmodMemory&) = delete;
  CholmodMemory& operator=(const CholmodMemory&) = delete;
  ~CholmodMemory() {
    cholmod_l_free_factor(&factor_, &common_);
    cholmod_l_finish(&common_);
  }
};

class CholmodFactor : public FactorEngine, private CholmodMemory {
 public:
  CholmodFactor(const SymmetricMatrix& stiffness, const SectorDofs& dofs);

  StoredMatrix take_schur_complement() override;
  Eliminated eliminate(const Eigen::MatrixXd& interior_load) const override;
  Eliminated unloaded(Eigen::Index columns) const override;
  Eigen::MatrixXd back_substitute(Eliminated&& eliminated, const Eigen::MatrixXd& moved) const override;

 private:
  void factorize(const SymmetricMatrix& stiffness);
  /// L_FF L_FF' in the order of the factor, from the last dof to the first.
  Eigen::MatrixXd interface_product() const;
  Supernodes supernodes() const;

  int interior_ = 0;
  int interface_ = 0;
  double shift_ = 0;           ///< of K_FF
  std::vector<int> position_;  ///< place in the factor of each sector dof
};

CholmodFactor::CholmodFactor(const SymmetricMatrix& stiffness, const SectorDofs& dofs)
    : interior_(dofs.interior), interface_(dofs.interface()) {
  common_.supernodal = CHOLMOD_SUPERNODAL;
  common_.final_ll = 1;
  common_.nmethods = 1;
  common_.method[0].ordering = CHOLMOD_NATURAL;
  common_.print = 0;
  if (interface_ > 0) shift_ = stiffness.diagonal().tail(interface_).maxCoeff();
  factorize(stiffness);
}

void CholmodFactor::factorize(const SymmetricMatrix& stiffness) {
  Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t> shifted = stiffness;
  for (int dof = interior_; dof < interior_ + interface_; ++dof)
    shifted.valuePtr()[shifted.outerIndexPtr()[dof]] += shift_;  // the diagonal is a column's first entry
  cholmod_sparse view = Eigen::viewAsCholmod(std::as_const(shifted).selfadjointView<Eigen::Lower>());
  factor_ = cholmod_l_analyze(&view, &common_);
  if (factor_ != nullptr) cholmod_l_factorize(&view, factor_, &common_);
  require_factor(common_.status, stiffness.rows());
  if (common_.status == CHOLMOD_NOT_POSDEF || factor_->minor < factor_->n) throw unstable_interior();
  position_.resize(factor_->n);
  for (std::size_t k = 0; k < factor_->n; ++k)
    position_[static_cast<const std::int64_t*>(factor_->Perm)[k]] = static_cast<int>(k);
  // The elimination tree's postorder may move dofs, but the interface is one clique at its root and stays last.
  if (std::any_of(position_.begin() + interior_, position_.end(), [&](int at) { return at < interior_; }))
    throw RunError("the sector falls into parts that the cut faces don't join; mesh it as one piece");
}

Supernodes CholmodFactor::supernodes() const {
  const auto indices = [](const void* of) { return static_cast<const std::int64_t*>(of); };
  return {static_cast<std::int64_t>(factor_->nsuper),
          indices(factor_->super),
          indices(factor_->pi),
          indices(factor_->px),
          indices(factor_->s),
          static_cast<const double*>(factor_->x)};
}

// A third of the work of the full product, and no second matrix of its size, which is a gigabyte for 11,600 dofs.
// LAPACK makes U U' and L' L in place; L_FF from the last row and column to the first is upper triangular.
Eigen::MatrixXd CholmodFactor::interface_product() const {
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(interface_, interface_);
  auto lower = product.reverse();
  const Supernodes of = supernodes();
  for (std::int64_t block = 0; block < of.count; ++block) {
    const std::int64_t count = of.row_start[block + 1] - of.row_start[block], first = of.first[block];
    const std::int64_t* rows = of.rows + of.row_start[block];
    for (std::int64_t k = std::max<std::int64_t>(interior_ - first, 0); first + k < of.first[block + 1]; ++k) {
      const double* column = of.values + of.value_start[block] + k * count;
      for (std::int64_t row = k; row < count; ++row)
        lower(rows[row] - interior_, first + k - interior_) = column[row];
    }
  }
  int info = 0;
  dlauum_("U", &interface_, product.data(), &interface_, &info);
  assert(info == 0);
  product.triangularView<Eigen::StrictlyLower>() = product.transpose();
  return product;
}

StoredMatrix CholmodFactor::take_schur_complement() {
  if (interface_ == 0) return StoredMatrix(Eigen::MatrixXd());  // one blade with contact by segments
  Eigen::MatrixXd schur = interface_product();
  schur.diagonal().array() -= shift_;
  const Eigen::VectorXi place =  // in this product
      interior_ + interface_ - 1 -
      Eigen::Map<const Eigen::VectorXi>(position_.data() + interior_, interface_).array();
  for (auto column : schur.colwise()) column = Eigen::VectorXd(column)(place).eval();
  schur = schur * Eigen::PermutationMatrix<Eigen::Dynamic>(place);  // Eigen exchanges columns in place
  return StoredMatrix(std::move(schur));
}

Eliminated CholmodFactor::eliminate(const Eigen::MatrixXd& interior_load) const {
  Eliminated result = unloaded(interior_load.cols());
  for (int dof = 0; dof < interior_; ++dof) result.state.row(position_[dof]) = interior_load.row(dof);
  eliminate_interior(supernodes(), interior_, result.state);
  for (int dof = 0; dof < interface_; ++dof)
    result.interface_load.row(dof) = result.state.row(position_[interior_ + dof]);
  return result;
}

Eliminated CholmodFactor::unloaded(Eigen::Index columns) const {
  return {Eigen::MatrixXd::Zero(interior_ + interface_, columns), Eigen::MatrixXd::Zero(interface_, columns), {}};
}

Eigen::MatrixXd CholmodFactor::back_substitute(Eliminated&& eliminated, const Eigen::MatrixXd& moved) const {
  for (int dof = 0; dof < interface_; ++dof) eliminated.state.row(position_[interior_ + dof]) = moved.row(dof);
  substitute_interior(supernodes(), interior_, eliminated.state);
  Eigen::MatrixXd result(eliminated.state.rows(), eliminated.state.cols());
  for (Eigen::Index dof = 0; dof < result.rows(); ++dof) result.row(dof) = eliminated.state.row(position_[dof]);
  return result;
}

}  // namespace

std::unique_ptr<FactorEngine> factorize_by_cholmod(const SymmetricMatrix& stiffness, const SectorDofs& dofs) {
  return std::make_unique<CholmodFactor>(stiffness, dofs);
}

void require_factor(int status, Eigen::Index dofs) {
  const std::string sector = "a sector of " + std::to_string(dofs) + " dofs";
  if (status == CHOLMOD_TOO_LARGE)
    throw RunError(sector + " is too large for CHOLMOD and the BLAS, whatever the memory; coarsen the mesh");
  if (status == CHOLMOD_OUT_OF_MEMORY)
    throw RunError("not enough memory to factorize " + sector +
                   "; coarsen the mesh, or take a machine with more memory");
  if (status < CHOLMOD_OK)
    throw RunError(text_of("CHOLMOD could not factorize ", sector, " (its status is ", status, ")"));
}

}  // namespace tiprub::reduce
