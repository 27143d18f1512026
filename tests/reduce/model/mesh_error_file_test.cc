// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "mesh/cells/cell_kind.h"
#include "reduce/model/fields_file.h"
#include "reduce/model/reduced_model_file.h"
#include "tests/cases/complaint.h"
#include "tests/reduce/model/some_model.h"

namespace tiprub::reduce {
namespace {

class MeshErrorFile : public ::testing::Test {
 protected:
  ~MeshErrorFile() override { std::filesystem::remove(path_); }
  /// What reading says about a model with these errors.
  std::string complaint_about(const Eigen::MatrixXd& frequency, const Eigen::VectorXd& compliance) const {
    ReducedModel model = test::some_model();
    model.mesh_error = {frequency, compliance};
    write_model(model, path_, "test");
    return complaint<RunError>([&] { read_model(path_); });
  }

  const std::filesystem::path path_ =
      std::filesystem::path(::testing::TempDir()) / ("tiprub_mesh_error_" + std::to_string(getpid()) + ".h5");
  const Eigen::MatrixXd frequency_ = Eigen::MatrixXd::Constant(3, 2, 1.0 / 300);
  const Eigen::VectorXd compliance_ = Eigen::VectorXd::Constant(1, 0.1);
};

TEST_F(MeshErrorFile, IsReadAsItWasWritten) {
  EXPECT_EQ(complaint_about(frequency_, compliance_), "");
  const std::optional<MeshError> read = read_model(path_).mesh_error;
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->frequency, frequency_);
  EXPECT_EQ(read->compliance, compliance_);
}

TEST_F(MeshErrorFile, MayBeAbsent) {
  write_model(test::some_model(), path_, "test");
  EXPECT_FALSE(read_model(path_).mesh_error.has_value());
}

TEST_F(MeshErrorFile, IsRefusedWhereItDoesNotFitTheModel) {
  const auto expect = [](const std::string& complaint, const char* phrase) {
    EXPECT_NE(complaint.find(phrase), std::string::npos) << complaint;
  };
  expect(complaint_about(frequency_.topRows(2), compliance_),
         "/mesh_error/frequency is 2 x 2, must be 3 x at least 1");
  expect(complaint_about(frequency_, compliance_.replicate(2, 1)),
         "/mesh_error/compliance holds 2 values, must hold 1, one for each contact unknown");
  expect(complaint_about(-frequency_, compliance_), "/mesh_error holds an error below 0");
}

class CellErrorsFile : public MeshErrorFile {
 protected:
  /// Fields of one brick, with the errors of so many cells.
  void write(Eigen::Index cells) const {
    SectorFields sector;
    sector.sector_count = 1;
    sector.young = sector.density = 1;
    sector.cells = Eigen::VectorXi::LinSpaced(20, 0, 19);
    sector.nodes.resize(3, 20);
    for (int k = 0; k < 20; ++k)
      sector.nodes.col(k) = cell_kind(20).places[static_cast<std::size_t>(k)] + Eigen::Vector3d(5, 0, 0);
    for (const char* name : {"clamped", "contact", "cyclic_low", "cyclic_high"}) sector.node_sets[name] = {};
    sector.static_displacement.terms = {Eigen::Matrix3Xd::Zero(3, 20), Eigen::Matrix3Xd::Zero(3, 20)};
    FieldsWriter writer(path_, "test");
    writer.write_sector(sector);
    writer.write_basis(0, 1, true, [](Eigen::Index) { return Eigen::VectorXcd(Eigen::VectorXcd::Zero(60)); });
    if (cells > 0)
      writer.write_mesh_error(Eigen::VectorXd::Constant(cells, 0.25), Eigen::VectorXd::Constant(cells, 0.5));
    writer.close("digest");
  }
};

TEST_F(CellErrorsFile, AreReadAsTheyWereWritten) {
  write(1);
  const FieldsReader reader(path_);
  EXPECT_EQ(reader.cell_errors_of_frequencies(), Eigen::VectorXd::Constant(1, 0.25));
  EXPECT_EQ(reader.cell_errors_of_compliances(), Eigen::VectorXd::Constant(1, 0.5));
}

TEST_F(CellErrorsFile, MayBeAbsent) {
  write(0);
  EXPECT_EQ(FieldsReader(path_).cell_errors_of_frequencies().size(), 0);
}

TEST_F(CellErrorsFile, AreRefusedIfTheyAreNotOneForEachCell) {
  write(2);
  EXPECT_EQ(complaint<RunError>([&] { FieldsReader reader(path_); }),
            path_.string() + ": /mesh_error/frequency must have a number for each cell");
}

}  // namespace
}  // namespace tiprub::reduce
