// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/reduction.h"

#include <cblas.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

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

constexpr double mode_tolerance = 1e-4;  // of 1/omega^2, a residual; the error of a frequency goes with its square
constexpr std::array corrected_speeds = {0.25, 0.5, 0.75};  // of Omega_max
constexpr double nearer_rest =
    0.7;  // of Omega_max: below, K, which goes with Omega^2, is nearer to rest than to full speed

double rpm(double speed) {
  return speed * 30 / std::numbers::pi;
}

/// The work of one reduction. Two factors, of rest and of full speed, serve all nodal diameters; these go side by
/// side, and what belongs to one is released as soon as its model is made and verified.
class Reducer {
 public:
  Reducer(const SectorMesh& mesh, const ReductionParameters& parameters, Progress& progress, FieldsWriter* fields)
      : mesh_(mesh),
        parameters_(parameters),
        progress_(progress),
        fields_(fields),
        contact_(choose_contact_nodes(mesh, parameters.contact_nodes)),
        dofs_(number_dofs(mesh, contact_)),
        elasticity_(std::in_place, mesh, dofs_, parameters.material, parameters.threads),
        mass_(elasticity_->mass()),
        sampled_(sampled_fractions()) {
    for (int n = 0; n <= mesh.sector_count / 2; ++n) waves_.emplace_back(dofs_, mesh.sector_count, n);
  }

  static int steps(const SectorMesh& mesh) {
    constexpr int stages = 3;  // of a nodal diameter: modes at rest, the basis, its verification
    return stages * (mesh.sector_count / 2 + 1);
  }

  ReducedModel run(ReductionReport& report) {
    report.sector_dofs = dofs_.sector();
    report.clamped_face_nodes = dofs_.clamped_face_nodes;
    const MemoryNeed need = memory_need(mesh_, dofs_, 2, columns_at_once(), parameters_.threads);
    report.memory_needed = need.total();
    require_memory(need, available_memory());
    timed(report, "mesh and mass");
    stiffness_[0.0] = assemble_stiffness(0.0);
    const SectorFactor rest = factorize(0.0);
    timed(report, "factor at rest");
    solve_static(rest, report);
    for (const double fraction : sampled_)
      if (fraction > 0) stiffness_[fraction] = assemble_stiffness(fraction);
    elasticity_.reset();  // its quadrature data would only take room from here on
    timed(report, "shape and stiffness under spin");
    const SectorFactor full = factorize(1.0);
    timed(report, "factor at full speed");
    ReducedModel model = describe();
    write_sector_fields();
    build(rest, full, model, report);
    timed(report, "modes, bases, verification");
    fit(model, report);
    timed(report, "model");
    return model;
  }

 private:
  /// Complex vectors that one nodal diameter holds: its basis, and either the Lanczos vectors with their products or
  /// what it takes to follow all modes at all verification speeds (shapes, loads, directions, and those of some
  /// rounds).
  int columns_at_once() const {
    constexpr int krylov = 6, following = 8;
    const int modes = parameters_.fixed_interface_modes;
    const int followed = parameters_.verification_modes * static_cast<int>(parameters_.verification_speeds.size());
    return std::max(krylov * modes, 2 * (modes + dofs_.boundary()) + following * followed);
  }
  bool linear() const { return parameters_.prestress != Prestress::nonlinear; }

  /// Fractions of Omega_max that eq. 7 goes through if it takes so many speeds.
  static std::vector<double> polynomial_fractions(int speeds) {
    std::vector<double> fractions(speeds);
    for (int i = 0; i < speeds; ++i) fractions[i] = static_cast<double>(i) / (speeds - 1);
    return fractions;
  }
  /// The numbers of speeds that eq. 7 may take, the first of them first.
  std::vector<int> polynomial_choices() const {
    if (parameters_.polynomial_speeds > 0) return {parameters_.polynomial_speeds};
    return linear() ? std::vector{3} : std::vector{3, 5};
  }
  /// Fractions of Omega_max at which the model's matrices are made from the sector's: those of eq. 7, and where that
  /// isn't exact, all that are looked at.
  std::vector<double> sampled_fractions() const {
    std::set<double> all;
    for (const int speeds : polynomial_choices())
      for (const double fraction : polynomial_fractions(speeds)) all.insert(fraction);
    if (!linear()) {
      all.insert(corrected_speeds.begin(), corrected_speeds.end());
      all.insert(parameters_.verification_speeds.begin(), parameters_.verification_speeds.end());
    }
    return {all.begin(), all.end()};
  }
  double speed(double fraction) const { return fraction * parameters_.speed_max; }
  std::vector<double> speeds(std::vector<double> fractions) const {
    for (double& fraction : fractions) fraction = speed(fraction);
    return fractions;
  }

  /// Notes how long it took since the last note.
  void timed(ReductionReport& report, const char* what) {
    const auto now = std::chrono::steady_clock::now();
    report.seconds.emplace_back(what, std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }

  std::string place(double fraction) const {
    return "at " + std::to_string(std::lround(rpm(speed(fraction)))) + " rpm";
  }

  /// Says at which speed something went wrong.
  template <class Body>
  auto at_speed(double fraction, const Body& body) const {
    try {
      return body();
    } catch (const RunError& error) {
      throw RunError(place(fraction) + ": " + error.what());
    }
  }

  template <class Body>
  void for_each_nodal_diameter(const Body& body) {
    parallel_for(static_cast<int>(waves_.size()), parameters_.threads, body);
  }

  SymmetricMatrix assemble_stiffness(double fraction) const {
    return elasticity_->stiffness(speed(fraction), static_displacement(fraction), parameters_.prestress,
                                  parameters_.spin_softening);
  }

  /// The sector's K: a sample, or where eq. 7 is exact, what it makes of them.
  SymmetricMatrix stiffness_at(double fraction) const {
    if (const auto known = stiffness_.find(fraction); known != stiffness_.end()) return known->second;
    const Eigen::VectorXd weights = SpeedPolynomial(speeds(sampled_)).weights(speed(fraction));
    SymmetricMatrix sum = stiffness_.at(sampled_.front());
    Eigen::Map<Eigen::VectorXd> values(sum.valuePtr(), sum.nonZeros());
    values *= weights[0];
    for (std::size_t s = 1; s < sampled_.size(); ++s) {
      const SymmetricMatrix& other = stiffness_.at(sampled_[s]);
      values += weights[static_cast<Eigen::Index>(s)] *
                Eigen::Map<const Eigen::VectorXd>(other.valuePtr(), other.nonZeros());
    }
    return sum;
  }
  /// The same for the model's matrix, from those at the samples.
  Eigen::MatrixXcd reduced_stiffness(const std::vector<Eigen::MatrixXcd>& samples, double fraction) const {
    if (const auto known = std::find(sampled_.begin(), sampled_.end(), fraction); known != sampled_.end())
      return samples[known - sampled_.begin()];
    const Eigen::VectorXd weights = SpeedPolynomial(speeds(sampled_)).weights(speed(fraction));
    Eigen::MatrixXcd sum = weights[0] * samples[0];
    for (std::size_t s = 1; s < samples.size(); ++s) sum += weights[static_cast<Eigen::Index>(s)] * samples[s];
    return sum;
  }
  std::vector<Eigen::MatrixXcd> reduced_samples(const CraigBamptonBasis& basis) const {
    std::vector<Eigen::MatrixXcd> samples;
    for (std::size_t s = 0; s < sampled_.size(); ++s) samples.push_back(basis.stiffness(s));
    return samples;
  }

  SectorFactor factorize(double fraction) const {
    return at_speed(fraction, [&] { return SectorFactor(stiffness_.at(fraction), dofs_); });
  }

  /// The shape under spin, the same in every sector: K(0) u = Omega^2 f, or the nonlinear one at each sampled speed.
  void solve_static(const SectorFactor& factor, ReductionReport& report) {
    const CyclicStiffness at_rest = at_speed(0.0, [&] { return CyclicStiffness(factor, waves_[0]); });
    if (linear()) {
      const Eigen::VectorXd load = elasticity_->centrifugal_load();
      const Eigen::MatrixXcd wave =
          at_rest.solve(waves_[0].gather(load.cast<std::complex<double>>()), ContactNodes::free);
      static_over_square_ = waves_[0].expand(wave).real();
      return;
    }
    SpinShapes shapes = shapes_under_spin(*elasticity_, mesh_, at_rest, speeds(sampled_), parameters_.prestress);
    equilibria_ = std::move(shapes.at);
    report.newton_steps = shapes.newton_steps;
    report.newton_residual = shapes.newton_residual;
  }

  Eigen::VectorXd static_solution(double fraction) const {
    return linear() ? Eigen::VectorXd(std::pow(speed(fraction), 2) * static_over_square_)
                    : equilibria_.at(speed(fraction));
  }

  Eigen::Matrix3Xd static_displacement(double fraction) const {
    if (fraction == 0.0) return Eigen::Matrix3Xd::Zero(3, mesh_.node_count());
    return cartesian_displacement(mesh_, dofs_, static_solution(fraction));
  }

  /// s_1, s_2 of Omega^2 s_1 + Omega^4 s_2 through Omega_max/2 and Omega_max; s_2 is zero unless prestress is
  /// nonlinear.
  std::array<Eigen::VectorXcd, 2> static_shift() const {
    if (linear()) return {static_over_square_.cast<std::complex<double>>(), Eigen::VectorXcd::Zero(dofs_.sector())};
    const Eigen::VectorXcd half = static_solution(0.5).cast<std::complex<double>>();
    const Eigen::VectorXcd full = static_solution(1.0).cast<std::complex<double>>();
    const auto terms = SpeedPolynomial(speeds({0.0, 0.5, 1.0})).coefficients({0 * full, half, full});
    return {terms[1], terms[2]};
  }

  ReducedModel describe() const {
    ReducedModel model;
    model.sector_count = mesh_.sector_count;
    model.speed_max = parameters_.speed_max;
    model.modes_at_speed = parameters_.modes_at_speed;
    model.prestress = name_of(parameters_.prestress);
    if (parameters_.spin_softening == SpinSoftening::off) model.prestress += ", without spin softening";
    model.contact = describe_contact(mesh_, contact_);
    const auto [shift_1, shift_2] = static_shift();
    for (Eigen::Index k = 0; k < model.contact.size(); ++k) {
      const int first = dofs_.first[contact_[k]];
      model.contact.static_shift_1.row(k) = shift_1.real().segment<3>(first).transpose();
      model.contact.static_shift_2.row(k) = shift_2.real().segment<3>(first).transpose();
    }
    return model;
  }

  void write_sector_fields() const {
    if (fields_ == nullptr) return;
    SectorFields sector = describe_sector(mesh_, contact_, parameters_.material);
    const auto [shift_1, shift_2] = static_shift();
    sector.static_displacement_1 = on_nodes(dofs_, shift_1).real().reshaped(3, mesh_.node_count());
    sector.static_displacement_2 = on_nodes(dofs_, shift_2).real().reshaped(3, mesh_.node_count());
    fields_->write_sector(sector);
  }

  void write_basis(int n, const CraigBamptonBasis& basis) {
    if (fields_ == nullptr) return;
    const Eigen::MatrixXcd shapes = basis.shapes();
    const std::lock_guard lock(writing_);
    fields_->write_basis(n, shapes.cols(), waves_[n].standing(),
                         [&](Eigen::Index k) { return on_nodes(dofs_, waves_[n].expand(shapes.col(k))); });
  }

  /// Everything that a nodal diameter needs from the sector.
  void build(const SectorFactor& rest_factor, const SectorFactor& full_factor, ReducedModel& model,
             ReductionReport& report) {
    const std::size_t diameters = waves_.size();
    const auto rows = static_cast<Eigen::Index>(parameters_.verification_speeds.size());
    report.generalized_dofs.resize(diameters);
    report.dropped.resize(diameters);
    report.corrections.resize(diameters);
    model.verification.unreduced.assign(diameters, Eigen::MatrixXd(rows, parameters_.verification_modes));
    samples_.resize(diameters);
    model.nodal_diameters.resize(diameters);
    for_each_nodal_diameter([&](int n) {
      const CyclicStiffness rest = at_speed(0.0, [&] { return CyclicStiffness(rest_factor, waves_[n]); });
      const CyclicStiffness full = at_speed(1.0, [&] { return CyclicStiffness(full_factor, waves_[n]); });
      CraigBamptonBasis basis = start_basis(n, rest, full);
      require_enough_modes(n, basis.size());
      report.corrections[n] = correct(basis, rest, full);
      report.generalized_dofs[n] = static_cast<int>(basis.size() - basis.contact_dofs());
      report.dropped[n] = basis.dropped();
      samples_[n] = reduced_samples(basis);
      model.nodal_diameters[n].M = basis.mass();
      find_unreduced(basis, rest, full, model.verification.unreduced[n]);
      write_basis(n, basis);
    });
  }

  /// Modes and static shapes of both speeds. The basis needs the span of the fixed-interface modes at Omega_max, not
  /// the modes: one inverse iteration of those at rest gives it.
  CraigBamptonBasis start_basis(int n, const CyclicStiffness& rest, const CyclicStiffness& full) {
    const Eigen::MatrixXcd modes = at_speed(0.0, [&] {
      return lowest_modes(rest, mass_, ContactNodes::fixed, parameters_.fixed_interface_modes, mode_tolerance).shape;
    });
    progress_.advance();
    std::vector<const SymmetricMatrix*> samples;
    for (const double fraction : sampled_) samples.push_back(&stiffness_.at(fraction));
    const Eigen::MatrixXcd constraint_modes = rest.constraint_modes();
    CraigBamptonBasis basis(waves_[n], mass_, samples, constraint_modes);
    basis.append(modes);
    basis.append(full.solve(waves_[n].apply(mass_, modes), ContactNodes::fixed));
    basis.append(full.constraint_modes() - constraint_modes);
    basis.orthonormalise();
    return basis;
  }

  ModeFollowing modes_between(const CraigBamptonBasis& basis, const CyclicStiffness& rest,
                              const CyclicStiffness& full, const std::vector<double>& fractions) const {
    const std::vector<Eigen::MatrixXcd> samples = reduced_samples(basis);
    std::vector<SpeedToFollow> speeds;
    for (const double fraction : fractions)
      speeds.push_back({place(fraction), [this, fraction] { return stiffness_at(fraction); },
                        reduced_stiffness(samples, fraction), fraction < nearer_rest ? &rest : &full});
    return {basis, mass_, std::move(speeds), parameters_.verification_modes};
  }

  /// Modes at speeds between those of the basis: where the basis misses one by more than the tolerance, it gets what
  /// it misses. Returns how many shapes that are.
  int correct(CraigBamptonBasis& basis, const CyclicStiffness& rest, const CyclicStiffness& full) {
    Eigen::Index corrections = 0;
    ModeFollowing modes = modes_between(basis, rest, full, {corrected_speeds.begin(), corrected_speeds.end()});
    for (const Eigen::MatrixXcd& block : modes.missing(2 * parameters_.frequency_tolerance)) {
      basis.append(block);
      corrections += block.cols();
    }
    basis.orthonormalise();
    progress_.advance();
    return static_cast<int>(corrections);
  }

  void find_unreduced(const CraigBamptonBasis& basis, const CyclicStiffness& rest, const CyclicStiffness& full,
                      Eigen::MatrixXd& table) {
    const std::vector<double>& fractions = parameters_.verification_speeds;
    const auto middle = std::find_if(fractions.begin(), fractions.end(), [](double f) { return f >= nearer_rest; });
    Eigen::Index row = 0;
    for (const std::vector<double>& half :
         {std::vector(fractions.begin(), middle), std::vector(middle, fractions.end())}) {
      ModeFollowing modes = modes_between(basis, rest, full, half);  // one factor at a time: half of the room
      modes.converge(parameters_.verification_tolerance);
      for (const FollowedModes& at : modes.modes()) table.row(row++) = at.frequencies().transpose();
    }
    progress_.advance();
  }

  void require_enough_modes(int n, Eigen::Index dofs) const {
    if (dofs >= parameters_.verification_modes) return;
    throw InputError("[reduce] verification_modes = " + std::to_string(parameters_.verification_modes) +
                     " is more than the " + std::to_string(dofs) + " dofs of the model at nodal diameter " +
                     std::to_string(n) + "; ask for fewer, or raise fixed_interface_modes");
  }

  /// Eq. 7 through as few speeds as do, and the model's own frequencies beside the unreduced ones.
  void fit(ReducedModel& model, ReductionReport& report) {
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (const int choice : polynomial_choices()) {
      fit_through(choice, model);
      const double misfit = linear() ? 0.0 : polynomial_misfit(model);
      if (misfit < least) best = choice;
      least = std::min(least, misfit);
      if (least < parameters_.polynomial_tolerance) break;
    }
    report.polynomial_speeds = best;
    fit_through(best, model);
    if (!linear()) polynomial_misfit(model);
    Verification& table = model.verification;
    table.speeds = parameters_.speed_max * Eigen::Map<const Eigen::VectorXd>(parameters_.verification_speeds.data(),
                                                                             parameters_.verification_speeds.size());
    table.reduced = table.unreduced;
    for_each_nodal_diameter([&](int n) {
      for (Eigen::Index row = 0; row < table.speeds.size(); ++row)
        table.reduced[n].row(row) =
            condense(model.nodal_diameters[n], table.speeds[row], dofs_.boundary(), parameters_.modes_at_speed)
                .natural_frequencies()
                .head(parameters_.verification_modes)
                .transpose();
    });
  }

  void fit_through(int count, ReducedModel& model) {
    const std::vector<double> fractions = polynomial_fractions(count);
    const SpeedPolynomial polynomial(speeds(fractions));
    for (std::size_t n = 0; n < waves_.size(); ++n) {
      std::vector<Eigen::MatrixXcd> samples;
      for (const double fraction : fractions) samples.push_back(reduced_stiffness(samples_[n], fraction));
      std::vector<Eigen::MatrixXcd> terms = polynomial.coefficients(samples);
      NodalDiameterModel& to = model.nodal_diameters[n];
      to.K0 = std::move(terms[0]);
      to.K1 = std::move(terms[1]);
      to.K2 = std::move(terms[2]);
      to.higher.assign(std::make_move_iterator(terms.begin() + 3), std::make_move_iterator(terms.end()));
    }
  }

  /// Fills the table of what eq. 7 alone makes wrong in the verification frequencies: the polynomial's K(Omega)
  /// against K(Omega) itself on the same basis. Returns the largest.
  double polynomial_misfit(ReducedModel& model) {
    Eigen::MatrixXd& misfit = model.verification.polynomial_misfit;
    const auto rows = static_cast<Eigen::Index>(parameters_.verification_speeds.size());
    misfit.setZero(rows, static_cast<Eigen::Index>(waves_.size()));
    for_each_nodal_diameter([&](int n) {
      const NodalDiameterModel& fitted = model.nodal_diameters[n];
      for (Eigen::Index row = 0; row < rows; ++row) {
        const double fraction = parameters_.verification_speeds[row];
        const Eigen::MatrixXcd K = reduced_stiffness(samples_[n], fraction);
        const Eigen::VectorXd exact = NodalDiameterModel{K, 0 * K, 0 * K, fitted.M}.natural_frequencies(0.0);
        const Eigen::VectorXd by_polynomial = fitted.natural_frequencies(speed(fraction));
        misfit(row, n) =
            (by_polynomial.array() / exact.array() - 1).head(parameters_.verification_modes).abs().maxCoeff();
      }
    });
    return misfit.maxCoeff();
  }

  const SectorMesh& mesh_;
  const ReductionParameters& parameters_;
  Progress& progress_;
  FieldsWriter* fields_;
  std::mutex writing_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::vector<int> contact_;
  SectorDofs dofs_;
  std::optional<RotatingElasticity> elasticity_;  // until all stiffnesses are assembled
  SymmetricMatrix mass_;
  std::vector<double> sampled_;  // fractions of Omega_max, ascending from zero
  std::vector<TravellingWave> waves_;
  Eigen::VectorXd static_over_square_;                  // [m s^2] sector dofs, unless prestress is nonlinear
  std::map<double, Eigen::VectorXd> equilibria_;        // [m] by speed, with nonlinear prestress
  std::map<double, SymmetricMatrix> stiffness_;         // by sampled fraction
  std::vector<std::vector<Eigen::MatrixXcd>> samples_;  // the model's K by nodal diameter and sampled fraction
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
  p.verification_speeds = table.numbers("verification_speeds", {{0.0, 0.15, 0.35, 0.6, 0.85, 0.95}},
                                        Range::between(0.0, 2.0), "of speed_max_rpm");
  p.frequency_tolerance =
      table.number("frequency_tolerance", 5e-4, {0.0, 1.0, Range::LowEnd::excluded},
                   "of a frequency, at speeds between those of the basis; what it misses joins it");
  p.polynomial_speeds =
      table.integer("polynomial_speeds", 0, Range::between(0, 9), "of eq. 7; 0: as many as it takes");
  p.polynomial_tolerance = table.number("polynomial_tolerance", 1e-3, {0.0, 1.0, Range::LowEnd::excluded},
                                        "of a frequency, by eq. 7 alone");
  p.verification_modes = table.integer("verification_modes", 6, Range::between(1, 100), "a nodal diameter");
  if (p.polynomial_speeds == 1 || p.polynomial_speeds == 2)
    table.reject("polynomial_speeds", "must be 0 (as many as it takes) or at least 3");
  if (!std::is_sorted(p.verification_speeds.begin(), p.verification_speeds.end()))
    table.reject("verification_speeds", "must increase");
  p.verification_tolerance =
      table.number("verification_tolerance", 2e-5, {0.0, 1.0, Range::LowEnd::excluded}, "of omega^2, estimated");
  p.cyclic_tolerance = table.number("cyclic_tolerance", 1e-6, Range::positive(), "of the largest radius");
  p.threads = table.integer("threads", 1, Range::between(1, 256), "for nodal diameters and the BLAS");
  return p;
}

ReducedModel reduce(const SectorMesh& mesh, const ReductionParameters& parameters, Progress::Shown shown,
                    ReductionReport& report, FieldsWriter* fields) {
  openblas_set_num_threads(parameters.threads);
  Progress progress("reducing", Reducer::steps(mesh), shown);
  return Reducer(mesh, parameters, progress, fields).run(report);
}

void check_sector(const SectorMesh& mesh, const ReductionParameters& parameters) {
  const SectorDofs dofs = number_dofs(mesh, choose_contact_nodes(mesh, parameters.contact_nodes));
  RotatingElasticity(mesh, dofs, parameters.material).volume();
}

int verified_frequencies(const ReducedModel& model) {
  int fewest = std::numeric_limits<int>::max();
  for (Eigen::Index speed = 0; speed < model.verification.speeds.size(); ++speed) {
    double end = std::numeric_limits<double>::infinity();
    for (const Eigen::MatrixXd& table : model.verification.unreduced)
      end = std::min(end, table.row(speed).maxCoeff());
    int count = 0;
    for (std::size_t n = 0; n < model.verification.unreduced.size(); ++n) {
      const int waves = n == 0 || 2 * static_cast<int>(n) == model.sector_count ? 1 : 2;
      count += waves * static_cast<int>((model.verification.unreduced[n].row(speed).array() <= end).count());
    }
    fewest = std::min(fewest, count);
  }
  return model.verification.speeds.size() == 0 ? 0 : fewest;
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
