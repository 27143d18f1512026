// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulate/synthetic_wheel.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace tiprub::simulate::testing {

namespace {

constexpr double node_mass = 1e-3;      // kg
constexpr double base_stiffness = 1e5;  // N/m

Eigen::MatrixXd random_matrix(std::mt19937& source, Eigen::Index size) {
  Eigen::MatrixXd matrix(size, size);
  for (double& value : matrix.reshaped()) value = 2.0 * source() / std::mt19937::max() - 1.0;
  return matrix;
}

ContactLine make_contact(int count) {
  ContactLine contact;
  contact.position.resize(count, 3);
  contact.normal.resize(count, 3);
  contact.arc_length.resize(count);
  contact.static_shift.terms = {Eigen::MatrixX3d::Zero(count, 3)};
  for (int k = 0; k < count; ++k) {
    const double tilt = 0.3 * k;
    contact.position.row(k) << 0.1 + 0.005 * k, 0.03 * k, 0.005 * k;
    contact.normal.row(k) << std::cos(tilt), 0.0, std::sin(tilt);
    contact.arc_length[k] = 0.01 * k;
    contact.static_shift[1].row(k) << 1e-11, 0.0, 2e-11;
  }
  return contact;
}

}  // namespace

ReducedModel synthetic_wheel(const WheelPlan& plan) {
  std::mt19937 source(7);
  ReducedModel model;
  model.sector_count = plan.sectors;
  model.speed_max = 3000;
  model.prestress = Prestress::given;
  model.contact = make_contact(plan.contact_nodes);
  const Eigen::Index size = 3 * plan.contact_nodes + plan.generalized;
  const Eigen::MatrixXd spread = random_matrix(source, size);
  const Eigen::MatrixXd tie = random_matrix(source, size);
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(size, size);
  const Eigen::MatrixXd own = base_stiffness * (unit + 2.0 * spread * spread.transpose());
  const Eigen::MatrixXd next = 0.05 * base_stiffness * tie;  // between a sector and the next one
  const Eigen::MatrixXd mass_spread = random_matrix(source, size);
  const Eigen::MatrixXd mass = node_mass * (unit + 0.1 * mass_spread * mass_spread.transpose());
  for (int n = 0; n <= model.nodal_diameter_max(); ++n) {
    const std::complex<double> phase = std::polar(1.0, 2 * std::numbers::pi * n / plan.sectors);
    NodalDiameterModel at;
    const Eigen::MatrixXcd wave = next.cast<std::complex<double>>() * phase;
    at.K.terms = {own.cast<std::complex<double>>() + wave + wave.adjoint(),
                  (1e-7 * own).cast<std::complex<double>>()};
    at.M = mass.cast<std::complex<double>>();
    if (is_standing(n, plan.sectors)) at.K[0] = at.K[0].real().cast<std::complex<double>>().eval();
    model.nodal_diameters.push_back(at);
  }
  check(model, "synthetic wheel");
  return model;
}

ReducedModel uncoupled_blades(int sectors, double mass, double stiffness) {
  ReducedModel model;
  model.sector_count = sectors;
  model.speed_max = 3000;
  model.prestress = Prestress::given;
  model.contact = make_contact(1);
  model.contact.static_shift[1].setZero();
  NodalDiameterModel at;
  at.M = Eigen::MatrixXcd::Identity(3, 3) * mass;
  at.K.terms = {Eigen::MatrixXcd::Identity(3, 3) * stiffness, Eigen::MatrixXcd::Zero(3, 3)};
  model.nodal_diameters.assign(model.nodal_diameter_max() + 1, at);
  return model;
}

ReducedModel one_mass(double mass, double stiffness) {
  return uncoupled_blades(1, mass, stiffness);
}

Casing lobed_casing(int lobes, double amplitude, double clearance) {
  Casing casing;
  casing.lobes = lobes;
  casing.amplitude = amplitude;
  casing.clearance = {{0.0, clearance}, {1.0, clearance}};
  return casing;
}

std::vector<int> all_nodal_diameters(const ReducedModel& model) {
  std::vector<int> all;
  for (int n = 0; n <= model.nodal_diameter_max(); ++n) all.push_back(n);
  return all;
}

TimeMarch march_of(const RotorAtSpeed& rotor, const Casing& casing, const ContactLine& tips,
                   const Eigen::VectorXd& clearance, const MarchSetup& setup) {
  return TimeMarch({std::make_shared<RotorAtSpeed>(rotor), tips, {casing, tips, clearance}, setup});
}

Bench make_bench(const ReducedModel& model, const Casing& casing, double speed, double damping_ratio,
                 const MarchSetup& setup) {
  std::vector<int> moving;
  for (int n : all_nodal_diameters(model))
    if (n % setup.symmetry == 0) moving.push_back(n);
  RotorAtSpeed rotor = rotor_at_speed(model, speed, moving, {damping_ratio});
  TimeMarch march = march_of(rotor, casing, model.contact, casing.running_clearance(model.contact, speed), setup);
  return {std::move(rotor), std::move(march)};
}

SimulateParameters settling_parameters() {
  SimulateParameters parameters;
  parameters.damping = {0.005};
  parameters.samples_per_revolution = 120;
  parameters.recorded_revolutions = 2;
  parameters.min_revolutions = 10;
  parameters.max_revolutions = 80;
  parameters.settle_tolerance = 1e-5;
  parameters.casing_areas = 1;
  parameters.steps_per_period = 400;
  return parameters;
}

ReducedModel curved_wheel() {
  ReducedModel model = synthetic_wheel({});
  std::mt19937 source(7);
  const auto random = [&] { return 2.0 * source() / std::mt19937::max() - 1.0; };
  SecondOrderGap& given = model.contact.second_order.emplace();
  given.curvature = Eigen::MatrixX2d::Constant(model.contact.size(), 2, 10);
  given.coordinates = Eigen::MatrixXd::NullaryExpr(model.contact_dofs(), 3, random);
  for (int k = 0; k < model.contact.size(); ++k) {
    const Eigen::Matrix3d any = Eigen::Matrix3d::NullaryExpr(random) * 1000;
    given.displacement.emplace_back(any + any.transpose());
  }
  return model;
}

double settled_amplitude(Bench bench) {
  TimeMarch& march = bench.march;
  Eigen::ArrayXd low = Eigen::ArrayXd::Constant(march.gap().size(), 1), high = -low;
  for (int i = 0; i < 22 * march.steps_per_revolution(); ++i) {
    march.step();
    if (i < 20 * march.steps_per_revolution()) continue;
    low = low.min(march.displacement().array());
    high = high.max(march.displacement().array());
  }
  return ((high - low) / 2).maxCoeff();
}

}  // namespace tiprub::simulate::testing
