// SPDX-License-Identifier: GPL-3.0-or-later
// What a file tells of the effects that are modelled.
#include "reduce/model/modelled_effects.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <functional>

#include "cases/program/errors.h"
#include "reduce/model/hdf5_file.h"
#include "tests/cases/complaint.h"

namespace tiprub::reduce {
namespace {

class ModelledEffects : public ::testing::Test {
 protected:
  ~ModelledEffects() override { std::filesystem::remove(path_); }

  std::vector<ModelledEffect> read_after(const std::function<void(Hdf5File&)>& write) const {
    {
      Hdf5File file = Hdf5File::create(path_);
      write(file);
    }
    return read_effects(Hdf5File::open(path_));
  }

  const std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("tiprub-effects-" + std::to_string(getpid()) + ".h5");
};

TEST_F(ModelledEffects, ComeBackInTheirOrder) {
  const ModelledEffect friction{Effect::friction, Treatment::left_out, "along the normal alone"};
  const ModelledEffect stiffness{Effect::spin_stiffness, Treatment::simplified, "eq. 7", 1e-4, 1e-3};
  EXPECT_EQ(read_after([&](Hdf5File& file) {
              write_effects(file, {stiffness, friction});
            }),
            (std::vector<ModelledEffect>{friction, stiffness}));
  EXPECT_TRUE(read_after([](Hdf5File&) {}).empty());
}

TEST_F(ModelledEffects, AreRefusedWhereTheyAreWrong) {
  const std::string coriolis = "/effects/coriolis";
  const auto complaint = [&](const std::string& group, const std::string& name, const auto& value) {
    return tiprub::complaint<RunError>([&] {
      read_after([&](Hdf5File& file) {
        if (group != coriolis || name != "treatment")
          file.set_attribute(coriolis, "treatment", std::string("left out"));
        file.set_attribute(coriolis, "reason", std::string("none"));
        file.set_attribute(group, name, value);
      });
    });
  };
  const std::string file = path_.string() + ": ";
  EXPECT_EQ(complaint(coriolis, "size", 0.5), "");
  EXPECT_EQ(complaint(coriolis, "size", -0.5), file + "/effects/coriolis: attribute size must be at least 0");
  EXPECT_EQ(complaint(coriolis, "unit", std::string("m")),
            file + "/effects/coriolis: attribute unit is \"m\", must be \"1\"");
  EXPECT_EQ(
      complaint(coriolis, "treatment", std::string("some")),
      file +
          "/effects/coriolis: attribute treatment is \"some\", must be \"modelled\", \"simplified\" or \"left out\"");
  EXPECT_EQ(complaint("/effects/magnetism", "treatment", std::string("modelled")),
            file + "/effects/magnetism is not known");
}

}  // namespace
}  // namespace tiprub::reduce
