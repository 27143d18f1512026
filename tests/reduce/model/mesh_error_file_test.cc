// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

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

}  // namespace
}  // namespace tiprub::reduce
