// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "reduce/model/dense_eigen.h"
#include "simulate/motion/attempt.h"
#include "simulate/orbits/energy_audit.h"
#include "simulate/scene/friction_limit.h"
#include "tests/simulate/march/rubbing_blade.h"
#include "tests/simulate/one_sector.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate {
namespace {

constexpr double pi = std::numbers::pi;
using testing::blade;
using testing::Mode;
using testing::radius;
using testing::rotor_of_modes;
using testing::rubbing;
/// One mode moves along one line only, and the casing prescribes how: friction changes the force, not the motion.
TEST(Friction, OfOneModeChangesTheForceAndNotTheMotion) {
  const double n = 3, t = -4, mu = 0.2;
  const RotorAtSpeed rotor = rotor_of_modes({{6000, n, t, 0}}, 1000, 0.01);
  const Casing casing = testing::lobed_casing(1, 2e-4, 1e-4);
  for (const Scheme scheme : {Scheme::trigonometric, Scheme::central_differences, Scheme::moreau_jean}) {
    TimeMarch slides = blade(rotor, casing, 1e-4, rubbing(scheme, 1200, mu));
    TimeMarch rests = blade(rotor, casing, 1e-4, rubbing(scheme, 1200, 0));
    int contacts = 0;
    for (int i = 0; i < 6 * 1200; ++i) {
      slides.step();
      rests.step();
      ASSERT_NEAR(slides.displacement()[0], rests.displacement()[0], 1e-12 * 2e-4) << i;
      const double force = rests.contact().multipliers()[0];
      ASSERT_NEAR(slides.contact().multipliers()[0], force / (1 + mu * t / n), 1e-7 * force + 1e-7) << i;
      contacts += force > 0 ? 1 : 0;
    }
    EXPECT_GT(contacts, 100);
  }
}

/// A blade of two modes that is held in contact keeps one degree of freedom. With f = n + mu t, its frequency is
/// omega^2 = (f1 n1 w2^2 + f2 n2 w1^2)/(f1 n1 + f2 n2); where this is negative, it diverges.
TEST(Friction, MovesTheFrequencyOfABladeInContact) {
  const double w1 = 3000, w2 = 5000, n1 = 1, n2 = 0.8, t1 = -6, t2 = 1;
  const RotorAtSpeed rotor = rotor_of_modes({{w1, n1, t1, 0}, {w2, n2, t2, 0}}, 1000);
  const Casing casing = testing::lobed_casing(1, 0, 0);
  const double diverges = (n1 * n1 / w1 / w1 + n2 * n2 / w2 / w2) / -(n1 * t1 / w1 / w1 + n2 * t2 / w2 / w2);
  for (const double mu : {0.0, 0.5 * diverges, 0.95 * diverges, 1.02 * diverges}) {
    const double f1 = n1 + mu * t1, f2 = n2 + mu * t2;
    const double square = (f1 * n1 * w2 * w2 + f2 * n2 * w1 * w1) / (f1 * n1 + f2 * n2);
    const double pushed = 10, aside = 1e-7;  // N, m: where it would rest without friction, and a motion in contact
    const Eigen::Vector2d start(-pushed * n1 / w1 / w1 + aside * n2, -pushed * n2 / w2 / w2 - aside * n1);
    TimeMarch march =
        blade(rotor, casing, n1 * start[0] + n2 * start[1], rubbing(Scheme::central_differences, 20000, mu));
    march.set_state(0, start, Eigen::Vector2cd(0, 0));
    const auto q1 = [&] { return march.coordinates(0).real[0]; };
    std::vector<double> seen;
    for (int i = 0; i < 3; ++i) {
      for (int s = 0; s < 400; ++s) march.step();
      ASSERT_FALSE(march.contact().closed().empty());
      seen.push_back(q1());
    }
    for (int s = 0; s < 400; ++s) march.step();
    seen.push_back(q1());
    // x(t + T) + x(t - T) = 2 cos(omega T) x(t) about a mean, which differences remove
    const double turned = (seen[3] - seen[2] + seen[1] - seen[0]) / (seen[2] - seen[1]) / 2;
    const double T = 400 * march.time_step();
    const double expected = square > 0 ? std::cos(std::sqrt(square) * T) : std::cosh(std::sqrt(-square) * T);
    EXPECT_NEAR(turned, expected, 2e-4) << "mu " << mu;
    EXPECT_EQ(square<0, mu> diverges);
  }
}

/// Painleve's rod: with its tip on the floor at an angle of tangent t, the contact problem loses its unique solution
/// at mu = (4 + t^2)/(3 t): 4/3 at 63.43 degrees, and 5/3 at 45 degrees.
TEST(Friction, OfPainlevesRodHasASolutionUpToFourThirds) {
  const double mass = 0.3, half_length = 0.05, inertia = mass * half_length * half_length / 3;
  for (const double tangent : {1.0, 2.0}) {
    const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = tangent * cosine;
    const double lever = half_length / std::sqrt(inertia), unit = 1 / std::sqrt(mass);
    const RotorAtSpeed rotor =
        rotor_of_modes({{1, unit, 0, 0}, {1, 0, unit, 0}, {1, lever * cosine, -lever * sine, 0}}, 1000);
    const double limit = (4 + tangent * tangent) / (3 * tangent);
    const auto step = [&](double mu) {
      blade(rotor, testing::lobed_casing(1, 0, 0), -1e-6, rubbing(Scheme::central_differences, 1200, mu)).step();
    };
    EXPECT_NO_THROW(step(limit * (1 - 1e-5)));
    EXPECT_THROW(step(limit * (1 + 1e-5)), NoMotion);
  }
}

/// A mass on a belt that swings across the belt's motion: the drag turns against its velocity and damps it by
/// mu N/(2 m w V) = 0.01 of critical.
TEST(Friction, DampsAMassAcrossTheMotionOfItsBelt) {
  const double mu = 0.1, force = 0.2, belt = 1.0, normal_omega = 20;
  const RotorAtSpeed rotor = rotor_of_modes({{normal_omega, 1, 0, 0}, {1, 0, 0, 1}}, belt / radius);
  for (const Scheme scheme : {Scheme::trigonometric, Scheme::central_differences, Scheme::moreau_jean}) {
    TimeMarch march = blade(rotor, testing::lobed_casing(1, 0, 0), -force / (normal_omega * normal_omega),
                            rubbing(scheme, 400, mu));
    march.set_state(0, Eigen::Vector2cd(-force / (normal_omega * normal_omega), 1e-3), Eigen::Vector2cd(0, 0));
    double largest_before = 0, largest = 0;
    const double period = 2 * pi / march.time_step();
    const int periods = 10;
    for (int i = 0; i < periods * period; ++i) {
      march.step();
      const double swing = std::abs(march.coordinates(0).real[1]);
      if (i < 0.5 * period) largest_before = std::max(largest_before, i > 0.25 * period ? swing : 0);
      if (i > (periods - 0.5) * period - 0.25 * period && i < (periods - 0.25) * period)
        largest = std::max(largest, swing);
    }
    const double ratio = std::log(largest_before / largest) / (2 * pi * (periods - 1));
    EXPECT_NEAR(ratio, mu * force / (2 * belt), 2e-4);
  }
}

/// Two modes of a tip on a spring k3 (Hoffmann et al. 2002, whose springs these are): with the stiffness k11 along
/// the casing, k22 towards it, k3 included, and k12 < 0 between the two, their frequencies coalesce at mu = ((k11 -
/// k22)^2 + 4 k12^2)/(-4 k12 k3) = 0.472. Beyond, the tip flutters at the rate Re sqrt(-w^2).
TEST(Friction, LetsTwoModesFlutterWhereTheirFrequenciesCoalesce) {
  const double k11 = 23.25e6, k22 = 18.75e6, k12 = -9e6 * std::sqrt(3.0) / 4, k3 = 11e6;  // N/m, of 1 kg
  const double limit = ((k11 - k22) * (k11 - k22) + 4 * k12 * k12) / (-4 * k12 * k3);
  EXPECT_NEAR(limit, 0.472, 5e-4);
  const Eigen::Matrix2d own = (Eigen::Matrix2d() << k11, k12, k12, k22 - k3).finished();  // theta, normal
  const RealEigenpairs modes = eigenpairs(Eigen::MatrixXd(own));
  std::vector<Mode> free;
  for (int m = 0; m < 2; ++m)
    free.push_back({std::sqrt(modes.values[m]), modes.vectors(1, m), modes.vectors(0, m), 0});
  const int steps = 2400, revolutions = 20;
  const double pressed = 10;  // N
  for (const double mu : {0.98 * limit, 1.02 * limit}) {
    const Eigen::Vector2d rest = -pressed * own.inverse() * Eigen::Vector2d(mu, 1);
    MarchSetup setup = rubbing(Scheme::penalty, steps, mu);
    setup.penalty_stiffness = k3;
    TimeMarch march =
        blade(rotor_of_modes(free, 1000), testing::lobed_casing(1, 0, 0), rest[1] - pressed / k3, setup);
    const Eigen::Vector2d at_rest = modes.vectors.transpose() * rest;
    march.set_state(0, (at_rest * (1 + 1e-7)).cast<std::complex<double>>(), Eigen::Vector2cd(0, 0));
    double early = 0, late = 0;  // largest distances from rest in revolutions 8 and 20
    for (int i = 0; i < revolutions * steps; ++i) {
      march.step();
      const double away = (march.coordinates(0).head(2).real() - at_rest).norm();
      if (i / steps == 7) early = std::max(early, away);
      if (i / steps == revolutions - 1) late = std::max(late, away);
    }
    const std::complex<double> split =
        std::sqrt(std::complex<double>((k11 - k22) * (k11 - k22) / 4 + k12 * (k12 + mu * k3)));
    const double rate = std::sqrt(-(k11 + k22) / 2 + split).real();
    EXPECT_EQ(rate > 1, mu > limit);
    const double growth = std::log(late / early);
    if (mu > limit)
      EXPECT_NEAR(growth, rate * 12 * 2 * pi / 1000, 0.05);
    else
      EXPECT_LT(growth, 1.5);  // two frequencies beat
  }
}

/// A wheel that is mirrored and turns the other way sees its drag reversed, and moves as its mirror image.
TEST(Friction, IsMirroredWithTheWheel) {
  const ReducedModel model = testing::synthetic_wheel({1, 3, 5});
  const Casing casing = testing::lobed_casing(1, 2e-4, 1.5e-4);
  const RotorAtSpeed rotor = rotor_at_speed(model, 900, {0}, {0.01});
  RotorAtSpeed mirrored = rotor;
  ContactLine tips = model.contact;
  for (int k = 0; k < tips.size(); ++k) mirrored.waves[0].sliding_rows.row(2 * k) *= -1;
  tips.position.col(0) *= -1;  // its tips go the other way
  const Eigen::VectorXd clearance = casing.running_clearance(model.contact, 900);
  TimeMarch one =
      testing::march_of(rotor, casing, model.contact, clearance, rubbing(Scheme::trigonometric, 1200, 0.2));
  TimeMarch other = testing::march_of(mirrored, casing, tips, clearance, rubbing(Scheme::trigonometric, 1200, 0.2));
  TimeMarch without = testing::march_of(rotor, casing, tips, clearance, rubbing(Scheme::trigonometric, 1200, 0));
  double difference = 0;
  for (int i = 0; i < 20 * 1200; ++i) {
    one.step();
    other.step();
    without.step();
    ASSERT_EQ(one.displacement(), other.displacement()) << i;
    difference = std::max(difference, (one.displacement() - without.displacement()).cwiseAbs().maxCoeff());
  }
  EXPECT_GT(difference, 1e-6);
}

/// Three high modes of one blade, damped by 2 %, that flutter in contact with a coefficient of 0.15: two frequencies
/// of (1 - f n^T/(n . f)) diag(omega^2) are complex, with a growth of 0.27. If they are the mesh's, friction leaves
/// them out, and the blade rests on the casing.
TEST(Friction, OfModesOfTheMeshIsLeftOut) {
  const std::vector<Mode> modes = {{6e3, 1, -4, 0}, {3e5, 1, -12, 0}, {3.1e5, 1, -10, 0}, {3.2e5, 1, 3, 0}};
  const double mu = 0.15, pushed = 10;
  for (const int sliding : {4, 1}) {
    RotorAtSpeed rotor = rotor_of_modes(modes, 1000, 0.02);
    rotor.waves[0].sliding_rows = rotor.waves[0].sliding_rows.leftCols(sliding).eval();
    Eigen::VectorXcd rest(4);
    for (int m = 0; m < 4; ++m)
      rest[m] = -pushed * (modes[m].normal + (m < sliding ? mu * modes[m].theta : 0)) / std::pow(modes[m].omega, 2);
    TimeMarch march =
        blade(rotor, testing::lobed_casing(1, 0, 0), rest.real().sum(), rubbing(Scheme::trigonometric, 12000, mu));
    march.set_state(0, rest * (1 + 1e-9), Eigen::VectorXcd::Zero(4));
    int open = 0;
    for (int i = 0; i < 12000; ++i) {
      march.step();
      open += march.contact().closed().empty() ? 1 : 0;
    }
    EXPECT_EQ(open > 0, sliding == 4) << sliding << " modes slide";
  }
}

TEST(Friction, ActsOnModesUpToTheResolvedFrequency) {
  const ReducedModel model = testing::synthetic_wheel({});
  const double limit = 3000;  // Hz
  const RotorAtSpeed rotor = rotor_at_speed(
      model, 900, {0, 2}, {0.01}, {.count = 10, .others = ModeChoice::Others::quasi_static, .sliding_below = limit});
  for (const WaveModes& wave : rotor.waves) {
    const Eigen::Index slide = wave.sliding_rows.cols();
    ASSERT_GT(slide, 0);
    ASSERT_LT(slide, 10);
    EXPECT_LE(wave.omega[slide - 1], 2 * pi * limit);
    EXPECT_GT(wave.omega[slide], 2 * pi * limit);
    EXPECT_EQ(wave.sliding_rows.row(2), wave.contact_rows.row(4).leftCols(slide));  // theta of the second node
    const Eigen::RowVector3d normal = model.contact.normal.row(1);
    const Eigen::RowVectorXcd along = -normal[2] * wave.contact_rows.row(3) + normal[0] * wave.contact_rows.row(5);
    EXPECT_LT((wave.sliding_rows.row(3) - along.leftCols(slide)).norm(), 1e-12 * along.norm());
  }
  EXPECT_EQ(rotor_at_speed(model, 900, {0}, {0.01}, {.count = 4}).waves[0].sliding_rows.cols(), 4);
}

/// Unsymmetric problems of the kind that friction makes, against all sets of closed nodes.
TEST(Friction, GivesForcesThatComplementTheGaps) {
  std::mt19937 source(5);
  const auto random = [&] { return 2.0 * source() / std::mt19937::max() - 1.0; };
  const Eigen::Index size = 6;
  for (int problem = 0; problem < 300; ++problem) {
    const Eigen::MatrixXd factor = Eigen::MatrixXd::NullaryExpr(size, size, random);
    const Eigen::MatrixXd normal = factor * factor.transpose() + 0.5 * Eigen::MatrixXd::Identity(size, size);
    const Eigen::MatrixXd sliding = Eigen::MatrixXd::NullaryExpr(size, 2 * size, random);
    const Eigen::VectorXd way = Eigen::VectorXd::NullaryExpr(2 * size, random);
    const Eigen::VectorXd friction = Eigen::VectorXd::LinSpaced(size, 0, 0.15);
    const auto compliance =
        std::make_shared<ContactCompliance>(ContactCompliance::Responses{normal, sliding, {}, friction});
    Eigen::MatrixXd W = normal;
    for (Eigen::Index i = 0; i < size; ++i)
      W.col(i) += friction[i] * sliding.middleCols<2>(2 * i) * way.segment<2>(2 * i).normalized();
    const Eigen::VectorXd free_gap = Eigen::VectorXd::NullaryExpr(size, random).array() - 0.3;
    if (free_gap.minCoeff() >= 0) continue;
    ContactImpulses contact(compliance, ContactRule::complementarity);
    Eigen::VectorXd gap = free_gap;
    compliance->slide(way);
    contact.solve(gap);
    EXPECT_GE(contact.multipliers().minCoeff(), 0);
    EXPECT_GE(gap.minCoeff(), -1e-11);
    EXPECT_LT((gap - free_gap - W * contact.multipliers()).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT(gap.cwiseProduct(contact.multipliers()).cwiseAbs().maxCoeff(), 1e-10);
  }
}

/// All schemes that carry friction, with their own steps, on a wheel whose motion friction changes by 2 %.
TEST(Friction, IsTheSameWithAllSchemes) {
  const ReducedModel model = testing::synthetic_wheel({});
  const auto amplitude = [&](Scheme scheme, int steps, double friction) {
    MarchSetup setup = rubbing(scheme, steps, friction);
    setup.symmetry = 2;
    return testing::settled_amplitude(
        testing::make_bench(model, testing::lobed_casing(2, 2e-4, 1.5e-4), 900, 0.05, setup));
  };
  const double reference = amplitude(Scheme::trigonometric, 9600, 0.3);
  EXPECT_GT(std::abs(amplitude(Scheme::trigonometric, 9600, 0) / reference - 1), 0.015);
  for (const Scheme scheme : {Scheme::central_differences, Scheme::moreau_jean})
    EXPECT_NEAR(amplitude(scheme, 9600, 0.3) / reference, 1, 0.005) << static_cast<int>(scheme);
  EXPECT_NEAR(amplitude(Scheme::trigonometric, 4800, 0.3) / reference, 1, 0.005);
}

/// The work of the normal forces and of the drag, counted at the nodes, against damping and energy, counted in modes.
TEST(Friction, KeepsTheEnergyLedgerClosed) {
  for (const Scheme scheme : {Scheme::trigonometric, Scheme::central_differences, Scheme::moreau_jean}) {
    MarchSetup setup = rubbing(scheme, 6000, 0.2);
    setup.symmetry = 2;
    testing::Bench bench =
        testing::make_bench(testing::synthetic_wheel({}), testing::lobed_casing(2, 2e-4, 1.5e-4), 900, 0.01, setup);
    for (int i = 0; i < 12000; ++i) bench.march.step();
    EnergyAudit audit(bench.march);
    std::size_t impacts = 0;
    for (int i = 0; i < 30000; ++i) {
      bench.march.step();
      audit.observe(bench.march);
      impacts += bench.march.impacts().size();
    }
    const EnergyLedger ledger = audit.ledger(bench.march);
    EXPECT_LT(std::abs(ledger.closing_error), 1e-11);
    EXPECT_GT(std::abs(ledger.drag_work), 0.01 * std::abs(ledger.contact_work));
    EXPECT_EQ(impacts > 0, scheme == Scheme::trigonometric);
  }
}

/// On a belt that moves slower than the mass swings along it, sliding would reverse.
TEST(Friction, IsRefusedWhereSlidingReverses) {
  const RotorAtSpeed rotor = rotor_of_modes({{20, 1, 0, 0}, {1, 0, 1, 0}}, 1 / radius);
  TimeMarch march = blade(rotor, testing::lobed_casing(1, 0, 0), -1e-3, rubbing(Scheme::trigonometric, 400, 0.1));
  march.set_state(0, Eigen::Vector2cd(-1e-3, 1.1), Eigen::Vector2cd(0, 0));
  const auto swing = [&] {
    for (int i = 0; i < 2000; ++i) march.step();
  };
  EXPECT_THROW(swing(), NoMotion);
}

/// Where the compliance along the normal is C_NN and the drag's is C_NT < 0, a tip jams at mu = -C_NN/C_NT.
TEST(FrictionLimit, IsTheRatioOfStaticCompliances) {
  ReducedModel model = testing::one_sector();
  Eigen::Matrix3d K;
  K << 4e6, 1e6, 0, 1e6, 2e6, 0, 0, 0, 1e6;  // C_NN = 2/7, C_NT = -1/7 of 1e-6
  model.nodal_diameters.resize(1);
  model.nodal_diameters[0].K.terms = {K.cast<std::complex<double>>(), Eigen::MatrixXcd::Zero(3, 3)};
  model.nodal_diameters[0].M = Eigen::MatrixXcd::Identity(3, 3);
  EXPECT_NEAR(friction_limit(model).coefficient, 2.0, 1e-12);
  model.nodal_diameters[0].K[0](0, 1) = model.nodal_diameters[0].K[0](1, 0) = -1e6;
  EXPECT_EQ(friction_limit(model).coefficient, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace tiprub::simulate
