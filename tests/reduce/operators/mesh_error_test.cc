// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/mesh_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <numbers>
#include <optional>

#include "mesh/cells/cell_kind.h"
#include "reduce/basis/cyclic_modes.h"
#include "reduce/sector/cubic_bricks.h"
#include "reduce/sector/refinement.h"
#include "tests/reduce/split_cells.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce {
namespace {

/// A sector at rest, with all that an estimate takes.
class RestingSector {
 public:
  RestingSector(const SectorMesh& mesh, const ContactUnknowns& contact)
      : mesh_(mesh),
        contact_(contact),
        dofs_(number_dofs(mesh_, contact)),
        elasticity_(mesh_, dofs_, test::steel()),
        mass_(elasticity_.mass()),
        factor_(elasticity_.stiffness(0, Eigen::Matrix3Xd::Zero(3, mesh_.node_count()), Prestress::linear), dofs_),
        estimate_(mesh_, dofs_, test::steel(), 1) {}
  RestingSector(const RestingSector&) = delete;
  RestingSector& operator=(const RestingSector&) = delete;

  /// Frequencies [Hz] of a nodal diameter, and their estimated errors [1].
  struct Frequencies {
    Eigen::VectorXd found, error;
    Eigen::VectorXd of_cells;  ///< [1] see MeshErrorEstimate::Errors
  };
  Frequencies frequencies(int n, int count) const {
    const CyclicSolver at_rest = solver(n);
    const CyclicModes modes = lowest_modes(at_rest, mass_, ContactNodes::free, count, 1e-8);
    const auto [of_each, of_cells] = estimate_.of_frequencies(at_rest, modes.eigenvalue, modes.shape);
    return {modes.frequencies(), of_each, of_cells};
  }
  /// [m/N] along the normals, nodal diameter 0.
  Eigen::VectorXd compliances() const {
    const CyclicSolver at_rest = solver(0);
    Eigen::VectorXd found(contact_.line.size());
    for (Eigen::Index k = 0; k < found.size(); ++k) {
      const Eigen::VectorXd load = dofs_.contact_loads.middleCols(3 * k, 3) * contact_.line.normal.row(k).transpose();
      const Eigen::MatrixXcd independent = at_rest.transform().gather(load.cast<std::complex<double>>());
      found[k] = (independent.adjoint() * at_rest.solve(independent, ContactNodes::free)).real().sum();
    }
    return found;
  }
  MeshErrorEstimate::Errors compliance_errors() const { return estimate_.of_compliances(solver(0), contact_); }

 private:
  CyclicSolver solver(int n) const { return {factor_, {dofs_, mesh_.sector_count, n}}; }

  SectorMesh mesh_;
  ContactUnknowns contact_;
  SectorDofs dofs_;
  RotatingElasticity elasticity_;
  SymmetricMatrix mass_;
  SectorFactor factor_;
  MeshErrorEstimate estimate_;
};

void expect_effective(const Eigen::VectorXd& estimated, const Eigen::VectorXd& measured, const std::string& what) {
  const Eigen::VectorXd index = estimated.cwiseQuotient(measured);
  std::printf("%s: errors of %.2g to %.2g %%, effectivity index %.2f to %.2f\n", what.c_str(),
              100 * measured.minCoeff(), 100 * measured.maxCoeff(), index.minCoeff(), index.maxCoeff());
  EXPECT_GT(index.minCoeff(), 0.5) << what << ": " << index.transpose();
  EXPECT_LT(index.maxCoeff(), 2.0) << what << ": " << index.transpose();
}

/// Modes are paired in the order that they have without the estimated errors.
void expect_effective(const RestingSector::Frequencies& coarse, const Eigen::VectorXd& exact,
                      const std::string& what) {
  std::vector<std::pair<double, Eigen::Index>> order;
  for (Eigen::Index k = 0; k < coarse.found.size(); ++k)
    order.emplace_back(coarse.found[k] / (1 + coarse.error[k]), k);
  std::sort(order.begin(), order.end());
  Eigen::VectorXd estimated(exact.size()), measured(exact.size());
  for (Eigen::Index k = 0; k < exact.size(); ++k) {
    const Eigen::Index mode = order[static_cast<std::size_t>(k)].second;
    estimated[k] = coarse.error[mode];
    measured[k] = coarse.found[mode] / exact[k] - 1;
  }
  expect_effective(estimated, measured, what);
}

/// The first three modes of each nodal diameter, and the compliances of contact of these kinds.
void compare(const SectorMesh& mesh, const SectorMesh& finer, const std::vector<ContactKind>& kinds,
             const std::string& what) {
  constexpr int modes = 3, more = 2;  // which the mesh may have put behind the first
  for (const ContactKind kind : kinds) {
    const RestingSector coarse(mesh, choose_contact(mesh, kind, 2)), fine(finer, choose_contact(finer, kind, 2));
    for (int n = 0; n <= mesh.sector_count / 2 && kind == kinds.front(); ++n)
      expect_effective(coarse.frequencies(n, modes + more), fine.frequencies(n, modes).found,
                       what + ", nodal diameter " + std::to_string(n));
    expect_effective(coarse.compliance_errors().of_each,
                     1 - coarse.compliances().cwiseQuotient(fine.compliances()).array(),
                     what + (kind == ContactKind::points ? ", points" : ", segments"));
  }
}

class OfBricks : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(MeshError, OfBricks, testing::Values(20, 27));

TEST_P(OfBricks, IsThatAgainstFinerMeshes) {
  const std::vector<ContactKind> both = {ContactKind::segments, ContactKind::points};
  test::Annulus annulus;
  annulus.sector_count = 12;
  annulus.nodes_per_brick = GetParam();
  annulus.bricks = {4, 4, 1};
  const SectorMesh even = annulus.sector();
  compare(even, refined(even), both, "annulus, refined");
  annulus = test::skewed_annulus(5);
  annulus.nodes_per_brick = GetParam();
  annulus.bricks = {4, 4, 1};
  const SectorMesh skewed = annulus.sector();
  compare(skewed, refined(skewed), {ContactKind::segments}, "skewed annulus, refined");
  compare(skewed, with_cubic_bricks(skewed), both, "skewed annulus, cubic");
}

struct Cells {
  const char* name;
  std::optional<test::Split> split;  ///< of bricks of 27 nodes

  SectorMesh of(const SectorMesh& bricks) const { return split ? test::split(bricks, *split) : bricks; }
};

class OfEveryKind : public testing::TestWithParam<Cells> {};
INSTANTIATE_TEST_SUITE_P(MeshError, OfEveryKind,
                         testing::Values(Cells{"hex20", test::Split::hex20}, Cells{"hex27", {}},
                                         Cells{"tet10", test::Split::tet10}, Cells{"wedge15", test::Split::wedge15},
                                         Cells{"pyramid13", test::Split::pyramid13},
                                         Cells{"bricks_and_pyramids", test::Split::mixed},
                                         Cells{"bricks_and_wedges", test::Split::bricks_and_wedges}),
                         [](const auto& given) { return given.param.name; });

TEST_P(OfEveryKind, TorsionIsThatAgainstTheClosedForm) {
  // u_theta = J1(kr) Y1(ka) - Y1(kr) J1(ka) is held at a = 0.1 m; its shear stress vanishes at b = 0.2 m where k is a
  // root of J2(kb) Y1(ka) - Y2(kb) J1(ka).
  constexpr double wave_number = 9.8658264;
  const auto stress = [](double k) {
    return std::cyl_bessel_j(2, 0.2 * k) * std::cyl_neumann(1, 0.1 * k) -
           std::cyl_neumann(2, 0.2 * k) * std::cyl_bessel_j(1, 0.1 * k);
  };
  ASSERT_LT(stress(wave_number * (1 - 1e-6)) * stress(wave_number * (1 + 1e-6)), 0);
  const double exact =
      wave_number * std::sqrt(test::steel().young / 2.6 / test::steel().density) / (2 * std::numbers::pi);
  test::Annulus annulus;
  annulus.nodes_per_brick = 27;
  annulus.sector_count = 12;
  annulus.bricks = {4, 4, 1};
  const SectorMesh mesh = GetParam().of(annulus.sector());
  const auto [found, error, of_cells] =
      RestingSector(mesh, choose_contact(mesh, ContactKind::points, 1)).frequencies(0, 5);
  Eigen::Index torsion = 0;
  (found.array() / exact - 1).abs().minCoeff(&torsion);
  expect_effective(error.segment<1>(torsion), found.segment<1>(torsion).array() / exact - 1,
                   std::string(GetParam().name) + ", torsion of an annulus");
}

TEST_P(OfEveryKind, PlateIsThatAgainstTheRefinedMesh) {
  test::Annulus annulus = test::skewed_annulus(5);
  annulus.nodes_per_brick = 27;
  annulus.bricks = {2, 2, 1};
  const SectorMesh bricks = annulus.sector();
  // Pyramids can't be split; those of bricks that are split are a finer mesh.
  compare(GetParam().of(bricks), GetParam().of(refined(bricks)), {ContactKind::points},
          std::string(GetParam().name) + ", skewed annulus");
}

TEST_P(OfEveryKind, SectorIsThatOfTheWheel) {
  // The wheel as one mesh has no cut faces and no phases. With one brick around, patches meet both cuts.
  for (const int around : {1, 2}) {
    test::Annulus annulus = test::skewed_annulus(5);
    annulus.nodes_per_brick = 27;
    annulus.bricks = {2, around, 1};
    const SectorMesh wheel_mesh = GetParam().of(annulus.wheel()), mesh = GetParam().of(annulus.sector());
    const RestingSector wheel(wheel_mesh, {}), sector(mesh, {mesh.contact_line, {}});
    const auto [found, error, of_cells] = wheel.frequencies(0, 7);
    std::vector<std::pair<double, double>> joined;
    for (const int n : {0, 1, 1, 2, 2}) {
      const auto of_sector = sector.frequencies(n, 3);
      for (Eigen::Index k = 0; k < 3; ++k) joined.emplace_back(of_sector.found[k], of_sector.error[k]);
    }
    std::sort(joined.begin(), joined.end());
    for (Eigen::Index k = 0; k < found.size(); ++k) {
      EXPECT_NEAR(found[k] / joined[static_cast<std::size_t>(k)].first, 1.0, 1e-7);
      EXPECT_NEAR(error[k] / joined[static_cast<std::size_t>(k)].second, 1.0, 1e-3);
    }
  }
}

TEST_P(OfEveryKind, IsSharedOutToTheCells) {
  // Cells at the bore are large, where the first mode bends most, and those at the rim are small. The error of a
  // point's compliance is that of the cells around it, which are the smaller the more of them a brick is split into.
  test::Annulus annulus;
  annulus.nodes_per_brick = 27;
  annulus.bricks = {4, 2, 1};
  annulus.grading = -0.7;
  const SectorMesh mesh = GetParam().of(annulus.sector());
  const ContactUnknowns contact = choose_contact(mesh, ContactKind::points, 1);
  const RestingSector sector(mesh, contact);
  const auto found = sector.frequencies(0, 1);
  const MeshErrorEstimate::Errors compliances = sector.compliance_errors();
  for (const auto& [each, cells] :
       {std::pair(found.error, found.of_cells), {compliances.of_each, compliances.of_cells}}) {
    EXPECT_GE(cells.minCoeff(), 0.0);
    EXPECT_NEAR(cells.sum(), each.mean(), 1e-12 * each.mean());
  }
  double at_bore = 0, at_tip = 0;
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto nodes = nodes_of(mesh.cells, cell);
    const Eigen::Vector3d centre = mesh.nodes(Eigen::all, nodes).rowwise().mean();
    if (centre.head<2>().norm() < 0.5 * (annulus.inner + annulus.outer)) at_bore += found.of_cells[cell];
    if (std::find(nodes.begin(), nodes.end(), contact.nodes.front()) != nodes.end())
      at_tip += compliances.of_cells[cell];
  }
  EXPECT_GT(at_bore, 0.7 * found.of_cells.sum());
  EXPECT_GT(at_tip, 0.5 * compliances.of_cells.sum());
}

}  // namespace
}  // namespace tiprub::reduce
