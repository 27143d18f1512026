// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/matrices/matrix_files.h"

#include <gtest/gtest.h>

#include <fstream>

#include "cases/program/errors.h"

namespace tiprub::reduce {
namespace {

/// Symptom: Excel's "CSV UTF-8" begins with a byte order mark, and the column "node" or "x" behind it was not found.
TEST(MatrixFiles, ReadATableWithAByteOrderMark) {
  const auto path = std::filesystem::path(testing::TempDir()) / "nodes_with_a_mark.csv";
  std::ofstream(path) << "\xEF\xBB\xBFx,y,z,set\r\n0.1,0,0,clamped\r\n0.2,0,0,contact\r\n";
  const NodeTable table = read_node_table(path);
  std::filesystem::remove(path);
  ASSERT_EQ(table.position.cols(), 2);
  EXPECT_EQ(table.position(0, 1), 0.2);
  EXPECT_EQ(table.place[1], NodePlace::contact);
}

/// Symptom: a stiffness at speed that was cut off passed as a whole one, and the rotor was called unstable.
TEST(MatrixFiles, RefuseAMatrixThatIsCutOff) {
  const auto path = std::filesystem::path(testing::TempDir()) / "cut_off.mtx";
  std::ofstream(path) << "%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 2.5\n2 1 1.0\n";
  try {
    read_symmetric_matrix(path);
    ADD_FAILURE() << "was read";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("has 2 entries, and its head lists 3; is the file cut off?"),
              std::string::npos)
        << error.what();
  }
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace tiprub::reduce
