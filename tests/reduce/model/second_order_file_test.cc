// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <optional>

#include "reduce/model/hdf5_file.h"
#include "reduce/model/reduced_model_file.h"
#include "tests/cases/complaint.h"
#include "tests/reduce/model/some_model.h"

namespace tiprub::reduce {
namespace {

class SecondOrderFile : public ::testing::Test {
 protected:
  ~SecondOrderFile() override { std::filesystem::remove(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_ =
      std::filesystem::path(::testing::TempDir()) / ("tiprub_second_order_" + std::to_string(getpid()) + ".h5");
};

SecondOrderGap some_second_order() {
  return {Eigen::RowVector2d(9.5, -4.5),
          Eigen::Matrix<double, 3, 2>{{0.1, 0.0}, {0.9, -0.3}, {0.2, 0.8}},
          {Eigen::Matrix2d{{-9.2, 1.5}, {1.5, -4.8}}}};
}

TEST_F(SecondOrderFile, CarriesTheSecondOrderOfTheGap) {
  ReducedModel model = test::some_model();
  model.contact.second_order = some_second_order();
  write_model(model, path(), "test");
  const std::optional<SecondOrderGap> read = read_model(path()).contact.second_order;
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->curvature, model.contact.second_order->curvature);
  EXPECT_EQ(read->coordinates, model.contact.second_order->coordinates);
  EXPECT_EQ(read->displacement, model.contact.second_order->displacement);
  const std::string name = digest(model);
  EXPECT_NE(name, digest(test::some_model()));
  for (double* number : {&model.contact.second_order->curvature(0, 1), &model.contact.second_order->coordinates(1, 0),
                         &model.contact.second_order->displacement[0](0, 0)}) {
    *number += 1;
    EXPECT_NE(digest(model), name);
    *number -= 1;
  }
}

TEST_F(SecondOrderFile, RefusesASecondOrderThatIsNotWhole) {
  const auto spoiled = [&](const auto& spoil) {
    ReducedModel model = test::some_model();
    model.contact.second_order = some_second_order();
    spoil(*model.contact.second_order);
    write_model(model, path(), "test");
    return complaint<RunError>([&] { read_model(path()); });
  };
  const std::string start = path().string() + ": /contact/second_order/";
  EXPECT_EQ(spoiled([](SecondOrderGap& gap) { gap.curvature = Eigen::MatrixX2d::Zero(2, 2); }),
            start + "curvature is 2 x 2, must be 1 x 2");
  EXPECT_EQ(spoiled([](SecondOrderGap& gap) { gap.coordinates = Eigen::MatrixXd::Ones(6, 2); }),
            start + "V is 6 x 2, must have 3 rows, one for each contact dof, and a column or more");
  EXPECT_EQ(spoiled([](SecondOrderGap& gap) { gap.displacement.push_back(gap.displacement[0]); }),
            start + "Q holds 2 matrices, must hold 1");
  EXPECT_EQ(spoiled([](SecondOrderGap& gap) { gap.coordinates = Eigen::MatrixXd::Ones(3, 1); }),
            start + "Q has matrices of 2 x 2, must be 1 x 1, as /V has columns");
  EXPECT_EQ(spoiled([](SecondOrderGap& gap) { gap.displacement[0](0, 1) += 1; }),
            start + "Q has a matrix that is not symmetric");
  EXPECT_NE(spoiled([](SecondOrderGap& gap) { gap.displacement[0](0, 0) = std::nan(""); }).find("Q: value 0"),
            std::string::npos);
  const auto by_hand = [&](const Eigen::MatrixXd& curvature, const Array<double>& Q) {
    {
      Hdf5File file = Hdf5File::create(path());
      test::write_one_mass(file);
      file.write("/contact/second_order/curvature", curvature, "1/m");
      file.write("/contact/second_order/V", Eigen::MatrixXd(Eigen::Vector3d::UnitY()), "1");
      file.write("/contact/second_order/Q", Q, "1/m");
    }
    return complaint<RunError>([&] { read_model(path()); });
  };
  EXPECT_EQ(by_hand(Eigen::RowVector2d(10, 0), {{1, 1, 1}, {-5}}), "");
  EXPECT_EQ(by_hand(Eigen::RowVector2d(10, 0), {{1, 1}, {-5}}), start + "Q must have three axes: n_c x p x p");
  EXPECT_EQ(by_hand(Eigen::RowVector3d(10, 0, 0), {{1, 1, 1}, {-5}}),
            start + "curvature must have two columns: around and along the casing");
}

}  // namespace
}  // namespace tiprub::reduce
