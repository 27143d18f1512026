// SPDX-License-Identifier: GPL-3.0-or-later
// The same sector, whatever library factorizes and wherever its factor is.
#include <gtest/gtest.h>

#include <string>

#include "reduce/basis/cyclic_modes.h"
#include "reduce/reduction.h"
#include "tests/reduce/split_cells.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce::factor_methods_test {
namespace {

constexpr double tolerance = 1e-10;

SectorMesh sector_of(const std::string& cells) {
  test::Annulus annulus = test::skewed_annulus(5);
  annulus.nodes_per_brick = cells == "hex20" ? 20 : 27;
  return cells == "tet10" ? test::split(annulus.sector(), test::Split::tet10) : annulus.sector();
}

/// Relative to the largest entry.
double difference(const Eigen::MatrixXcd& one, const Eigen::MatrixXcd& other) {
  return (one - other).cwiseAbs().maxCoeff() / other.cwiseAbs().maxCoeff();
}

class FactorMethods : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(OfCells, FactorMethods, testing::Values("hex20", "hex27", "tet10"));

TEST_P(FactorMethods, GiveTheSameFrequenciesAndContactCompliances) {
  const SectorMesh mesh = sector_of(GetParam());
  test::TestRotor rotor(mesh, {mesh.contact_line.front(), mesh.contact_line.back()});
  const SymmetricMatrix stiffness = rotor.at_speed(3000.0, Prestress::linear), mass = rotor.mass();
  const auto factorize = [&](FactorMethod method) {
    return SectorFactor(stiffness, rotor.dofs(), {method, testing::TempDir()});
  };
  const SectorFactor by_cholmod = factorize(FactorMethod::cholmod), by_mumps = factorize(FactorMethod::mumps),
                     on_disk = factorize(FactorMethod::mumps_on_disk);
  for (int n = 0; n <= 2; ++n) {
    const CyclicTransformation transform(rotor.dofs(), mesh.sector_count, n);
    const auto frequencies = [&](const CyclicSolver& solver) {
      return lowest_modes(solver, mass, ContactNodes::free, 6, 1e-11).frequencies();
    };
    const Eigen::MatrixXcd loads = Eigen::MatrixXd(rotor.dofs().contact_loads)
                                       .bottomRows(rotor.dofs().independent())
                                       .cast<std::complex<double>>();
    const auto compliance = [&](const CyclicSolver& solver) {
      return Eigen::MatrixXcd(loads.adjoint() * solver.solve(loads, ContactNodes::free));
    };
    const CyclicSolver expected(by_cholmod, transform);
    for (const SectorFactor* factor : {&by_mumps, &on_disk}) {
      const CyclicSolver found(*factor, transform);
      EXPECT_LT((frequencies(found).array() / frequencies(expected).array() - 1).abs().maxCoeff(), tolerance);
      EXPECT_LT(difference(compliance(found), compliance(expected)), tolerance);
      EXPECT_LT(difference(found.constraint_modes(), expected.constraint_modes()), tolerance);
    }
  }
}

TEST(FactorMethodsTogether, GiveTheSameModelOnThreads) {
  ReductionParameters p;
  p.material = test::steel();
  p.speed_max = 3000.0;
  p.contact_nodes = 2;
  p.fixed_interface_modes = 8;
  p.verification_speeds = {0.0, 1.0};
  p.verification_modes = 4;
  p.verification_tolerance = 1e-9;
  p.frequency_tolerance = 1e-3;
  p.threads = 2;
  ReductionReport report;
  const ReducedModel by_cholmod =
      reduce(sector_of("hex20"), p, Progress::Shown::never, report, nullptr, test::alone());
  EXPECT_EQ(report.factor_method, FactorMethod::cholmod);
  p.factorization = Factorization::mumps;
  const ReducedModel by_mumps = reduce(sector_of("hex20"), p, Progress::Shown::never, report, nullptr, test::alone());
  EXPECT_EQ(report.factor_method, FactorMethod::mumps);
  for (std::size_t n = 0; n < by_cholmod.nodal_diameters.size(); ++n)
    for (const double speed : {0.0, 3000.0})
      EXPECT_LT((by_mumps.nodal_diameters[n].natural_frequencies(speed).head(6).array() /
                     by_cholmod.nodal_diameters[n].natural_frequencies(speed).head(6).array() -
                 1)
                    .abs()
                    .maxCoeff(),
                tolerance);
}

}  // namespace
}  // namespace tiprub::reduce::factor_methods_test
