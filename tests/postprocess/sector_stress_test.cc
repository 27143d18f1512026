// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/sector_stress.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <complex>
#include <filesystem>
#include <numbers>
#include <string>

#include "postprocess/fields/field_recovery.h"
#include "synthetic_fields.h"
#include "synthetic_scene.h"

namespace tiprub::postprocess::sector_stress_test {
namespace {

constexpr double speed = 1000;  // [rad/s]

/// Two revolutions of a motion that does not repeat itself: waves of no whole engine order that beat.
WheelCycle modulated(const ReducedModel& model, const SimulatedScene& scene) {
  constexpr int samples = 480;
  WheelCycle cycle;
  cycle.sectors = scene.independent_sectors;
  cycle.whole = true;
  cycle.first_sample = 7;
  cycle.recorded_samples = samples;
  cycle.samples_per_revolution = 240;
  for (const int n : scene.nodal_diameters) {
    Eigen::MatrixXcd states(model.nodal_diameters[static_cast<std::size_t>(n)].M.rows(), samples);
    for (Eigen::Index k = 0; k < states.rows(); ++k)
      for (Eigen::Index s = 0; s < samples; ++s) {
        const double turned = 2 * std::numbers::pi * static_cast<double>(s) / cycle.samples_per_revolution;
        const auto seed = static_cast<double>(k + n);
        states(k, s) = 1e-5 * (std::polar(1.0, 6.37 * turned + seed) + std::polar(0.8, 13.9 * turned - seed));
        if (n == 0) states(k, s) = states(k, s).real();
      }
    cycle.states.push_back(states);
  }
  return cycle;
}

class SectorStressTest : public ::testing::Test {
 protected:
  SectorStressTest()
      : path_(std::filesystem::path(testing::TempDir()) / ("sector_stress_" + std::to_string(getpid()) + ".h5")) {
    synthetic::write_fields(model_, path_);
  }
  ~SectorStressTest() override { std::filesystem::remove(path_); }

  ReducedModel model_ = synthetic::model();
  SimulatedScene scene_ = synthetic::two_lobes();
  std::filesystem::path path_;
};

TEST_F(SectorStressTest, HasTheLargestValuesOfAllSamples) {
  const FieldsReader reader(path_);
  const CellStress cells(reader.sector());
  StressZones zones;
  zones.at_node.resize(static_cast<std::size_t>(reader.sector().nodes.cols()), StressZone::body);
  zones.at_node.front() = zones.at_node.back() = StressZone::tip_patch;
  const std::optional<MaterialStrength> strength = MaterialStrength{900e6, 400e6, {}};
  const SectorStress on_sector(reader, cells, model_, scene_.nodal_diameters, zones, strength);
  const WheelCycle cycle = modulated(model_, scene_);
  EXPECT_EQ(samples_on_sector(cycle), 120);

  Progress progress("", 0, Progress::Shown::never);
  CycleStress found;
  on_sector.over({{cycle, speed}}, progress, [&](std::size_t, const CycleStress& stress) { found = stress; });
  const auto recover = [&](std::size_t i, const Eigen::MatrixXcd& states) { return on_sector.recover(i, states); };
  const CycleStress all = cycle_stress(cycle, spin_field(reader.sector(), cells, speed).stress.real(),
                                       model_.sector_count, recover, 1000, progress);
  const auto expect_largest = [&](const Eigen::VectorXd& here, const Eigen::VectorXd& of_all, double above) {
    for (const StressZone zone : {StressZone::body, StressZone::tip_patch}) {
      const Eigen::Index node = largest_in(zone, zones, of_all);
      EXPECT_NEAR(here[node], of_all[node], 1e-9 * of_all[node]);
      EXPECT_EQ(largest_in(zone, zones, here), node);
    }
    EXPECT_LT((here - of_all).maxCoeff(), above * of_all.maxCoeff());
  };
  expect_largest(found.vibration, all.vibration, 1e-9);
  expect_largest(found.both, all.both, 1e-9);
  expect_largest(found.displacement, all.displacement, 1e-9);
  for (Eigen::Index h = 0; h < all.alternating.cols(); ++h)
    expect_largest(found.alternating.col(h), all.alternating.col(h), 0.01);  // the mean differs a little
  const Eigen::Index worst = largest_in(StressZone::body, zones, all.vibration);
  EXPECT_EQ(found.sector[worst], all.sector[worst]);
  EXPECT_EQ(found.sample[worst], all.sample[worst]);
  EXPECT_GT((all.vibration - found.vibration).maxCoeff(), 0) << "nothing was left out";
}

void expect_same(const CycleStress& here, const CycleStress& there) {
  const double rounding = 1e-11 * there.both.maxCoeff();
  ASSERT_GT(there.vibration.minCoeff(), 0);
  EXPECT_LT((here.vibration - there.vibration).cwiseAbs().maxCoeff(), rounding);
  EXPECT_LT((here.both - there.both).cwiseAbs().maxCoeff(), rounding);
  ASSERT_EQ(here.alternating.cols(), there.alternating.cols());
  EXPECT_TRUE(((here.alternating - there.alternating).array().abs() < rounding).all());
  EXPECT_EQ(here.sample, there.sample);
}

TEST_F(SectorStressTest, IsTheSameForCyclesThatAreReadTogether) {
  const FieldsReader reader(path_);
  const CellStress cells(reader.sector());
  StressZones zones;
  zones.at_node.resize(static_cast<std::size_t>(reader.sector().nodes.cols()), StressZone::body);
  const std::optional<MaterialStrength> no_strength;
  SectorStress on_sector(reader, cells, model_, scene_.nodal_diameters, zones, no_strength);
  Progress progress("", 0, Progress::Shown::never);
  const auto stress_of = [&](const std::vector<SectorStress::At>& cycles) {
    std::vector<CycleStress> all;
    on_sector.over(cycles, progress, [&](std::size_t place, const CycleStress& stress) {
      EXPECT_EQ(place, all.size());
      all.push_back(stress);
    });
    return all;
  };
  WheelCycle beat = modulated(model_, scene_), instant = beat;
  for (Eigen::MatrixXcd& states : beat.states) states.conservativeResize(Eigen::NoChange, 24);
  for (Eigen::MatrixXcd& states : instant.states) states = states.rightCols(1).eval();
  instant.whole = false;
  const std::vector<SectorStress::At> cycles = {{instant, speed}, {beat, 1.5 * speed}, {beat, speed}};
  std::vector<CycleStress> alone;
  for (const SectorStress::At& cycle : cycles) alone.push_back(stress_of({cycle}).front());
  EXPECT_EQ(alone[1].alternating.cols(), beat.histories());
  EXPECT_GT(alone[1].spin.maxCoeff(), 2 * alone[2].spin.maxCoeff());
  const int fields = fields_of(few_states(beat, 0, beat.samples()));
  for (const int most : {1000, fields + fields / 2, fields, fields - 1, 1}) {  // together, in turn, in parts
    on_sector.set_most_fields(most);
    const std::vector<CycleStress> together = stress_of(cycles);
    ASSERT_EQ(together.size(), cycles.size());
    for (std::size_t k = 0; k < cycles.size(); ++k) expect_same(together[k], alone[k]);
  }
}

TEST_F(SectorStressTest, LeavesOutALimitedShareOfTheEnergy) {
  constexpr double left_out = 1e-2;
  WheelCycle cycle = modulated(model_, scene_);
  std::vector<Eigen::MatrixXcd> stiffness;
  for (std::size_t i = 0; i < cycle.states.size(); ++i) {
    stiffness.push_back(model_.nodal_diameters[static_cast<std::size_t>(scene_.nodal_diameters[i])].stiffness(speed));
    cycle.states[i] += 1e-8 * Eigen::MatrixXcd::Random(cycle.states[i].rows(), cycle.states[i].cols());
  }
  const WheelCycle fewer = of_fewer_states(cycle, stiffness, left_out);
  const auto energy = [&](std::size_t i, const Eigen::MatrixXcd& states) {
    return (states.conjugate().cwiseProduct(stiffness[i] * states)).sum().real();
  };
  double all = 0;
  for (std::size_t i = 0; i < cycle.states.size(); ++i) all += energy(i, cycle.states[i]);
  for (std::size_t i = 0; i < cycle.states.size(); ++i) {
    EXPECT_LE(std::sqrt(energy(i, fewer.states[i] - cycle.states[i])), left_out * std::sqrt(all));
    EXPECT_LT(few_states(fewer, 0, fewer.samples())[i].basis.cols(),
              few_states(cycle, 0, cycle.samples())[i].basis.cols());
  }
}

TEST_F(SectorStressTest, LooksAtAllSamplesOfAMotionThatRepeatsItself) {
  WheelCycle cycle = modulated(model_, scene_);
  EXPECT_EQ(every(3, cycle).samples(), 160);
  EXPECT_EQ(every(3, cycle).stride, 3);
  for (Eigen::MatrixXcd& states : cycle.states) states.conservativeResize(Eigen::NoChange, 48);
  EXPECT_EQ(samples_on_sector(cycle), 48);
}

}  // namespace
}  // namespace tiprub::postprocess::sector_stress_test
