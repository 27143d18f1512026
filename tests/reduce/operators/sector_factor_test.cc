// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/sector_factor.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <utility>

#include "reduce/operators/scratch_files.h"
#include "tests/cases/complaint.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce {
namespace {

using test::dense;
using test::difference;
using test::TestRotor;

/// K in blocks of interior and interface dofs.
struct Blocks {
  Blocks(const SymmetricMatrix& stiffness, const SectorDofs& dofs) {
    const Eigen::MatrixXd K = dense(stiffness);
    II = K.topLeftCorner(dofs.interior, dofs.interior);
    FI = K.bottomLeftCorner(dofs.interface(), dofs.interior);
    FF = K.bottomRightCorner(dofs.interface(), dofs.interface());
  }
  Eigen::MatrixXd II, FI, FF;
};

/// By each library, in memory and on disk.
class SectorFactorBy : public testing::TestWithParam<FactorMethod> {
 protected:
  SectorFactor factorize(const SymmetricMatrix& stiffness, const SectorDofs& dofs) const {
    return {stiffness, dofs, {GetParam(), testing::TempDir()}};
  }
};

INSTANTIATE_TEST_SUITE_P(AllMethods, SectorFactorBy,
                         testing::Values(FactorMethod::cholmod, FactorMethod::mumps, FactorMethod::mumps_on_disk));

TEST_P(SectorFactorBy, LeavesTheSchurComplementOfTheInterface) {
  // S = K_FF - K_FI K_II^-1 K_IF, also where the shift in K_FF has to be taken out again, and also for an interface
  // of more dofs than one block of the rank updates.
  for (const std::array<int, 3>& bricks : {std::array{2, 2, 1}, std::array{5, 2, 3}}) {
    test::Annulus annulus = test::skewed_annulus(5);
    annulus.bricks = bricks;
    TestRotor rotor = test::tip_rotor(annulus);
    EXPECT_EQ(rotor.dofs().interface() > 256, bricks[0] == 5);
    for (const double speed : {0.0, 3000.0}) {
      const SymmetricMatrix stiffness = rotor.at_speed(speed, Prestress::linear);
      const Blocks K(stiffness, rotor.dofs());
      const Eigen::MatrixXd schur = K.FF - K.FI * test::solved(K.II, K.FI.transpose());
      EXPECT_LT(difference(factorize(stiffness, rotor.dofs()).schur_complement().values(), schur), 1e-11);
    }
  }
}

TEST_P(SectorFactorBy, IsExactlySymmetric) {
  TestRotor rotor = test::tip_rotor(test::skewed_annulus(5));
  const SectorFactor factor = factorize(rotor.at_rest(), rotor.dofs());
  const Eigen::MatrixXd schur = factor.schur_complement().values();
  EXPECT_EQ(schur, schur.transpose());
}

TEST_P(SectorFactorBy, EliminatesAndSubstitutesBack) {
  // The load that reaches the interface is -K_FI K_II^-1 b; the interior follows K_II x = b - K_IF x_F.
  TestRotor rotor = test::tip_rotor(test::skewed_annulus(5));
  const SymmetricMatrix stiffness = rotor.at_rest();
  const Blocks K(stiffness, rotor.dofs());
  const SectorFactor factor = factorize(stiffness, rotor.dofs());
  for (const int columns : {1, 3, 8, 16, 19, 27}) {  // one strip of right sides, wide or narrow, and more
    const Eigen::MatrixXd b = test::arbitrary(rotor.dofs().interior, columns).real();
    const Eigen::MatrixXd moved = test::arbitrary(rotor.dofs().interface(), columns).imag() * 1e-9;
    Eliminated eliminated = factor.engine().eliminate(b);
    EXPECT_LT(difference(eliminated.interface_load, -K.FI * test::solved(K.II, b)), 1e-11);
    const Eigen::MatrixXd x = factor.engine().back_substitute(std::move(eliminated), moved);
    EXPECT_LT(difference(x.bottomRows(rotor.dofs().interface()), moved), 1e-11);
    EXPECT_LT(difference(K.II * x.topRows(rotor.dofs().interior), b - K.FI.transpose() * moved), 1e-11);
  }
}

TEST(StoredMatrix, KeepsItsValuesInMemoryAndInAFile) {
  const Eigen::MatrixXd matrix = test::arbitrary(700, 300).real();
  const ScratchFolder folder(testing::TempDir());
  const std::filesystem::path file = folder.path() / "matrix";
  EXPECT_EQ(StoredMatrix(matrix).values(), matrix);
  StoredMatrix mapped(700, 300, file);
  EXPECT_TRUE(mapped.values().isZero(0.0));
  mapped.values() = matrix;
  EXPECT_EQ(StoredMatrix(std::move(mapped)).values(), matrix);
  Eigen::MatrixXd in_file(700, 300);
  std::ifstream(file, std::ios::binary).read(reinterpret_cast<char*>(in_file.data()), 8 * in_file.size());
  EXPECT_EQ(in_file, matrix);
}

TEST(StoredMatrix, TellsThatItsFileCannotBeMade) {
  const ScratchFolder folder(testing::TempDir());
  const std::filesystem::path file = folder.path() / "matrix";
  const StoredMatrix first(1, 1, file);
  EXPECT_EQ(complaint<RunError>([&] { StoredMatrix(1, 1, file); }),
            file.string() + ": can't be written: File exists");
  EXPECT_EQ(complaint<RunError>([&] { StoredMatrix(1, 1, "/dev/full/matrix"); }),
            "/dev/full/matrix: can't be written: Not a directory");
}

/// Symptom: CHOLMOD's CHOLMOD_TOO_LARGE was called a lack of memory, whatever the memory.
TEST(SectorFactor, TellsALackOfMemoryFromTooManyEntries) {
  constexpr int ok = 0, not_positive = 1, out_of_memory = -2, too_large = -3;  // in cholmod.h
  EXPECT_NO_THROW(require_factor(ok, 1000));
  EXPECT_NO_THROW(require_factor(not_positive, 1000));  // has a message of its own
  EXPECT_EQ(
      complaint<RunError>([] { require_factor(out_of_memory, 1000); }),
      "not enough memory to factorize a sector of 1000 dofs; coarsen the mesh, or take a machine with more memory");
  EXPECT_EQ(complaint<RunError>([] { require_factor(too_large, 1000); }),
            "a sector of 1000 dofs is too large for CHOLMOD and the BLAS, whatever the memory; coarsen the mesh");
}

TEST_P(SectorFactorBy, RefusesAnInteriorThatIsNotStable) {
  Material soft = test::steel();
  soft.young = 1e6;
  TestRotor rotor = test::tip_rotor(test::skewed_annulus(5), soft);
  const Eigen::Matrix3Xd still = Eigen::Matrix3Xd::Zero(3, rotor.mesh().node_count());
  const SymmetricMatrix stiffness = rotor.elasticity().stiffness(3000.0, still, Prestress::linear);
  const std::string message = complaint<RunError>([&] { factorize(stiffness, rotor.dofs()); });
  EXPECT_NE(message.find("not positive definite: the rotor is unstable, or a part of it is not held"),
            std::string::npos)
      << message;
}

TEST_P(SectorFactorBy, RefusesAPieceThatNothingHolds) {
  // A second block far from the sector, tied to nothing; under spin it flies off.
  SectorMesh mesh = test::Annulus().sector();
  const int nodes = mesh.node_count(), cells = mesh.cell_count();
  mesh.nodes.conservativeResize(Eigen::NoChange, 2 * nodes);
  mesh.nodes.rightCols(nodes) = mesh.nodes.leftCols(nodes).colwise() + Eigen::Vector3d(0, 0, 1);
  mesh.cells.conservativeResize(Eigen::NoChange, 2 * cells);
  mesh.cells.rightCols(cells) = mesh.cells.leftCols(cells).array() + nodes;
  TestRotor rotor(mesh, {mesh.contact_line.front()});
  const Eigen::Matrix3Xd still = Eigen::Matrix3Xd::Zero(3, 2 * nodes);
  const SymmetricMatrix stiffness = rotor.elasticity().stiffness(100.0, still, Prestress::linear);
  const std::string message = complaint<RunError>([&] { factorize(stiffness, rotor.dofs()); });
  EXPECT_NE(message.find("or a part of it is not held"), std::string::npos) << message;
}

}  // namespace
}  // namespace tiprub::reduce
