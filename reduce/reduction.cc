// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/reduction.h"

#include <cblas.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "reduce/condensation.h"
#include "reduce/contact_line.h"
#include "reduce/craig_bampton.h"
#include "reduce/cyclic_modes.h"
#include "reduce/memory_need.h"
#include "reduce/mode_following.h"
#include "reduce/parallel_for.h"
#include "reduce/sector_fields.h"
#include "reduce/speed_polynomial.h"
#include "reduce/spin_equilibrium.h"

namespace tiprub {

namespace {

constexpr double mode_tolerance = 1e-7;  // of 1/omega^2, a residual; the error of a frequency goes with its square
constexpr int guesses_per_mode = 2;      // the model's next modes come free, and speed up the last wanted ones

double rpm(double speed) {
  return speed * 30 / std::numbers::pi;
}

/// The work of one reduction. One speed after the other is factorized; nodal diameters go side by side.
class Reducer {
 public:
  Reducer(const SectorMesh& mesh, const ReductionParameters& parameters, Progress& progress)
      : mesh_(mesh),
        parameters_(parameters),
        progress_(progress),
        contact_(choose_contact_nodes(mesh, parameters.contact_nodes)),
        dofs_(number_dofs(mesh, contact_)),
        elasticity_(mesh, dofs_, parameters.material, parameters.threads),
        mass_(elasticity_.mass()) {
    for (int n = 0; n <= mesh.sector_count / 2; ++n) waves_.emplace_back(dofs_, mesh.sector_count, n);
    shapes_.resize(waves_.size());
    bases_.resize(waves_.size());
  }

  static int steps(const SectorMesh& mesh, const ReductionParameters& parameters) {
    return (mesh.sector_count / 2 + 1) * (3 + static_cast<int>(parameters.verification_speeds.size()));
  }

  ReducedModel run(ReductionReport& report, FieldsWriter* fields) {
    report.sector_dofs = dofs_.sector();
    report.clamped_face_nodes = dofs_.clamped_face_nodes;
    const MemoryNeed need =
        memory_need(mesh_, dofs_, 2 * (parameters_.fixed_interface_modes + dofs_.boundary()), parameters_.threads);
    report.memory_needed = need.total();
    require_memory(need, available_memory());
    timed(report, "mesh and mass", [] {});
    if (parameters_.prestress == Prestress::nonlinear)
      timed(report, "shapes under spin", [&] { find_equilibria(report); });
    timed(report, "at rest", [&] { at_speed(0.0, [&](const SymmetricMatrix& K) { solve_rest(K); }); });
    timed(report, "at full speed", [&] { at_speed(1.0, [&](const SymmetricMatrix& K) { solve_full_speed(K); }); });
    ReducedModel model;
    model.sector_count = mesh_.sector_count;
    model.speed_max = parameters_.speed_max;
    model.modes_at_speed = parameters_.modes_at_speed;
    model.prestress = name_of(parameters_.prestress);
    if (parameters_.spin_softening == SpinSoftening::off) model.prestress += ", without spin softening";
    model.contact = describe_contact(mesh_, contact_);
    describe_static_shift(model.contact);
    timed(report, "basis and projection", [&] { build(model, report); });
    if (fields != nullptr) timed(report, "fields", [&] { write_fields(*fields); });
    timed(report, "verification", [&] { verify(model); });
    return model;
  }

 private:
  template <class Body>
  void timed(ReductionReport& report, const char* what, const Body& body) {
    body();
    const auto now = std::chrono::steady_clock::now();
    report.seconds.emplace_back(what, std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }

  /// One basis a nodal diameter, and the model's matrices on it.
  void build(ReducedModel& model, ReductionReport& report) {
    stiffness_at(0.5);
    model.nodal_diameters.resize(waves_.size());
    report.generalized_dofs.resize(waves_.size());
    report.dropped.resize(waves_.size());
    for_each_nodal_diameter([&](int n) {
      CraigBamptonBasis basis = merge_speeds(waves_[n], shapes_[n], stiffness_.at(0.0), mass_);
      shapes_[n].clear();
      report.generalized_dofs[n] = static_cast<int>(basis.shapes.cols()) - dofs_.boundary();
      report.dropped[n] = basis.dropped;
      model.nodal_diameters[n] = project_all(waves_[n], basis.shapes);
      bases_[n] = std::move(basis.shapes);
    });
  }

  template <class Body>
  void for_each_nodal_diameter(const Body& body) {
    parallel_for(static_cast<int>(waves_.size()), parameters_.threads, [&](int n) {
      body(n);
      progress_.advance();
    });
  }

  /// K at a fraction of Omega_max; the three of eq. 7 are kept.
  SymmetricMatrix stiffness_at(double fraction) {
    if (const auto known = stiffness_.find(fraction); known != stiffness_.end()) return known->second;
    const double speed = fraction * parameters_.speed_max;
    SymmetricMatrix matrix = elasticity_.stiffness(speed, static_displacement(fraction), parameters_.prestress,
                                                   parameters_.spin_softening);
    if (fraction == 0.0 || fraction == 0.5 || fraction == 1.0) stiffness_[fraction] = matrix;
    return matrix;
  }

  template <class Body>
  void at_speed(double fraction, const Body& body) {
    try {
      body(stiffness_at(fraction));
    } catch (const RunError& error) {
      throw RunError("at " + std::to_string(std::lround(rpm(fraction * parameters_.speed_max))) +
                     " rpm: " + error.what());
    }
  }

  /// From scratch: the static solution, fixed-interface modes, constraint modes, and the modes that verify at rest.
  void solve_rest(const SymmetricMatrix& stiffness) {
    const SectorFactor factor(stiffness, dofs_);
    at_rest_.resize(waves_.size());
    for_each_nodal_diameter([&](int n) {
      const CyclicStiffness cyclic(factor, waves_[n]);
      if (n == 0) solve_static(cyclic);
      at_rest_[n] = lowest_modes(cyclic, mass_, ContactNodes::free, parameters_.verification_modes, mode_tolerance)
                        .frequencies();
      const CyclicModes fixed =
          lowest_modes(cyclic, mass_, ContactNodes::fixed, parameters_.fixed_interface_modes, mode_tolerance);
      shapes_[n].push_back({cyclic.constraint_modes(), fixed.shape});
    });
  }

  /// Linear static solution under spin: K(0) u = Omega^2 f, the same in every sector.
  void solve_static(const CyclicStiffness& at_rest) {
    const Eigen::VectorXd load = elasticity_.centrifugal_load();
    const Eigen::MatrixXcd wave =
        at_rest.solve(waves_[0].gather(load.cast<std::complex<double>>()), ContactNodes::free);
    static_over_square_ = waves_[0].expand(wave).real();
  }

  /// The basis needs the span of the fixed-interface modes at Omega_max, not the modes: one inverse iteration of
  /// those at rest gives it. The factor stays: it is the preconditioner for the modes of all other speeds.
  void solve_full_speed(const SymmetricMatrix& stiffness) {
    factor_.emplace(stiffness, dofs_);
    cyclic_.resize(waves_.size());
    for_each_nodal_diameter([&](int n) {
      cyclic_[n].emplace(*factor_, waves_[n]);
      const Eigen::MatrixXcd load = waves_[n].apply(mass_, shapes_[n].front().fixed_interface_modes);
      shapes_[n].push_back({cyclic_[n]->constraint_modes(), cyclic_[n]->solve(load, ContactNodes::fixed)});
    });
  }

  /// Nonlinear prestress: the shapes under spin at all speeds.
  void find_equilibria(ReductionReport& report) {
    std::optional<SectorFactor> factor;
    std::optional<CyclicStiffness> at_rest;
    at_speed(0.0, [&](const SymmetricMatrix& K) {
      factor.emplace(K, dofs_);
      at_rest.emplace(*factor, waves_[0]);
    });
    std::vector<double> speeds;
    for (const double fraction : parameters_.verification_speeds) speeds.push_back(fraction * parameters_.speed_max);
    for (const double fraction : {0.5, 1.0}) speeds.push_back(fraction * parameters_.speed_max);
    SpinShapes shapes = shapes_under_spin(elasticity_, mesh_, *at_rest, speeds, parameters_.prestress);
    equilibria_ = std::move(shapes.at);
    report.newton_steps = shapes.newton_steps;
    report.newton_residual = shapes.newton_residual;
  }

  Eigen::VectorXd static_solution(double fraction) const {
    const double speed = fraction * parameters_.speed_max;
    if (const auto known = equilibria_.find(speed); known != equilibria_.end()) return known->second;
    return speed * speed * static_over_square_;
  }

  Eigen::Matrix3Xd static_displacement(double fraction) const {
    if (fraction == 0.0) return Eigen::Matrix3Xd::Zero(3, mesh_.node_count());
    return cartesian_displacement(mesh_, dofs_, static_solution(fraction));
  }

  /// Omega^2 s_1 + Omega^4 s_2 through Omega_max/2 and Omega_max; s_2 is zero unless prestress is nonlinear.
  SpeedPolynomial static_shift() const {
    const bool linear = equilibria_.empty();
    const Eigen::VectorXcd full = static_solution(1.0).cast<std::complex<double>>();
    const Eigen::VectorXcd half =
        linear ? full / 4 : Eigen::VectorXcd(static_solution(0.5).cast<std::complex<double>>());
    SpeedPolynomial shift = SpeedPolynomial::through(0 * full, half, full, parameters_.speed_max);
    if (linear) shift.Y2.setZero();
    return shift;
  }

  void describe_static_shift(ContactLine& contact) const {
    const SpeedPolynomial shift = static_shift();
    for (Eigen::Index k = 0; k < contact.size(); ++k) {
      const int first = dofs_.first[contact_[k]];
      contact.static_shift_1.row(k) = shift.Y1.real().middleRows<3>(first).transpose();
      contact.static_shift_2.row(k) = shift.Y2.real().middleRows<3>(first).transpose();
    }
  }

  /// One after the other and shape by shape: the bases are the largest things here.
  void write_fields(FieldsWriter& fields) const {
    SectorFields sector = describe_sector(mesh_, contact_, parameters_.material);
    const SpeedPolynomial shift = static_shift();
    sector.static_displacement_1 = on_nodes(dofs_, shift.Y1).real().reshaped(3, mesh_.node_count());
    sector.static_displacement_2 = on_nodes(dofs_, shift.Y2).real().reshaped(3, mesh_.node_count());
    fields.write_sector(sector);
    for (std::size_t n = 0; n < waves_.size(); ++n)
      fields.write_basis(static_cast<int>(n), bases_[n].cols(), waves_[n].standing(),
                         [&](Eigen::Index k) { return on_nodes(dofs_, waves_[n].expand(bases_[n].col(k))); });
  }

  NodalDiameterModel project_all(const TravellingWave& wave, const Eigen::MatrixXcd& basis) const {
    const SpeedPolynomial K =
        SpeedPolynomial::through(project(wave, stiffness_.at(0.0), basis), project(wave, stiffness_.at(0.5), basis),
                                 project(wave, stiffness_.at(1.0), basis), parameters_.speed_max);
    return {K.Y0, K.Y1, K.Y2, project(wave, mass_, basis)};
  }

  /// Unreduced frequencies at every verification speed: at rest from scratch, elsewhere followed from the model's
  /// modes.
  void verify(ReducedModel& model) {
    Verification& table = model.verification;
    const int modes = parameters_.verification_modes;
    table.speeds = parameters_.speed_max * Eigen::Map<const Eigen::VectorXd>(parameters_.verification_speeds.data(),
                                                                             parameters_.verification_speeds.size());
    table.unreduced.assign(waves_.size(), Eigen::MatrixXd(table.speeds.size(), modes));
    table.reduced = table.unreduced;
    if (parameters_.prestress == Prestress::nonlinear)
      table.polynomial_misfit.setZero(table.speeds.size(), static_cast<Eigen::Index>(waves_.size()));
    for (std::size_t n = 0; n < waves_.size(); ++n)
      if (const Eigen::Index dofs = model.nodal_diameters[n].M.rows(); dofs < modes)
        throw InputError("[reduce] verification_modes = " + std::to_string(modes) + " is more than the " +
                         std::to_string(dofs) + " dofs of the model at nodal diameter " + std::to_string(n) +
                         "; ask for fewer, or raise fixed_interface_modes");
    for (Eigen::Index row = 0; row < table.speeds.size(); ++row)
      at_speed(parameters_.verification_speeds[row], [&](const SymmetricMatrix& stiffness) {
        for_each_nodal_diameter([&](int n) {
          const NodalDiameterModel& reduced = model.nodal_diameters[n];
          const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd> solver(
              reduced.stiffness(table.speeds[row]), reduced.M);
          table.reduced[n].row(row) =
              condense(reduced, table.speeds[row], dofs_.boundary(), parameters_.modes_at_speed)
                  .natural_frequencies()
                  .head(modes)
                  .transpose();
          if (parameters_.prestress == Prestress::nonlinear)
            table.polynomial_misfit(row, n) = polynomial_misfit(reduced, stiffness, n, table.speeds[row]);
          if (table.speeds[row] == 0.0) {
            table.unreduced[n].row(row) = at_rest_[n].transpose();
            return;
          }
          const Eigen::Index guessed = std::min<Eigen::Index>(guesses_per_mode * modes, reduced.M.rows());
          const Eigen::MatrixXcd guesses = bases_[n] * solver.eigenvectors().leftCols(guessed);
          table.unreduced[n].row(row) =
              follow_modes(*cyclic_[n], stiffness, mass_, guesses, modes, parameters_.verification_tolerance)
                  .frequencies()
                  .transpose();
        });
      });
  }

  /// Largest relative change of the verification frequencies by eq. 7 alone: the polynomial's K(Omega) against
  /// K(Omega) itself on the same basis.
  double polynomial_misfit(NodalDiameterModel model, const SymmetricMatrix& stiffness, int n, double speed) const {
    const Eigen::VectorXd by_polynomial = model.natural_frequencies(speed);
    model = {project(waves_[n], stiffness, bases_[n]), 0 * model.K1, 0 * model.K2, model.M};
    const Eigen::VectorXd exact = model.natural_frequencies(speed);
    return (by_polynomial.array() / exact.array() - 1).head(parameters_.verification_modes).abs().maxCoeff();
  }

  const SectorMesh& mesh_;
  const ReductionParameters& parameters_;
  Progress& progress_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::vector<int> contact_;
  SectorDofs dofs_;
  RotatingElasticity elasticity_;
  SymmetricMatrix mass_;
  std::vector<TravellingWave> waves_;
  Eigen::VectorXd static_over_square_;
  std::map<double, Eigen::VectorXd> equilibria_;        // [m] by speed, with nonlinear prestress
  std::map<double, SymmetricMatrix> stiffness_;         // by fraction of Omega_max
  std::vector<Eigen::VectorXd> at_rest_;                // unreduced frequencies [Hz], by nodal diameter
  std::optional<SectorFactor> factor_;                  // of K(Omega_max)
  std::vector<std::optional<CyclicStiffness>> cyclic_;  // of K(Omega_max), by nodal diameter
  std::vector<std::vector<SpeedShapes>> shapes_;        // by nodal diameter, then speed
  std::vector<Eigen::MatrixXcd> bases_;                 // by nodal diameter
};

}  // namespace

std::string name_of(Prestress prestress) {
  return prestress == Prestress::linear ? "linear" : prestress == Prestress::nonlinear ? "nonlinear" : "stress_only";
}

ReductionParameters ReductionParameters::read(CaseTable& table) {
  ReductionParameters p;
  p.material.young = table.number("young_modulus", std::nullopt, Range::positive(), "Pa");
  p.material.poisson = table.number("poisson_ratio", std::nullopt, Range::between(0.0, 0.49), "1");
  p.material.density = table.number("density", std::nullopt, Range::positive(), "kg/m^3");
  p.speed_max = table.number("speed_max_rpm", std::nullopt, Range::positive(), "rpm") * std::numbers::pi / 30;
  p.prestress = table.choice<Prestress>(
      "prestress", Prestress::linear,
      {{"linear", Prestress::linear}, {"stress_only", Prestress::stress_only}, {"nonlinear", Prestress::nonlinear}});
  p.spin_softening = table.flag("spin_softening", true) ? SpinSoftening::on : SpinSoftening::off;
  p.contact_nodes = table.integer("contact_nodes", 10, Range::between(1, 200), "");
  p.fixed_interface_modes = table.integer("fixed_interface_modes", 40, Range::between(1, 500), "a speed");
  p.modes_at_speed = table.integer("modes_at_speed", 60, Range::between(0, 5000), "generalized dofs; 0: all");
  p.verification_speeds =
      table.numbers("verification_speeds", {{0.0, 0.3, 0.5, 0.8, 1.0}}, Range::between(0.0, 2.0), "of speed_max_rpm");
  p.verification_modes = table.integer("verification_modes", 8, Range::between(1, 100), "a nodal diameter");
  if (!std::is_sorted(p.verification_speeds.begin(), p.verification_speeds.end()))
    table.reject("verification_speeds", "must increase");
  p.verification_tolerance = table.number("verification_tolerance", 1e-5, {0.0, 1.0, Range::LowEnd::excluded},
                                          "of omega^2, in the last step");
  p.cyclic_tolerance = table.number("cyclic_tolerance", 1e-6, Range::positive(), "of the largest radius");
  p.threads = table.integer("threads", 1, Range::between(1, 256), "for nodal diameters and the BLAS");
  return p;
}

ReducedModel reduce(const SectorMesh& mesh, const ReductionParameters& parameters, Progress::Shown shown,
                    ReductionReport& report, FieldsWriter* fields) {
  openblas_set_num_threads(parameters.threads);
  Progress progress("reducing", Reducer::steps(mesh, parameters), shown);
  return Reducer(mesh, parameters, progress).run(report, fields);
}

void check_sector(const SectorMesh& mesh, const ReductionParameters& parameters) {
  const SectorDofs dofs = number_dofs(mesh, choose_contact_nodes(mesh, parameters.contact_nodes));
  RotatingElasticity(mesh, dofs, parameters.material).volume();
}

double verification_error(const ReducedModel& model, int count) {
  double worst = 0;
  for (Eigen::Index speed = 0; speed < model.verification.speeds.size(); ++speed) {
    std::vector<std::pair<double, double>> wheel;  // unreduced frequency, its relative error
    for (std::size_t n = 0; n < model.nodal_diameters.size(); ++n) {
      const bool standing = n == 0 || 2 * static_cast<int>(n) == model.sector_count;
      for (Eigen::Index mode = 0; mode < model.verification.unreduced[n].cols(); ++mode) {
        const double exact = model.verification.unreduced[n](speed, mode);
        const double error = std::abs(model.verification.reduced[n](speed, mode) / exact - 1);
        wheel.insert(wheel.end(), standing ? 1 : 2, {exact, error});
      }
    }
    std::sort(wheel.begin(), wheel.end());
    wheel.resize(std::min<std::size_t>(wheel.size(), count));
    for (const auto& [frequency, error] : wheel) worst = std::max(worst, error);
  }
  return worst;
}

}  // namespace tiprub
