// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/reduction.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "reduce/contact_line.h"
#include "reduce/craig_bampton.h"
#include "reduce/cyclic_modes.h"
#include "reduce/speed_polynomial.h"

namespace tiprub {

namespace {

constexpr double mode_tolerance = 1e-7;  // of 1/omega^2; the error of a frequency goes with its square
constexpr double polynomial_fractions[] = {0.0, 0.5, 1.0};

bool among(double fraction, std::initializer_list<double> fractions) {
  return std::find(fractions.begin(), fractions.end(), fraction) != fractions.end();
}

/// The work of one reduction, speed by speed; what later speeds need is kept.
class Reducer {
 public:
  Reducer(const SectorMesh& mesh, const ReductionParameters& parameters)
      : mesh_(mesh),
        parameters_(parameters),
        contact_(choose_contact_nodes(mesh, parameters.contact_nodes)),
        dofs_(number_dofs(mesh, contact_)),
        elasticity_(mesh, dofs_, parameters.material),
        mass_(elasticity_.mass()) {
    for (int n = 0; n <= mesh.sector_count / 2; ++n) waves_.emplace_back(dofs_, mesh.sector_count, n);
    shapes_.resize(waves_.size());
    for (const double fraction : parameters.verification_speeds) unreduced_[fraction].resize(waves_.size());
  }

  /// 0 and 1 first: the basis; then 1/2 for eq. 7; then what only verifies.
  std::vector<double> fractions() const {
    std::vector<double> list(std::begin(polynomial_fractions), std::end(polynomial_fractions));
    for (const double fraction : parameters_.verification_speeds)
      if (std::find(list.begin(), list.end(), fraction) == list.end()) list.push_back(fraction);
    return list;
  }
  std::size_t steps() const { return fractions().size() * waves_.size(); }

  void visit(double fraction, Progress& progress) {
    const double speed = fraction * parameters_.speed_max;
    SymmetricMatrix stiffness = elasticity_.stiffness(speed, static_displacement(speed), parameters_.prestress);
    const bool basis = among(fraction, {0.0, 1.0}), verifies = unreduced_.contains(fraction);
    if (basis || verifies) try {
        const SectorFactor factor(stiffness, dofs_);
        for (std::size_t n = 0; n < waves_.size(); ++n, progress.advance()) {
          const CyclicStiffness cyclic(factor, waves_[n]);
          if (fraction == 0.0 && n == 0) solve_static(cyclic);
          if (verifies) unreduced_[fraction][n] = frequencies(cyclic);
          if (basis) shapes_[n].push_back(shapes(cyclic));
        }
      } catch (const RunError& error) {
        throw RunError("at " + std::to_string(speed * 30 / std::numbers::pi) + " rpm: " + error.what());
      }
    if (among(fraction, {0.0, 0.5, 1.0})) stiffness_[fraction] = std::move(stiffness);
  }

  ReducedModel finish(ReductionReport& report) {
    ReducedModel model;
    model.sector_count = mesh_.sector_count;
    model.speed_max = parameters_.speed_max;
    model.prestress = name_of(parameters_.prestress);
    model.contact = describe_contact(mesh_, contact_);
    for (Eigen::Index k = 0; k < model.contact.size(); ++k)
      model.contact.static_shift_1.row(k) = static_over_square_.segment<3>(dofs_.first[contact_[k]]).transpose();
    report.sector_dofs = dofs_.sector();
    report.clamped_face_nodes = dofs_.clamped_face_nodes;
    for (std::size_t n = 0; n < waves_.size(); ++n) {
      const CraigBamptonBasis basis = merge_speeds(waves_[n], shapes_[n], stiffness_.at(0.0), mass_);
      report.generalized_dofs.push_back(static_cast<int>(basis.shapes.cols()) - dofs_.boundary());
      report.dropped.push_back(basis.dropped);
      shapes_[n].clear();
      model.nodal_diameters.push_back(project_all(waves_[n], basis.shapes));
    }
    verify(model);
    return model;
  }

 private:
  /// Linear static solution under spin: K(0) u = Omega^2 f, the same in every sector.
  void solve_static(const CyclicStiffness& at_rest) {
    const Eigen::VectorXd load = elasticity_.centrifugal_load();
    const Eigen::MatrixXcd wave =
        at_rest.solve(waves_[0].gather(load.cast<std::complex<double>>()), ContactNodes::free);
    static_over_square_ = waves_[0].expand(wave).real();
  }

  Eigen::Matrix3Xd static_displacement(double speed) const {
    if (speed == 0.0) return Eigen::Matrix3Xd::Zero(3, mesh_.node_count());
    return speed * speed * cartesian_displacement(mesh_, dofs_, static_over_square_);
  }

  Eigen::VectorXd frequencies(const CyclicStiffness& cyclic) const {
    return lowest_modes(cyclic, mass_, ContactNodes::free, parameters_.verification_modes, mode_tolerance)
        .frequencies();
  }

  SpeedShapes shapes(const CyclicStiffness& cyclic) const {
    return {
        cyclic.constraint_modes(),
        lowest_modes(cyclic, mass_, ContactNodes::fixed, parameters_.fixed_interface_modes, mode_tolerance).shape};
  }

  NodalDiameterModel project_all(const TravellingWave& wave, const Eigen::MatrixXcd& independent_basis) const {
    const Eigen::MatrixXcd M = project(wave, mass_, independent_basis);
    const SpeedPolynomial K = SpeedPolynomial::through(
        project(wave, stiffness_.at(0.0), independent_basis), project(wave, stiffness_.at(0.5), independent_basis),
        project(wave, stiffness_.at(1.0), independent_basis), parameters_.speed_max);
    return {K.Y0, K.Y1, K.Y2, M};
  }

  void verify(ReducedModel& model) const {
    Verification& table = model.verification;
    const Eigen::Index speeds = static_cast<Eigen::Index>(unreduced_.size());
    table.speeds.resize(speeds);
    for (std::size_t n = 0; n < waves_.size(); ++n) {
      table.unreduced.emplace_back(speeds, parameters_.verification_modes);
      table.reduced.emplace_back(speeds, parameters_.verification_modes);
      Eigen::Index row = 0;
      for (const auto& [fraction, frequencies_at] : unreduced_) {
        table.speeds[row] = fraction * parameters_.speed_max;
        table.unreduced[n].row(row) = frequencies_at[n].transpose();
        table.reduced[n].row(row) = model.nodal_diameters[n]
                                        .natural_frequencies(table.speeds[row])
                                        .head(parameters_.verification_modes)
                                        .transpose();
        ++row;
      }
    }
  }

  const SectorMesh& mesh_;
  const ReductionParameters& parameters_;
  std::vector<int> contact_;
  SectorDofs dofs_;
  RotatingElasticity elasticity_;
  SymmetricMatrix mass_;
  std::vector<TravellingWave> waves_;
  Eigen::VectorXd static_over_square_;
  std::map<double, SymmetricMatrix> stiffness_;               // by fraction of Omega_max
  std::map<double, std::vector<Eigen::VectorXd>> unreduced_;  // by fraction, then nodal diameter
  std::vector<std::vector<SpeedShapes>> shapes_;              // by nodal diameter, then speed
};

}  // namespace

std::string name_of(Prestress prestress) {
  return prestress == Prestress::linear ? "linear" : "stress_only";
}

ReductionParameters ReductionParameters::read(CaseTable& table) {
  ReductionParameters p;
  p.material.young = table.number("young_modulus", std::nullopt, Range::positive(), "Pa");
  p.material.poisson = table.number("poisson_ratio", std::nullopt, Range::between(0.0, 0.49), "1");
  p.material.density = table.number("density", std::nullopt, Range::positive(), "kg/m^3");
  p.speed_max = table.number("speed_max_rpm", std::nullopt, Range::positive(), "rpm") * std::numbers::pi / 30;
  p.prestress = table.choice<Prestress>("prestress", Prestress::linear,
                                        {{"linear", Prestress::linear}, {"stress_only", Prestress::stress_only}});
  p.contact_nodes = table.integer("contact_nodes", 10, Range::between(1, 200), "");
  p.fixed_interface_modes = table.integer("fixed_interface_modes", 24, Range::between(1, 500), "a speed");
  p.verification_speeds =
      table.numbers("verification_speeds", {{0.0, 0.3, 0.5, 0.8, 1.0}}, Range::between(0.0, 2.0), "of speed_max_rpm");
  p.verification_modes = table.integer("verification_modes", 10, Range::between(1, 100), "a nodal diameter");
  p.cyclic_tolerance = table.number("cyclic_tolerance", 1e-6, Range::positive(), "of the largest radius");
  p.threads = table.integer("threads", 1, Range::between(1, 256), "of the BLAS");
  return p;
}

ReducedModel reduce(const SectorMesh& mesh, const ReductionParameters& parameters, Progress::Shown shown,
                    ReductionReport& report) {
  Reducer reducer(mesh, parameters);
  Progress progress("reducing", reducer.steps(), shown);
  for (const double fraction : reducer.fractions()) reducer.visit(fraction, progress);
  return reducer.finish(report);
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
