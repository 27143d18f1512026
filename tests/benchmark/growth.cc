// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/growth.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <utility>

#include "simulate/march/rotor_at_speed.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate::testing {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double overlap =
    1;  // [m] of the pressed wheel, before it gives way; a thousandth of it is what stiff springs leave
constexpr double smallest = 1e-13, largest = 1e-6;  // [m sqrt(kg)] watched from one to the other, on all springs
constexpr int most_steps = 400000;
constexpr int lobes = 1, sectors = 6;

using Matrix = Eigen::MatrixXcd;

double largest_eigenvalue(const Matrix& matrix) {
  return Eigen::ComplexEigenSolver<Matrix>(matrix, false).eigenvalues().cwiseAbs().maxCoeff();
}

Matrix stiffness(const WaveModes& wave, double kappa) {
  Matrix K = kappa * wave.normal_rows.adjoint() * wave.normal_rows;
  K.diagonal() += wave.omega.square().matrix().cast<std::complex<double>>();
  return K;
}

/// (q+, q) from (q, q-): (1/h^2 + D/2h) q+ = (2/h^2 - K) q - (1/h^2 - D/2h) q-.
Matrix central_step(const WaveModes& wave, double kappa, double h) {
  const Eigen::Index m = wave.omega.size();
  const Eigen::ArrayXd lag = wave.damping_ratio * wave.omega * h;
  Matrix step = Matrix::Zero(2 * m, 2 * m);
  step.topLeftCorner(m, m) =
      (1 + lag).inverse().matrix().asDiagonal() * (2 * Matrix::Identity(m, m) - h * h * stiffness(wave, kappa));
  step.topRightCorner(m, m).diagonal() = (-(1 - lag) / (1 + lag)).matrix().cast<std::complex<double>>();
  step.bottomLeftCorner(m, m).setIdentity();
  return step;
}

/// (q, v)+ from (q, v) of one mode: both rates taken at theta of the new instant, 1 - theta of the old one.
Matrix theta_step(double omega, double ratio, double theta, double h) {
  Eigen::Matrix2d rate;
  rate << 0, 1, -omega * omega, -2 * ratio * omega;
  const Eigen::Matrix2d unit = Eigen::Matrix2d::Identity();
  const Eigen::Matrix2d step = (unit - theta * h * rate).inverse() * (unit + (1 - theta) * h * rate);
  return step.cast<std::complex<double>>();
}

/// The largest step [s] that doesn't grow: 2/omega_max, springs included; of the theta method 2 z / ((1 - 2 theta) w)
/// of its highest mode.
double largest_step(const RotorAtSpeed& rotor, const GrowthSetup& setup) {
  if (setup.scheme == Scheme::moreau_jean && setup.theta < 0.5)
    return 2 * setup.damping_ratio / (1 - 2 * setup.theta) / rotor.omega_max;
  return 2 / penalised_omega_max(rotor, setup.springs * rotor.tip_stiffness);
}

/// Where the pressed wheel rests on its springs: (omega^2 + kappa Y^H Y) q = -kappa overlap Y^H 1; only n = 0.
std::vector<Eigen::VectorXcd> rest(const RotorAtSpeed& rotor, double kappa) {
  std::vector<Eigen::VectorXcd> rest;
  for (const WaveModes& wave : rotor.waves) {
    const Matrix& Y = wave.normal_rows;
    const Eigen::VectorXcd push = -kappa * overlap * (Y.adjoint() * Eigen::VectorXcd::Ones(Y.rows()));
    rest.push_back(wave.nodal_diameter == 0 ? Eigen::VectorXcd(stiffness(wave, kappa).partialPivLu().solve(push))
                                            : Eigen::VectorXcd::Zero(Y.cols()));
  }
  return rest;
}

double distance(const TimeMarch& march, const std::vector<Eigen::VectorXcd>& from) {
  double square = 0;
  for (std::size_t i = 0; i < from.size(); ++i)
    square += (march.coordinates(i).head(from[i].size()) - from[i]).squaredNorm();
  return std::sqrt(square);
}

/// Of ln(distance) over the last two thirds of some steps: least squares, because the distance swings with the modes.
double slope(TimeMarch& march, const std::vector<Eigen::VectorXcd>& from, int steps) {
  const int skipped = steps / 3, counted = steps - skipped;
  for (int i = 0; i < skipped; ++i) march.step();
  const double middle = 0.5 * (counted - 1);
  double sum = 0, weights = 0;
  for (int i = 0; i < counted; ++i) {
    march.step();
    sum += (i - middle) * std::log(distance(march, from));
    weights += (i - middle) * (i - middle);
  }
  return sum / weights;
}

double measured_rate(const ReducedModel& model, const RotorAtSpeed& like, const GrowthSetup& setup, double step,
                     double predicted) {
  constexpr int steps_per_revolution = 60;
  const double speed = 2 * pi / step / steps_per_revolution, kappa = setup.springs * like.tip_stiffness;
  RotorAtSpeed rotor = like;
  rotor.speed = speed;
  const bool pressed = setup.springs > 0;
  const Casing casing = lobed_casing(lobes, 0, pressed ? -overlap : overlap);
  TimeMarch march =
      march_of(rotor, casing, model.contact, casing.given_clearance(model.contact),
               {setup.scheme, ContactRule::complementarity, steps_per_revolution, 1, setup.theta, kappa});
  const std::vector<Eigen::VectorXcd> at = rest(rotor, pressed ? kappa : 0);
  const double size = predicted > 0 ? smallest : largest;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Eigen::VectorXcd disturbance = Eigen::VectorXcd::Constant(at[i].size(), size);
    march.set_state(i, at[i] + disturbance, disturbance);
  }
  const double steps = std::log(largest / smallest) / std::abs(predicted);
  return slope(march, at, static_cast<int>(std::min<double>(most_steps, steps)));
}

}  // namespace

double predicted_rate(const RotorAtSpeed& rotor, const GrowthSetup& setup, double step) {
  double largest = 0;
  for (const WaveModes& wave : rotor.waves) {
    if (setup.scheme == Scheme::trigonometric)
      largest = std::max(largest, std::exp(-(wave.damping_ratio * wave.omega).minCoeff() * step));
    else if (setup.scheme == Scheme::moreau_jean)
      for (Eigen::Index m = 0; m < wave.omega.size(); ++m)
        largest = std::max(largest,
                           largest_eigenvalue(theta_step(wave.omega[m], wave.damping_ratio[m], setup.theta, step)));
    else
      largest = std::max(largest, largest_eigenvalue(central_step(wave, setup.springs * rotor.tip_stiffness, step)));
  }
  return std::log(largest);
}

std::vector<GrowthPoint> growth_of(const std::string& name, const GrowthSetup& setup) {
  const ReducedModel model = synthetic_wheel({sectors, 3, 5});
  const RotorAtSpeed rotor = rotor_at_speed(model, 1, all_nodal_diameters(model), {setup.damping_ratio});
  std::vector<GrowthPoint> points;
  for (const double ratio : {0.5, 0.9, 0.98, 1.02, 1.05, 1.1, 1.25, 1.5, 2.0}) {
    const double step = ratio * largest_step(rotor, setup);
    const double predicted = predicted_rate(rotor, setup, step);
    points.push_back({name, ratio, predicted, measured_rate(model, rotor, setup, step, predicted)});
  }
  return points;
}

void print_growth() {
  const std::vector<std::pair<std::string, GrowthSetup>> schemes = {
      {"central differences", {Scheme::central_differences, 0.01}},
      {"penalty, 10 tip stiffnesses", {Scheme::penalty, 0.01, 0.5, 10}},
      {"penalty, 1000 tip stiffnesses", {Scheme::penalty, 0.01, 0.5, 1000}},
      {"Moreau-Jean, theta 0.4", {Scheme::moreau_jean, 0.01, 0.4}},
      {"Moreau-Jean, theta 0.48", {Scheme::moreau_jean, 0.01, 0.48}},
      {"Moreau-Jean, theta 0.5", {Scheme::moreau_jean, 0.01, 0.5}},
      {"trigonometric (default)", {Scheme::trigonometric, 0.01}},
  };
  std::printf("# scheme\tstep over its limit (none: h omega_max / 2)\tpredicted, e-folds a step\tmeasured\n");
  for (const auto& [name, setup] : schemes) {
    std::printf("%s\n", name.c_str());
    for (const GrowthPoint& at : growth_of(name, setup))
      std::printf("%s\t%g\t%.6g\t%.6g\n", at.scheme.c_str(), at.over_limit, at.predicted, at.measured);
    std::printf("\n\n");
  }
}

}  // namespace tiprub::simulate::testing
