// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/exports.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

namespace tiprub::reduce {
namespace {

/// A reader of its own: what a file says of itself and the full matrix.
Eigen::MatrixXcd read_back(const std::filesystem::path& path, std::string& header) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, header);
  while (std::getline(file, line) && line[0] == '%') continue;
  Eigen::Index rows = 0, columns = 0;
  std::istringstream(line) >> rows >> columns;
  Eigen::MatrixXcd matrix(rows, columns);
  const bool real = header.find("real") != std::string::npos;
  for (Eigen::Index column = 0; column < columns; ++column)
    for (Eigen::Index row = column; row < rows; ++row) {
      double a = 0, b = 0;
      file >> a;
      if (!real) file >> b;
      matrix(row, column) = {a, b};
      matrix(column, row) = {a, -b};
    }
  EXPECT_TRUE(file) << path;
  EXPECT_FALSE(file >> line) << path;
  return matrix;
}

Eigen::MatrixXcd some_matrix(double phase) {
  Eigen::MatrixXcd A(4, 4);
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k) A(i, k) = {std::sin(1.0 + i + 7 * k), phase * std::cos(2.0 + i * k + k)};
  return A + A.adjoint().eval();
}

ReducedModel some_model() {
  ReducedModel model;
  model.sector_count = 3;
  model.contact.arc_length = Eigen::VectorXd::Zero(1);
  for (const double phase : {0.0, 1.0})
    model.nodal_diameters.push_back(
        {{{some_matrix(phase), 2 * some_matrix(phase), 3 * some_matrix(phase)}}, 4 * some_matrix(phase)});
  return model;
}

TEST(MatrixMarket, ReadsBackBitByBit) {
  const ReducedModel model = some_model();
  const auto folder = std::filesystem::path(::testing::TempDir()) / "matrix_market";
  std::filesystem::remove_all(folder);
  write_matrix_market(model, folder);
  for (int n = 0; n < 2; ++n) {
    const NodalDiameterModel& of = model.nodal_diameters[n];
    const std::pair<const char*, const Eigen::MatrixXcd&> all[] = {
        {"K0", of.K[0]}, {"K1", of.K[1]}, {"K2", of.K[2]}, {"M", of.M}};
    for (const auto& [name, matrix] : all) {
      std::string header;
      EXPECT_EQ(read_back(folder / ("n" + std::to_string(n) + "_" + name + ".mtx"), header), matrix) << n << name;
      EXPECT_EQ(header, n == 0 ? "%%MatrixMarket matrix array real symmetric"
                               : "%%MatrixMarket matrix array complex hermitian");
    }
  }
}

/// Symptom: K3 and the second nodal diameter of an earlier model stayed beside K0, K1 and K2 of another.
TEST(MatrixMarket, LeavesNoMatricesOfAnEarlierModel) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / "matrix_market_again";
  std::filesystem::remove_all(folder);
  ReducedModel model = some_model();
  for (NodalDiameterModel& of : model.nodal_diameters) of.K.terms.push_back(of.M);
  write_matrix_market(model, folder);
  EXPECT_TRUE(exists(folder / "n1_K3.mtx"));
  std::ofstream(folder / "n0_notes.mtx") << "of somebody else";
  model = some_model();
  model.nodal_diameters.pop_back();
  write_matrix_market(model, folder);
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename());
  EXPECT_EQ(names, (std::set<std::string>{"n0_K0.mtx", "n0_K1.mtx", "n0_K2.mtx", "n0_M.mtx", "n0_notes.mtx"}));
}

}  // namespace
}  // namespace tiprub::reduce
