// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/input_check.h"

#include <gtest/gtest.h>

#include "synthetic_scene.h"
#include "tests/cases/complaint.h"

namespace tiprub::postprocess {
namespace {

/// Another material: the same sectors, contact nodes and dofs, and other numbers. It was taken without a word.
TEST(InputCheck, RefusesTheResponseOfAnotherModelOfTheSameSize) {
  ReducedModel model = synthetic::model();
  const Response response = synthetic::resonant_sweep(model);
  EXPECT_EQ(complaint<InputError>([&] { check_together(model, response, "r.h5"); }), "");
  model.nodal_diameters[1].K[0] *= 1.001;
  EXPECT_EQ(complaint<InputError>([&] { check_together(model, response, "r.h5"); }),
            "r.h5: was made with another model of the same size; give that one, or run tiprub-simulate");
}

TEST(InputCheck, RefusesAnotherCasing) {
  SimulatedScene scene;
  scene.casing = "amplitude = 0.0001\nlobes = 2\n";
  EXPECT_EQ(complaint<InputError>([&] { check_casing(scene.casing, scene, "r.h5"); }), "");
  EXPECT_EQ(
      complaint<InputError>([&] { check_casing("amplitude = 0.0001\nlobes = 3\n", scene, "r.h5"); }),
      "r.h5: was simulated with another [casing] than this case's: lobes is 2 there and 3 here; run tiprub-simulate "
      "again, or give the case (or --set) that it was made with");
  // Symptom: 2.0 was another number than 2, and of an added key another line was named.
  EXPECT_EQ(complaint<InputError>([&] { check_casing("lobes = 2.0\namplitude = 0.0001\n", scene, "r.h5"); }), "");
  EXPECT_NE(complaint<InputError>([&] {
              check_casing("amplitude = 0.0001\nfriction = 0.10\nlobes = 2\n", scene, "r.h5");
            }).find("friction is not given there and 0.1 here"),
            std::string::npos);
}

}  // namespace
}  // namespace tiprub::postprocess
