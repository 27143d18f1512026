// SPDX-License-Identifier: GPL-3.0-or-later
#define OMPI_SKIP_MPICXX 1
#include <dmumps_c.h>
#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "cases/program/process_group.h"
#include "cases/program/text.h"
#include "reduce/operators/factor_engine.h"

namespace tiprub::reduce {

namespace {

// Names of MUMPS's guide for what its job does.
constexpr MUMPS_INT start = -1, end = -2, analyse_and_factorize = 4, solve = 3;
constexpr MUMPS_INT positive_definite = 1;
constexpr int out_of_workspace = -9, workspace_too_small = -8;

/// MPI for as long as the process runs, unless somebody else started it, and will end it.
void require_mpi() {
  struct Session {
    int started_before = 0;
    Session() {
      MPI_Initialized(&started_before);
      if (started_before == 0) start_mpi();
    }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    ~Session() {
      if (started_before == 0) end_mpi();
    }
  };
  static const Session session;
}

/// One at a time in the process: MUMPS and the module that reads its files keep their state in static variables.
std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

class MumpsFactor : public FactorEngine {
 public:
  MumpsFactor(const SymmetricMatrix& stiffness, const SectorDofs& dofs, const FactorChoice& choice);
  MumpsFactor(const MumpsFactor&) = delete;
  MumpsFactor& operator=(const MumpsFactor&) = delete;
  ~MumpsFactor() override {
    const std::lock_guard lock(one_at_a_time());
    run(end);
  }

  StoredMatrix take_schur_complement() override;
  Eliminated eliminate(const Eigen::MatrixXd& interior_load) const override;
  Eliminated unloaded(Eigen::Index columns) const override {
    return eliminate(Eigen::MatrixXd::Zero(interior_, columns));
  }
  Eigen::MatrixXd back_substitute(Eliminated&& eliminated, const Eigen::MatrixXd& moved) const override;

 private:
  /// Parameter k of MUMPS as its guide counts them.
  MUMPS_INT& control(int k) const { return mumps_.icntl[k - 1]; }
  void run(MUMPS_INT job) const;
  void set_controls();
  void write_to(const std::filesystem::path& folder);
  void factorize(const SymmetricMatrix& stiffness);
  void factorize_with_room();
  void solve_half(MUMPS_INT half, Eigen::MatrixXd& sector, Eigen::MatrixXd& on_interface) const;

  int interior_, interface_;
  std::unique_ptr<ScratchFolder> folder_;  ///< none if all is in memory
  StoredMatrix schur_;
  mutable DMUMPS_STRUC_C mumps_{};  ///< changes with each solve
};

MumpsFactor::MumpsFactor(const SymmetricMatrix& stiffness, const SectorDofs& dofs, const FactorChoice& choice)
    : interior_(dofs.interior),
      interface_(dofs.interface()),
      folder_(choice.method == FactorMethod::mumps_on_disk ? std::make_unique<ScratchFolder>(choice.scratch_folder)
                                                           : nullptr),
      schur_(folder_ != nullptr && interface_ > 0 ? StoredMatrix(interface_, interface_, folder_->path() / "schur")
                                                  : StoredMatrix(Eigen::MatrixXd::Zero(interface_, interface_))) {
  require_mpi();
  const std::lock_guard lock(one_at_a_time());
  mumps_.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(MPI_COMM_SELF));
  mumps_.par = 1;  // this process works, too
  mumps_.sym = positive_definite;
  run(start);
  try {
    set_controls();
    if (folder_) write_to(folder_->path());
    factorize(stiffness);
  } catch (...) {
    run(end);
    throw;
  }
}

void MumpsFactor::run(MUMPS_INT job) const {
  mumps_.job = job;
  dmumps_c(&mumps_);
}

void MumpsFactor::set_controls() {
  for (const int printing : {1, 2, 3, 4}) control(printing) = 0;
  control(6) = control(8) = 0;   // neither a transversal nor scaling: the matrix is positive definite
  control(7) = 1;                // our order, nested dissection
  control(13) = 1;               // pivots of the root count, too
  control(28) = 1;               // sequential analysis
  control(19) = interface_ > 0;  // Schur complement
  control(27) = 64;              // right sides a pass; more than come at once
}

void MumpsFactor::write_to(const std::filesystem::path& folder) {
  const std::string name = folder.string();
  if (name.size() >= sizeof(mumps_.ooc_tmpdir))
    throw RunError(name + ": the name of this folder is too long for MUMPS; write model.h5 to another folder");
  mumps_.ooc_tmpdir[name.copy(mumps_.ooc_tmpdir, name.size())] = '\0';
  const std::string prefix = "factor";
  mumps_.ooc_prefix[prefix.copy(mumps_.ooc_prefix, prefix.size())] = '\0';
  control(22) = 1;
}

void MumpsFactor::factorize(const SymmetricMatrix& stiffness) {
  const auto size = static_cast<std::size_t>(stiffness.rows()),
             entries = static_cast<std::size_t>(stiffness.nonZeros());
  std::vector<MUMPS_INT> rows(entries), columns(entries), order(size), kept(static_cast<std::size_t>(interface_));
  for (int column = 0; column < stiffness.outerSize(); ++column)
    for (int at = stiffness.outerIndexPtr()[column]; at < stiffness.outerIndexPtr()[column + 1]; ++at) {
      rows[at] = stiffness.innerIndexPtr()[at] + 1;
      columns[at] = column + 1;
    }
  std::iota(order.begin(), order.end(), 1);
  std::iota(kept.begin(), kept.end(), interior_ + 1);
  mumps_.n = static_cast<MUMPS_INT>(size);
  mumps_.nnz = static_cast<MUMPS_INT8>(entries);
  mumps_.irn = rows.data();
  mumps_.jcn = columns.data();
  mumps_.a = const_cast<double*>(stiffness.valuePtr());  // is only read
  mumps_.perm_in = order.data();
  mumps_.size_schur = interface_;
  mumps_.listvar_schur = kept.data();
  mumps_.schur = schur_.values().data();
  factorize_with_room();
  mumps_.irn = mumps_.jcn = mumps_.perm_in = mumps_.listvar_schur = nullptr;
  mumps_.a = mumps_.schur = nullptr;
  const int negative_pivots = mumps_.infog[12 - 1];
  if (negative_pivots > 0) throw unstable_interior();
}

/// The analysis may underestimate the workspace; then with more.
void MumpsFactor::factorize_with_room() {
  for (int percent = 20; percent <= 320; percent *= 2) {
    control(14) = percent;
    run(analyse_and_factorize);
    const int error = mumps_.infog[0];
    if (error != out_of_workspace && error != workspace_too_small) break;
  }
  require_mumps(mumps_.infog[0], mumps_.infog[1], mumps_.n);
}

StoredMatrix MumpsFactor::take_schur_complement() {
  // MUMPS fills one triangle. Tiles, because a row of a large matrix touches as many pages as it has columns.
  constexpr int tile = 512;
  auto& S = schur_.values();
  for (int column = 0; column < interface_; column += tile)
    for (int row = column; row < interface_; row += tile) {
      const int columns = std::min(tile, interface_ - column), rows = std::min(tile, interface_ - row);
      if (row == column)
        S.block(row, row, rows, rows).triangularView<Eigen::StrictlyLower>() =
            S.block(row, row, rows, rows).transpose();
      else
        S.block(row, column, rows, columns) = S.block(column, row, columns, rows).transpose();
    }
  return std::move(schur_);
}

/// Condensation of the interior (1) or expansion (2).
void MumpsFactor::solve_half(MUMPS_INT half, Eigen::MatrixXd& sector, Eigen::MatrixXd& on_interface) const {
  mumps_.nrhs = static_cast<MUMPS_INT>(sector.cols());
  mumps_.lrhs = static_cast<MUMPS_INT>(sector.rows());
  mumps_.rhs = sector.data();
  mumps_.lredrhs = std::max(interface_, 1);
  mumps_.redrhs = on_interface.data();
  control(26) = interface_ > 0 ? half : 0;
  run(solve);
  mumps_.rhs = mumps_.redrhs = nullptr;
  require_mumps(mumps_.infog[0], mumps_.infog[1], mumps_.n);
}

Eliminated MumpsFactor::eliminate(const Eigen::MatrixXd& interior_load) const {
  Eliminated result;
  result.until_substituted = std::unique_lock(one_at_a_time());
  result.state.setZero(interior_ + interface_, interior_load.cols());
  result.state.topRows(interior_) = interior_load;
  result.interface_load.setZero(interface_, interior_load.cols());
  solve_half(1, result.state, result.interface_load);
  return result;
}

Eigen::MatrixXd MumpsFactor::back_substitute(Eliminated&& eliminated, const Eigen::MatrixXd& moved) const {
  const std::unique_lock locked = std::move(eliminated.until_substituted);
  Eigen::MatrixXd result = std::move(eliminated.state), on_interface = moved;
  if (interface_ > 0) solve_half(2, result, on_interface);
  return result;
}

}  // namespace

void require_mumps(int error, int detail, Eigen::Index dofs) {
  if (error >= 0) return;
  const std::string sector = "a sector of " + std::to_string(dofs) + " dofs";
  constexpr int singular = -10, singular_root = -40, too_many_entries = -51, no_file = -90;
  constexpr int lacks[] = {-5, -7, -8, -9, -11, -13, -19, -20};
  if (error == singular || error == singular_root) throw unstable_interior();
  if (std::find(std::begin(lacks), std::end(lacks), error) != std::end(lacks))
    throw RunError(text_of("not enough memory to factorize ", sector, " by MUMPS (its error is ", error, ", ", detail,
                           "); coarsen the mesh, or take a machine with more memory"));
  if (error == too_many_entries)
    throw RunError(sector + " is too large for the ordering of MUMPS, whatever the memory; coarsen the mesh");
  if (error == no_file)
    throw RunError("MUMPS could not write or read the factor of " + sector +
                   " on disk; is the disk of model.h5 full?");
  throw RunError(text_of("MUMPS could not factorize ", sector, " (its error is ", error, ", ", detail, ")"));
}

std::unique_ptr<FactorEngine> factorize_by_mumps(const SymmetricMatrix& stiffness, const SectorDofs& dofs,
                                                 const FactorChoice& choice) {
  return std::make_unique<MumpsFactor>(stiffness, dofs, choice);
}

}  // namespace tiprub::reduce
