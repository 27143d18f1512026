// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/reduction.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <functional>
#include <utility>

#include "cases/program/machine.h"
#include "cases/program/text.h"
#include "reduce/basis/second_order_gap.h"
#include "reduce/model/condensation.h"
#include "reduce/operators/memory_need.h"
#include "reduce/operators/spinning_sector.h"
#include "reduce/sector/contact_unknowns.h"
#include "reduce/sector/parallel_for.h"
#include "reduce/shared_diameters.h"

namespace tiprub::reduce {

namespace {

/// A model's K by nodal diameter and sampled speed.
using SampledStiffness = std::vector<std::vector<Eigen::MatrixXcd>>;

/// n_s x nodal diameters.
Eigen::MatrixXd misfit(const SampledStiffness& stiffness, const SpeedSamples& samples,
                       const ReductionParameters& parameters, const ReducedModel& model) {
  const auto rows = static_cast<Eigen::Index>(parameters.verification_speeds.size());
  const auto diameters = static_cast<int>(stiffness.size());
  Eigen::MatrixXd table(rows, diameters);
  parallel_for(diameters, parameters.threads, [&](int n) {
    const NodalDiameterModel& fitted = model.nodal_diameters[n];
    for (Eigen::Index row = 0; row < rows; ++row) {
      const double fraction = parameters.verification_speeds[row];
      const Eigen::MatrixXcd K = samples.combine(stiffness[n], fraction);
      const Eigen::VectorXd exact = NodalDiameterModel{{{K}}, fitted.M}.natural_frequencies(0.0);
      const Eigen::VectorXd by_polynomial = fitted.natural_frequencies(fraction * parameters.speed_max);
      table(row, n) =
          (by_polynomial.array() / exact.array() - 1).head(parameters.verification_modes).abs().maxCoeff();
    }
  });
  return table;
}

/// eq. 7 of the paper: fills in K0, K1, ... of a model that has M. For nonlinear prestress it also fills in the
/// errors that only eq. 7 causes in the verification frequencies: K of the polynomial's shape against K of the
/// equilibrium on the same basis.
void fit_polynomial(const SampledStiffness& stiffness, const SpeedSamples& samples,
                    const ReductionParameters& parameters, ReducedModel& model) {
  const PolynomialFit fit(speeds_at(samples.polynomial_fractions(), parameters.speed_max));
  for (std::size_t n = 0; n < stiffness.size(); ++n)
    model.nodal_diameters[n].K =
        fit.through(std::vector(stiffness[n].begin(), stiffness[n].begin() + samples.polynomial_terms()));
  if (parameters.prestress == Prestress::nonlinear)
    model.verification.polynomial_misfit = misfit(stiffness, samples, parameters, model);
}

/// A mesh that the quadrature of its own cells makes softer than the larger space is has no error in this sense. Of a
/// sound mesh no estimate is below zero.
bool is_known(const MeshError& error) {
  return (error.frequency.array() >= 0).all() && (error.compliance.array() >= 0).all();
}

/// Those of some nodes that the file has.
std::vector<int> in_file(const SectorMesh& mesh, std::vector<int> nodes) {
  std::erase_if(nodes, [&](int node) { return node >= mesh.file_node_count(); });
  return nodes;
}

/// A sector as fields.h5 holds it, but for its shape under spin.
SectorFields describe_sector(const SectorMesh& mesh, const std::vector<int>& contact, const Material& material) {
  SectorFields sector;
  sector.sector_count = mesh.sector_count;
  sector.nodes = mesh.nodes.leftCols(mesh.file_node_count());
  sector.cells = mesh.cells;
  sector.node_sets = {{"clamped", in_file(mesh, mesh.clamped)},
                      {"contact", contact},
                      {"contact_line", mesh.contact_line},
                      {"cyclic_low", in_file(mesh, mesh.cyclic_low)},
                      {"cyclic_high", in_file(mesh, mesh.cyclic_high)}};
  if (!mesh.splitter_line.empty()) sector.node_sets["contact_splitter"] = mesh.splitter_line;
  sector.parts = mesh.parts;
  sector.mesh_digest = digest(mesh);
  sector.young = material.young;
  sector.poisson = material.poisson;
  sector.density = material.density;
  return sector;
}

/// One vector of sector dofs on all nodes of the file: r, theta, z of node 0, then of node 1, ...; zero where
/// clamped.
Eigen::VectorXcd on_nodes(const SectorMesh& mesh, const SectorDofs& dofs, const Eigen::VectorXcd& sector_vector) {
  Eigen::VectorXcd values = Eigen::VectorXcd::Zero(3 * mesh.file_node_count());
  for (int node = 0; node < mesh.file_node_count(); ++node)
    if (dofs.first[node] >= 0) values.segment<3>(3 * node) = sector_vector.segment<3>(dofs.first[node]);
  return values;
}

/// The work of one reduction. Two factors, of rest and of full speed, serve all nodal diameters; these are reduced
/// side by side, and the memory of each is released as soon as its model is made and verified.
class Reducer {
 public:
  Reducer(const SectorMesh& mesh, const ReductionParameters& parameters, Progress& progress, FieldsWriter* fields,
          ProcessGroup& group)
      : mesh_(mesh),
        parameters_(parameters),
        progress_(progress),
        fields_(fields),
        group_(group),
        contact_(choose_contact(mesh, parameters.contact, parameters.contact_nodes)),
        dofs_(number_dofs(mesh, contact_)),
        factors_{FactorMethod::cholmod, parameters.scratch_folder} {
    for (int n = 0; n <= mesh.sector_count / 2; ++n) transforms_.emplace_back(dofs_, mesh.sector_count, n);
    std::vector<double> with_fields = {fields == nullptr ? 0.0 : 1.0};
    group.agree(nullptr);
    group.share(with_fields);
    with_fields_ = with_fields.front() != 0;
  }

  /// Only the leader's is whole.
  ReducedModel run(ReductionReport& report) {
    report.sector_dofs = dofs_.sector();
    require_room(report);
    SpinningSector sector(mesh_, dofs_, parameters_);
    report.sector_mass = sector.total_mass();
    timed(report, "mass and stiffness at rest");
    const SectorFactor at_rest = sector.factorize(0.0, factors_);
    timed(report, "factor at rest");
    require_room(sector.spin(at_rest, transforms_[0]), report);
    report.shape_terms = static_cast<int>(sector.shape().displacement.terms.size());
    report.newton_steps = sector.shape().equilibria.newton_steps;
    report.newton_residual = sector.shape().equilibria.newton_residual;
    timed(report, "shape under spin");
    ReducedModel model = describe(sector.shape());
    if (group_.leads() && sector.elasticity() != nullptr)
      model.contact.second_order = second_order_gap(sector, at_rest, contact_);
    timed(report, "second order of the gap");
    sector.sample();
    timed(report, "stiffness under spin");
    const SectorFactor at_top = sector.factorize(1.0, factors_);
    timed(report, "factor at full speed");
    std::optional<MeshErrorEstimate> mesh_error;
    if (estimates_mesh_error()) mesh_error.emplace(mesh_, dofs_, parameters_.material, parameters_.threads);
    timed(report, "functions that the mesh lacks");
    write_sector_fields(sector.shape());
    const SampledStiffness stiffness = blaming_shape(sector.shape(), [&] {
      return reduce_diameters(
          {parameters_, sector, at_rest, at_top, contact_, mesh_error ? &*mesh_error : nullptr, with_fields_}, model,
          report);
    });
    timed(report, "modes, bases, verification");
    if (!group_.leads()) return model;
    fit_polynomial(stiffness, sector.samples(), parameters_, model);  // eq. 7
    find_reduced_frequencies(model);
    timed(report, "model");
    return model;
  }

 private:
  bool estimates_mesh_error() const { return parameters_.mesh_error && AddedFunctions::serve(mesh_); }

  MemoryNeed memory_need_of(const SpeedSamples& samples) const {
    return memory_need(mesh_, dofs_,
                       {.factors = 2,
                        .stiffnesses = static_cast<int>(samples.fractions().size()),
                        .columns = columns_at_once(),
                        .mesh_error = estimates_mesh_error() ? MeshErrorEstimate::memory(mesh_) : 0,
                        .threads = parameters_.threads});
  }

  /// Decides by the memory how to factorize, and starts the threads. Raises RunError if the expected shape needs
  /// more.
  void require_room(ReductionReport& report) {
    constexpr int usual_terms = 2;  // of a shape that isn't linear
    const SpeedSamples samples(parameters_, parameters_.prestress == Prestress::nonlinear ? usual_terms : 1);
    const MemoryNeed need = memory_need_of(samples);
    report.memory_available = available_at_start_;
    report.memory_by_cholmod = need.total(FactorMethod::cholmod);
    report.factor_method = factors_.method = choose_method(need, parameters_, group_.local_size());
    start_threads(need, factors_.method, parameters_.threads);
    report.memory_needed = need.total(factors_.method);
  }

  /// Requires the memory, as it was available at the start, for the shape that was found, if that takes more.
  void require_room(const SpeedSamples& samples, ReductionReport& report) const {
    const MemoryNeed need = memory_need_of(samples);
    const double total = need.total(factors_.method);
    if (total > report.memory_needed) require_memory(need, factors_.method, available_at_start_, mappable_at_start_);
    report.memory_needed = std::max(report.memory_needed, total);
  }

  /// K of a polynomial far from the shape under spin may look like that of an unstable rotor; the message says so.
  SampledStiffness blaming_shape(const SpinShape& shape, const std::function<SampledStiffness()>& body) const {
    try {
      return body();
    } catch (const RunError& error) {
      if (shape.imbalance <= parameters_.polynomial_tolerance) throw;
      throw RunError(
          text_of(error.what(), ", or its shape changes too much for eq. 7: ", std::to_string(100 * shape.imbalance),
                  " % of the load is out of balance between its speeds; lower speed_max_rpm, or take prestress = "
                  "\"linear\""));
    }
  }

  /// Complex vectors that one nodal diameter holds: its basis, and either the Lanczos vectors with their products or
  /// the vectors that follow all modes at all verification speeds (shapes, loads, directions, and those of some
  /// rounds).
  int columns_at_once() const {
    constexpr int krylov = 6, following = 8;
    const int modes = parameters_.fixed_interface_modes;
    const int followed = parameters_.verification_modes * static_cast<int>(parameters_.verification_speeds.size());
    const int segment_modes = 2 * (dofs_.contact_dofs() - dofs_.boundary());  // of two solvers
    return std::max(krylov * modes, 2 * (modes + dofs_.contact_dofs()) + following * followed) + segment_modes;
  }

  /// Notes how long it took since the last note.
  void timed(ReductionReport& report, const char* what) {
    const auto now = std::chrono::steady_clock::now();
    const std::clock_t processor = std::clock();
    report.parts.push_back({what, std::chrono::duration<double>(now - last_).count(),
                            static_cast<double>(processor - processor_) / CLOCKS_PER_SEC});
    last_ = now;
    processor_ = processor;
  }

  ReducedModel describe(const SpinShape& shape) const {
    ReducedModel model;
    model.sector_count = mesh_.sector_count;
    model.speed_max = parameters_.speed_max;
    model.modes_at_speed = parameters_.modes_at_speed;
    if (mesh_.matrices == nullptr) {
      model.prestress = parameters_.prestress;
      model.spin_softening = parameters_.spin_softening;
    }
    model.contact = contact_.line;
    if (model.prestress == Prestress::nonlinear)
      model.verification.shape_balance = ShapeBalance{shape.imbalance, parameters_.polynomial_tolerance};
    std::vector<Eigen::MatrixX3d>& shift = model.contact.static_shift.terms;
    shift.clear();
    for (const Eigen::VectorXd& term : shape.displacement.terms)
      shift.emplace_back((dofs_.contact_loads.transpose() * term).reshaped(3, model.contact.size()).transpose());
    return model;
  }

  void write_sector_fields(const SpinShape& shape) const {
    if (fields_ == nullptr) return;
    SectorFields sector = describe_sector(mesh_, contact_.nodes, parameters_.material);
    for (const Eigen::VectorXd& term : shape.displacement.terms)
      sector.static_displacement.terms.emplace_back(
          on_nodes(mesh_, dofs_, term.cast<std::complex<double>>()).real().reshaped(3, mesh_.file_node_count()));
    fields_->write_sector(sector);
  }

  void write_basis(int n, Eigen::Index dofs, const ShapeOfBasis& shape) {
    fields_->write_basis(n, dofs, transforms_[n].is_real(),
                         [&](Eigen::Index k) { return on_nodes(mesh_, dofs_, transforms_[n].expand(shape(k))); });
  }

  /// What cells contribute to the error of the mesh; empty unless fields.h5 takes it.
  struct CellErrors {
    CellErrors(Eigen::Index cells, std::size_t diameters) : frequency(cells, static_cast<Eigen::Index>(diameters)) {}
    void keep(int n, DiameterResult& result) {
      if (frequency.size() == 0) return;
      frequency.col(n) = result.frequency_cells;
      if (n == 0) compliance = std::move(result.compliance_cells);
    }
    void write(FieldsWriter* fields) const {
      if (frequency.size() > 0) fields->write_mesh_error(frequency.rowwise().mean(), compliance);
    }
    Eigen::MatrixXd frequency;   ///< cells x nodal diameters
    Eigen::VectorXd compliance;  ///< of nodal diameter 0
  };

  void make_room(ReducedModel& model, ReductionReport& report, bool with_mesh_error) const {
    const auto rows = static_cast<Eigen::Index>(parameters_.verification_speeds.size());
    report.generalized_dofs.resize(transforms_.size());
    report.dropped.resize(transforms_.size());
    report.corrections.resize(transforms_.size());
    model.verification.speeds =
        parameters_.speed_max * Eigen::Map<const Eigen::VectorXd>(parameters_.verification_speeds.data(), rows);
    model.verification.unreduced.resize(transforms_.size());
    model.nodal_diameters.resize(transforms_.size());
    if (with_mesh_error)
      model.mesh_error.emplace().frequency.resize(static_cast<Eigen::Index>(transforms_.size()),
                                                  parameters_.verification_modes);
  }

  /// Every nodal diameter's M, basis and unreduced frequencies; returns their K at the samples.
  SampledStiffness reduce_diameters(const SharedByDiameters& shared, ReducedModel& model, ReductionReport& report) {
    const std::size_t diameters = transforms_.size();
    make_room(model, report, shared.mesh_error != nullptr);
    CellErrors of_cells(model.mesh_error && fields_ != nullptr ? mesh_.cell_count() : 0, diameters);
    SampledStiffness stiffness(diameters);
    const auto keep = [&](int n, DiameterResult result, const ShapeOfBasis& shapes) {
      if (fields_ != nullptr) write_basis(n, result.mass.cols(), shapes);
      report.generalized_dofs[n] = result.generalized_dofs;
      report.dropped[n] = result.dropped;
      report.corrections[n] = result.corrections;
      stiffness[n] = std::move(result.stiffness);
      model.nodal_diameters[n].M = std::move(result.mass);
      model.verification.unreduced[n] = std::move(result.unreduced);
      if (model.mesh_error) model.mesh_error->frequency.row(n) = result.frequency_errors.transpose();
      if (model.mesh_error && n == 0) model.mesh_error->compliance = std::move(result.compliance_errors);
      of_cells.keep(n, result);
    };
    const auto reduce = [&](int n) { return reduce_diameter(shared, transforms_[n], n, progress_); };
    share_diameters(group_, static_cast<int>(diameters), parameters_.threads, reduce, keep);
    if (model.mesh_error && group_.leads()) {
      report.mesh_error_unknown = !is_known(*model.mesh_error);
      report.mesh_error_unknown ? model.mesh_error.reset() : of_cells.write(fields_);
    }
    return stiffness;
  }

  /// The model's own frequencies beside the unreduced ones, with as many dofs as it has at any one speed.
  void find_reduced_frequencies(ReducedModel& model) const {
    Verification& table = model.verification;
    table.reduced = table.unreduced;
    parallel_for(static_cast<int>(table.reduced.size()), parameters_.threads, [&](int n) {
      for (Eigen::Index row = 0; row < table.speeds.size(); ++row)
        table.reduced[n].row(row) =
            condense(model.nodal_diameters[n], table.speeds[row], dofs_.contact_dofs(), parameters_.modes_at_speed)
                .natural_frequencies()
                .head(parameters_.verification_modes)
                .transpose();
    });
  }

  const SectorMesh& mesh_;
  const ReductionParameters& parameters_;
  Progress& progress_;
  FieldsWriter* fields_;
  ProcessGroup& group_;
  bool with_fields_ = false;  ///< the leader writes them
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::clock_t processor_ = std::clock();
  ContactUnknowns contact_;
  SectorDofs dofs_;
  std::vector<CyclicTransformation> transforms_;
  FactorChoice factors_;
  double available_at_start_ = available_memory();
  double mappable_at_start_ = mappable_memory();
};

}  // namespace

ReducedModel reduce(const SectorMesh& mesh, const ReductionParameters& parameters, Progress::Shown shown,
                    ReductionReport& report, FieldsWriter* fields, ProcessGroup& group) {
  const int own_diameters = mesh.sector_count / 2 / group.size() + 1;  // of the leader
  Progress progress("reducing", steps_of_a_diameter * own_diameters, shown);
  ReducedModel model = Reducer(mesh, parameters, progress, fields, group).run(report);
  if (group.leads()) model.effects = effects_of(model);
  return model;
}

CheckedSector check_sector(const SectorMesh& mesh, const ReductionParameters& parameters) {
  const SectorDofs dofs = number_dofs(mesh, choose_contact(mesh, parameters.contact, parameters.contact_nodes));
  start_threads(memory_need(mesh, dofs, {}), FactorMethod::cholmod, 1);
  if (mesh.matrices != nullptr) return {dofs.sector(), mesh.matrices->total_mass()};
  return {dofs.sector(), RotatingElasticity(mesh, dofs, parameters.material).total_mass()};
}

}  // namespace tiprub::reduce
