// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "simulate/orbits/energy_audit.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate {
namespace {

/// A bar of length L flies lengthwise against a rigid wall (Doyen, Ern, Piperno 2011, sec. 4.1): it stays for 2L/c,
/// under the force E A v/c, and flies off as fast as it came.
constexpr double length = 0.5, area = 1e-4, young = 1e9, density = 1000;  // c = 1000 m/s
constexpr double wave_speed = 1000, impact_speed = 2.0, plateau = young * area * impact_speed / wave_speed;

/// Linear elements of lumped mass; one contact node, its theta and z on springs of their own.
ReducedModel bar(int elements) {
  const double element = length / elements, spring = young * area / element, node = density * area * element;
  const Eigen::Index size = 3 + elements;
  const auto dof = [](int i) { return static_cast<Eigen::Index>(i == 0 ? 0 : 2 + i); };
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size, size), M = node * Eigen::MatrixXd::Identity(size, size);
  K(1, 1) = K(2, 2) = spring;
  for (int e = 0; e < elements; ++e) {
    const Eigen::Index a = dof(e), b = dof(e + 1);
    K(a, a) += spring;
    K(b, b) += spring;
    K(a, b) -= spring;
    K(b, a) -= spring;
  }
  M(0, 0) = M(size - 1, size - 1) = node / 2;
  ReducedModel model = testing::one_mass(1, 1);
  NodalDiameterModel& at = model.nodal_diameters[0];
  at.K.terms = {K.cast<std::complex<double>>()};
  at.M = M.cast<std::complex<double>>();
  return model;
}

struct Impact {
  double duration = 0;  ///< [s] from the first to the last force
  double force = 0;     ///< [N] mean over the middle half of the contact
  double lost = 0;      ///< [1] share of the energy
};

Impact fly(Scheme scheme, int elements) {
  const ReducedModel model = bar(elements);
  const double speed = 10, step = 0.2 * length / elements / wave_speed, start = 1e-5;
  const int steps = static_cast<int>(std::ceil(2 * 3.141592653589793 / speed / step));
  testing::Bench bench = testing::make_bench(model, testing::lobed_casing(1, 0.0, start), speed, 0.0,
                                             {scheme, ContactRule::complementarity, steps, 1});
  TimeMarch& march = bench.march;
  const Eigen::MatrixXcd& shapes = bench.rotor.waves[0].shapes;
  Eigen::VectorXcd flight = Eigen::VectorXcd::Constant(shapes.rows(), impact_speed);
  flight[1] = flight[2] = 0;
  const Eigen::VectorXcd velocity = shapes.adjoint() * (model.nodal_diameters[0].M * flight);
  march.set_state(0, Eigen::VectorXcd::Zero(velocity.size()), velocity * march.time_step());
  march.step();
  const EnergyAudit audit(march);
  const double before = audit.energy(march);
  std::vector<double> forces;
  int first = -1, last = -1;
  for (int i = 0; i < 3 * length / wave_speed / march.time_step(); ++i) {
    march.step();
    forces.push_back(march.contact().multipliers()[0]);
    if (forces.back() == 0) continue;
    if (first < 0) first = i;
    last = i;
  }
  Impact impact;
  impact.duration = (last - first) * march.time_step();
  const int quarter = (last - first) / 4;
  for (int i = first + quarter; i < last - quarter; ++i) impact.force += forces[i] / (last - 2 * quarter - first);
  impact.lost = 1 - audit.energy(march) / before;
  return impact;
}

TEST(ElasticBar, StaysForTwoTransitsUnderItsPlateau) {
  for (Scheme scheme : {Scheme::trigonometric, Scheme::central_differences, Scheme::moreau_jean}) {
    const Impact impact = fly(scheme, 200);
    EXPECT_NEAR(impact.duration, 2 * length / wave_speed, 0.03 * 2 * length / wave_speed);
    EXPECT_NEAR(impact.force, plateau, 0.02 * plateau);
  }
}

/// What is lost is the kinetic energy of the mass at the wall: half as much for elements half as long.
TEST(ElasticBar, LosesEnergyInProportionToTheElements) {
  for (Scheme scheme : {Scheme::trigonometric, Scheme::central_differences}) {
    const double coarse = fly(scheme, 50).lost, middle = fly(scheme, 100).lost, fine = fly(scheme, 200).lost;
    EXPECT_GT(fine, 0);
    EXPECT_NEAR(coarse / middle, 2, 0.15);
    EXPECT_NEAR(middle / fine, 2, 0.15);
  }
}

}  // namespace
}  // namespace tiprub::simulate
