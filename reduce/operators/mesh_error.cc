// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/mesh_error.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "mesh/cells/cell_kind.h"
#include "reduce/sector/contact_line.h"
#include "reduce/sector/parallel_for.h"

namespace tiprub::reduce {

namespace {

/// Steps of conjugate gradients. Four find three quarters and more of the energy for modes; forces on a tip, whose
/// displacements are less smooth, take more.
constexpr int steps_for_modes = 4, steps_for_forces = 12;

using RealRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The rows of a cell's functions, three of each, zero where one doesn't move: real and imaginary parts by turns.
template <class Rows>
RealRows rows_of(const Rows& all, const std::vector<int>& firsts) {
  RealRows rows = RealRows::Zero(3 * static_cast<Eigen::Index>(firsts.size()), 2 * all.cols());
  const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> real(
      reinterpret_cast<const double*>(all.data()), all.rows(), 2 * all.cols());
  for (std::size_t k = 0; k < firsts.size(); ++k)
    if (firsts[k] >= 0) rows.middleRows<3>(3 * static_cast<Eigen::Index>(k)) = real.middleRows<3>(firsts[k]);
  return rows;
}

template <class Rows>
void add_rows(const Eigen::Ref<const RealRows>& rows, const std::vector<int>& firsts, Rows& all) {
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> real(
      reinterpret_cast<double*>(all.data()), all.rows(), 2 * all.cols());
  for (std::size_t k = 0; k < firsts.size(); ++k)
    if (firsts[k] >= 0) real.middleRows<3>(firsts[k]) += rows.middleRows<3>(3 * static_cast<Eigen::Index>(k));
}

template <class Rows>
Eigen::RowVectorXd inner_products(const Rows& a, const Rows& b) {
  return a.conjugate().cwiseProduct(b).colwise().sum().real();
}

/// Zero where a residual vanishes; not a number where rounding made an energy negative.
Eigen::RowVectorXd ratios(const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b) {
  const Eigen::RowVectorXd positive = (b.array() > 0).select(b, std::numeric_limits<double>::quiet_NaN());
  return (b.array() == 0).select(0.0, a.array() / positive.array());
}

/// What each cell contributes to the mean of some errors, by its part of their energies.
MeshErrorEstimate::Errors shared_out(const Eigen::VectorXd& errors, const Eigen::MatrixXd& energies_of_cells) {
  const Eigen::RowVectorXd totals = energies_of_cells.colwise().sum();
  const Eigen::RowVectorXd share = ratios(errors.transpose(), totals) / static_cast<double>(errors.size());
  return {errors, energies_of_cells * share.transpose()};
}

}  // namespace

/// Finds the patches of a sector whose neighbours are laid beside it.
class MeshErrorEstimate::Patches {
 public:
  Patches(const SectorMesh& mesh, const SectorDofs& node_dofs, const SectorDofs& cubic_dofs,
          const std::vector<AddedCell>& cells)
      : mesh_(mesh), node_dofs_(node_dofs), cubic_dofs_(cubic_dofs), cells_(cells) {
    for (int c = 0; c < mesh.cell_count(); ++c) {
      for (const int first : cells[c].functions) note(seen(cubic_dofs, first), c, around_function_);
      for (const int first : cells[c].nodes)
        if (first >= 0) note(seen(node_dofs, first), c, around_node_);
    }
  }

  std::vector<Patch> find(int threads) const {
    const std::vector<Cells> all = around_corners();
    std::vector<Patch> patches(all.size());
    parallel_for(static_cast<int>(all.size()), threads, [&](int k) { patches[k] = patch_of(all[k]); });
    return patches;
  }

 private:
  /// Cells, with the number of sectors from the patch to that of the cell; ascending.
  using Cells = std::vector<std::pair<int, int>>;
  using Numbers = std::map<Seen, Eigen::Index>;

  /// A sector dof as the cells of its sector see it: the high cut face is the low one of the next sector.
  static Seen seen(const SectorDofs& dofs, int first) {
    if (first < dofs.interior + dofs.face) return {first, 0};
    return {first - dofs.face, first < dofs.interior + 2 * dofs.face ? 1 : 0};
  }

  static void note(const Seen& function, int cell, std::map<int, Cells>& around) {
    around[function.dof].emplace_back(cell, -function.sectors);
  }

  /// One patch for all corners with the same cells, as those above each other in a plate of one layer.
  std::vector<Cells> around_corners() const {
    std::map<int, int> lower;
    for (std::size_t k = 0; k < mesh_.cyclic_low.size(); ++k) lower[mesh_.cyclic_high[k]] = mesh_.cyclic_low[k];
    std::map<int, Cells> around;
    for (int c = 0; c < mesh_.cell_count(); ++c)
      for (int k = 0; k < cell_kind(static_cast<int>(cells_[c].nodes.size())).corners; ++k) {
        const int node = mesh_.cells(k, c);
        const auto partner = lower.find(node);
        note(partner == lower.end() ? Seen{node, 0} : Seen{partner->second, 1}, c, around);
      }
    std::set<Cells> all;
    for (auto& [corner, cells] : around) {
      std::ranges::sort(cells);
      all.insert(cells);
    }
    return {all.begin(), all.end()};
  }

  /// Numbers the functions of some cells that vanish outside of them.
  static void number_inner(const std::map<int, Cells>& around, const SectorDofs& dofs, const std::vector<int>& firsts,
                           int sectors, const Cells& patch, Numbers& numbers) {
    for (const int first : firsts) {
      if (first < 0) continue;
      Seen function = seen(dofs, first);
      function.sectors += sectors;
      const Cells& cells = around.at(function.dof);
      const bool inside = std::ranges::all_of(cells, [&](const auto& cell) {
        return std::ranges::binary_search(patch, std::pair(cell.first, cell.second + function.sectors));
      });
      if (inside) numbers.try_emplace(function, static_cast<Eigen::Index>(numbers.size()));
    }
  }

  /// Places of a cell's functions in a patch; -1 of those that aren't in it.
  static std::vector<Eigen::Index> places(const SectorDofs& dofs, const std::vector<int>& firsts, int sectors,
                                          const Numbers& numbers, Eigen::Index before) {
    std::vector<Eigen::Index> found;
    for (const int first : firsts) {
      Seen function = first < 0 ? Seen{-1, 0} : seen(dofs, first);
      function.sectors += sectors;
      const auto known = numbers.find(function);
      found.push_back(known == numbers.end() ? -1 : before + known->second);
    }
    return found;
  }

  Patch patch_of(const Cells& patch) const {
    Numbers cubic, nodes;
    for (const auto& [cell, sectors] : patch) {
      number_inner(around_function_, cubic_dofs_, cells_[cell].functions, sectors, patch, cubic);
      number_inner(around_node_, node_dofs_, cells_[cell].nodes, sectors, patch, nodes);
    }
    const auto w = static_cast<Eigen::Index>(cubic.size()), u = static_cast<Eigen::Index>(nodes.size());
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(3 * (w + u), 3 * (w + u));
    for (const auto& [cell, sectors] : patch) {
      const AddedCell& of = cells_[cell];
      const auto rows = places(cubic_dofs_, of.functions, sectors, cubic, 0);
      const auto columns = places(node_dofs_, of.nodes, sectors, nodes, w);
      add(of.stiffness, rows, rows, K);
      add(of.coupling, rows, columns, K);
      add(of.of_nodes, columns, columns, K);
    }
    Patch result;
    result.functions.resize(cubic.size());
    for (const auto& [function, k] : cubic) result.functions[static_cast<std::size_t>(k)] = function;
    // The symmetric part that add() leaves out is not read: only K_wu and K_uu are.
    const Eigen::MatrixXd K_wu = K.topRightCorner(3 * w, 3 * u);
    const Eigen::MatrixXd schur =
        K.topLeftCorner(3 * w, 3 * w) - K_wu * K.bottomRightCorner(3 * u, 3 * u).ldlt().solve(K_wu.transpose());
    result.compliance = schur.llt().solve(Eigen::MatrixXd::Identity(3 * w, 3 * w)).cast<float>();
    return result;
  }

  template <class Matrix>
  static void add(const Matrix& of_cell, const std::vector<Eigen::Index>& rows,
                  const std::vector<Eigen::Index>& columns, Eigen::MatrixXd& K) {
    for (std::size_t b = 0; b < columns.size(); ++b)
      for (std::size_t a = 0; a < rows.size(); ++a)
        if (rows[a] >= 0 && columns[b] >= 0)
          K.block<3, 3>(3 * rows[a], 3 * columns[b]) +=
              of_cell.template block<3, 3>(3 * static_cast<Eigen::Index>(a), 3 * static_cast<Eigen::Index>(b))
                  .template cast<double>();
  }

  const SectorMesh& mesh_;
  const SectorDofs& node_dofs_;
  const SectorDofs& cubic_dofs_;
  const std::vector<AddedCell>& cells_;
  std::map<int, Cells> around_function_, around_node_;  // by independent dof
};

double MeshErrorEstimate::memory(const SectorMesh& mesh) {
  constexpr double patch = 30e3, patch_of_complete_bricks = 110e3;  // a cell
  constexpr int complete = 27;
  return AddedFunctions::memory(mesh) +
         (mesh.cells.rows() == complete ? patch_of_complete_bricks : patch) * mesh.cell_count();
}

MeshErrorEstimate::MeshErrorEstimate(const SectorMesh& mesh, const SectorDofs& dofs, const Material& material,
                                     int threads)
    : node_dofs_(dofs), functions_(mesh), cells_(mesh.cell_count()) {
  parallel_for(mesh.cell_count(), threads,
               [&](int cell) { cells_[cell] = functions_.integrate(cell, dofs, material); });
  patches_ = Patches(mesh, dofs, functions_.dofs(), cells_).find(threads);
  constexpr int corners_of_brick = 8;
  of_bricks_ = std::ranges::all_of(cells_, [](const AddedCell& cell) {
    return cell_kind(static_cast<int>(cell.nodes.size())).corners == corners_of_brick;
  });
}

MeshErrorEstimate::Errors MeshErrorEstimate::of_frequencies(const CyclicSolver& at_rest,
                                                            const Eigen::VectorXd& eigenvalues,
                                                            const Eigen::MatrixXcd& shapes) const {
  const Pair inertia = apply_mass(at_rest, shapes);
  const Eigen::ArrayXd mass = inner_products(Rows(shapes), inertia.nodes).transpose();
  const Growths found = growths(
      at_rest, {inertia.cubic * eigenvalues.asDiagonal(), inertia.nodes * eigenvalues.asDiagonal()}, steps_for_modes);
  return shared_out((mass * (1 + found.of_each)).sqrt() - 1, found.of_cells);
}

MeshErrorEstimate::Errors MeshErrorEstimate::of_compliances(const CyclicSolver& at_rest,
                                                            const ContactUnknowns& contact) const {
  const CyclicTransformation &nodes = at_rest.transform(), cubic = nodes.with(functions_.dofs());
  const Eigen::MatrixXd along_normals = normal_forces(contact.line);
  const auto complex = [](const Eigen::MatrixXd& loads) { return loads.cast<std::complex<double>>().eval(); };
  const Growths found = growths(
      at_rest,
      {cubic.gather(complex(functions_.contact_loads(contact.added_weights, contact.line.size()) * along_normals)),
       nodes.gather(complex(node_dofs_.contact_loads * along_normals))},
      steps_for_forces);
  return shared_out(found.of_each / (1 + found.of_each), found.of_cells);
}

MeshErrorEstimate::Growths MeshErrorEstimate::growths(const CyclicSolver& at_rest, const Pair& load,
                                                      int steps) const {
  const Rows moved = at_rest.solve(load.nodes, ContactNodes::free);
  const Pair held = apply_stiffness(at_rest, {Rows::Zero(load.cubic.rows(), load.cubic.cols()), moved});
  Pair residual = {load.cubic - held.cubic, load.nodes - held.nodes};
  const Eigen::RowVectorXd work = inner_products(load.nodes, moved);
  const Eigen::RowVectorXd by_quadrature = inner_products(moved, residual.nodes);
  const Change found = change(at_rest, std::move(residual), steps);
  return {((by_quadrature + found.energy).array() / work.array()).transpose(),
          energies_of_cells(at_rest, found.displacement)};
}

/// By conjugate gradients, whose energy is that of A^-1 r from below.
MeshErrorEstimate::Change MeshErrorEstimate::change(const CyclicSolver& at_rest, Pair r, int steps) const {
  const auto products = [](const Pair& a, const Pair& b) {
    return Eigen::RowVectorXd(inner_products(a.cubic, b.cubic) + inner_products(a.nodes, b.nodes));
  };
  const auto add = [](Pair& to, const Pair& more, const Eigen::RowVectorXd& factor) {
    to.cubic += more.cubic * factor.asDiagonal();
    to.nodes += more.nodes * factor.asDiagonal();
  };
  if (of_bricks_) r.nodes.setZero();
  Pair z = precondition(at_rest, r), p = z;
  Change found = {{Rows::Zero(z.cubic.rows(), z.cubic.cols()), Rows::Zero(z.nodes.rows(), z.nodes.cols())},
                  Eigen::RowVectorXd::Zero(z.nodes.cols())};
  Eigen::RowVectorXd rz = products(r, z);
  for (int k = 0; k < steps; ++k) {
    const Pair Ap = apply_stiffness(at_rest, p);
    const Eigen::RowVectorXd step = ratios(rz, products(p, Ap));
    found.energy += step.cwiseProduct(rz);
    add(found.displacement, p, step);
    if (k + 1 == steps) break;
    add(r, Ap, -step);
    if (of_bricks_) r.nodes.setZero();
    z = precondition(at_rest, r);
    const Eigen::RowVectorXd next = products(r, z), part = ratios(next, rz);
    add(z, p, part);
    std::swap(p, z);
    rz = next;
  }
  return found;
}

Eigen::MatrixXd MeshErrorEstimate::energies_of_cells(const CyclicSolver& at_rest, const Pair& displacement) const {
  const CyclicTransformation& nodes = at_rest.transform();
  const Rows cubic_moved = nodes.with(functions_.dofs()).expand(displacement.cubic);
  const Rows nodes_moved = nodes.expand(displacement.nodes);
  Eigen::MatrixXd energy(static_cast<Eigen::Index>(cells_.size()), cubic_moved.cols());
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const AddedCell& cell = cells_[c];
    const RealRows w = rows_of(cubic_moved, cell.functions), u = rows_of(nodes_moved, cell.nodes);
    const Eigen::RowVectorXd parts =  // real and imaginary ones by turns
        w.cwiseProduct(cell.stiffness.cast<double>() * w + 2 * (cell.coupling * u)).colwise().sum() +
        u.cwiseProduct(cell.of_nodes * u).colwise().sum();
    for (Eigen::Index k = 0; k < energy.cols(); ++k)
      energy(static_cast<Eigen::Index>(c), k) = parts[2 * k] + parts[2 * k + 1];
  }
  return energy;
}

MeshErrorEstimate::Pair MeshErrorEstimate::apply_stiffness(const CyclicSolver& at_rest,
                                                           const Pair& displacement) const {
  const CyclicTransformation& nodes = at_rest.transform();
  const CyclicTransformation functions = nodes.with(functions_.dofs());
  const Rows cubic_moved = functions.expand(displacement.cubic), nodes_moved = nodes.expand(displacement.nodes);
  Rows cubic_force = Rows::Zero(cubic_moved.rows(), cubic_moved.cols());
  Rows nodes_force = Rows::Zero(nodes_moved.rows(), nodes_moved.cols());
  for (const AddedCell& cell : cells_) {
    const RealRows w = rows_of(cubic_moved, cell.functions), u = rows_of(nodes_moved, cell.nodes);
    add_rows(cell.stiffness.cast<double>() * w + cell.coupling * u, cell.functions, cubic_force);
    add_rows(cell.coupling.transpose() * w + cell.of_nodes * u, cell.nodes, nodes_force);
  }
  return {functions.gather(cubic_force), nodes.gather(nodes_force)};
}

/// Forces of inertia under an acceleration of the nodes.
MeshErrorEstimate::Pair MeshErrorEstimate::apply_mass(const CyclicSolver& at_rest,
                                                      const Eigen::MatrixXcd& acceleration) const {
  const CyclicTransformation& nodes = at_rest.transform();
  const CyclicTransformation functions = nodes.with(functions_.dofs());
  const Rows accelerated = nodes.expand(acceleration);
  Rows cubic_force = Rows::Zero(functions_.dofs().sector(), accelerated.cols());
  Rows nodes_force = Rows::Zero(accelerated.rows(), accelerated.cols());
  for (const AddedCell& cell : cells_) {
    const RealRows force = cell.mass.cast<double>() * rows_of(accelerated, cell.nodes);
    const auto cubic = 3 * static_cast<Eigen::Index>(cell.functions.size());
    add_rows(force.topRows(cubic), cell.functions, cubic_force);
    add_rows(force.bottomRows(force.rows() - cubic), cell.nodes, nodes_force);
  }
  return {functions.gather(cubic_force), nodes.gather(nodes_force)};
}

/// The nodes by K where their residual matters, then the cubic functions by the patches, then the nodes that follow.
MeshErrorEstimate::Pair MeshErrorEstimate::precondition(const CyclicSolver& at_rest, const Pair& residual) const {
  const CyclicTransformation& nodes = at_rest.transform();
  const CyclicTransformation functions = nodes.with(functions_.dofs());
  Pair result = {residual.cubic, Rows::Zero(residual.nodes.rows(), residual.nodes.cols())};
  if (!of_bricks_) {
    result.nodes = at_rest.solve(residual.nodes, ContactNodes::free);
    const Rows start = nodes.expand(result.nodes);
    Rows cubic_force = Rows::Zero(functions_.dofs().sector(), start.cols());
    for (const AddedCell& cell : cells_)
      add_rows(cell.coupling * rows_of(start, cell.nodes), cell.functions, cubic_force);
    result.cubic -= Rows(functions.gather(cubic_force));
  }
  result.cubic = solve_patches(at_rest, result.cubic);
  const Rows moved = functions.expand(result.cubic);
  Rows force = Rows::Zero(node_dofs_.sector(), moved.cols());
  for (const AddedCell& cell : cells_)
    add_rows(cell.coupling.transpose() * rows_of(moved, cell.functions), cell.nodes, force);
  result.nodes -= at_rest.solve(nodes.gather(force), ContactNodes::free);
  return result;
}

MeshErrorEstimate::Rows MeshErrorEstimate::solve_patches(const CyclicSolver& at_rest, const Rows& residual) const {
  const std::complex<double> phase = at_rest.transform().phase();
  // A function of the sector before, -1, moves in the frame of the patch by e^{-i n alpha} times its motion here.
  const auto factor = [&](int sectors) { return sectors == 0 ? 1.0 : sectors > 0 ? phase : std::conj(phase); };
  Rows sum = Rows::Zero(residual.rows(), residual.cols());
  for (const Patch& patch : patches_) {
    Rows load(3 * static_cast<Eigen::Index>(patch.functions.size()), residual.cols());
    std::vector<int> all;
    for (std::size_t k = 0; k < patch.functions.size(); ++k) {
      const auto& [dof, sectors] = patch.functions[k];
      load.middleRows<3>(3 * static_cast<Eigen::Index>(k)) = factor(sectors) * residual.middleRows<3>(dof);
      all.push_back(static_cast<int>(3 * k));
    }
    Rows moved = Rows::Zero(load.rows(), load.cols());
    add_rows((patch.compliance * rows_of(load, all).cast<float>()).cast<double>(), all, moved);
    for (std::size_t k = 0; k < patch.functions.size(); ++k) {
      const auto& [dof, sectors] = patch.functions[k];
      sum.middleRows<3>(dof) += std::conj(factor(sectors)) * moved.middleRows<3>(3 * static_cast<Eigen::Index>(k));
    }
  }
  return sum;
}

}  // namespace tiprub::reduce
