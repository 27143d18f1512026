// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include "reduce/model/hdf5_file.h"
#include "reduce/model/reduced_model_file.h"
#include "tests/cases/complaint.h"

namespace tiprub::reduce {
namespace {

/// A tip that turns by so much [rad] from one contact node to the next.
void write_turned_tip(const std::filesystem::path& path, double turn) {
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(6, 6);
  Eigen::MatrixXd position(2, 3), normal(2, 3);
  position << 0.1, -0.2, 0.0, 0.1, -0.2 + turn, 0.02;
  normal << 1, 0, 0, 1, 0, 0;
  Hdf5File file = Hdf5File::create(path);
  file.set_schema("tiprub-model", 1, "by hand");
  file.set_attribute("/", "sector_count", 1);
  file.set_attribute("/", "speed_max", 100.0);
  file.write("/contact/position", position, "m, rad, m");
  file.write("/contact/normal", normal, "1");
  file.write("/contact/arc_length", Eigen::VectorXd(Eigen::Vector2d(0.0, 0.02)), "m");
  file.write("/nodal_diameter/0/K0", Eigen::MatrixXd(4 * one), "N/m");
  file.write("/nodal_diameter/0/M", one, "kg");
}

/// Symptom: reduce wrote a model whose tip turns by 93 degrees from node to node, and all later programs refused it,
/// because degrees are told by such steps in a model by hand.
TEST(ModelByHand, AloneTellsDegreesByTheStepsOfTheTip) {
  const auto path = std::filesystem::path(testing::TempDir()) / ("by_hand_" + std::to_string(getpid()) + ".h5");
  write_turned_tip(path, 1.5);
  ReducedModel model = read_model(path);
  model.contact.position(1, 1) += 0.2;
  write_model(model, path, "test");
  EXPECT_EQ(read_model(path).contact.position, model.contact.position);
  write_turned_tip(path, 1.7);
  EXPECT_EQ(complaint<RunError>([&] { read_model(path); }),
            path.string() +
                ": /contact/position: theta goes from -0.2 rad in row 0 to 1.5 rad in the next, more than a quarter "
                "of a turn: is it in degrees?");
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace tiprub::reduce
