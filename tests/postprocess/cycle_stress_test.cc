// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "postprocess/fields/field_peak.h"
#include "synthetic_scene.h"

namespace tiprub::postprocess::cycle_stress_test {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr int sector_count = 10, independent = 5, nodes = 7;

/// Each dof of a nodal diameter has a tensor of its own at each node.
WaveRecovery made_recovery(const std::vector<int>& diameters) {
  return [diameters](std::size_t i, const Eigen::MatrixXcd& states) {
    std::vector<WaveField> waves;
    for (Eigen::Index s = 0; s < states.cols(); ++s) {
      WaveField wave{diameters[i], Eigen::Matrix3Xcd::Zero(3, nodes), ComplexTensors::Zero(6, nodes)};
      for (Eigen::Index k = 0; k < states.rows(); ++k)
        for (Eigen::Index node = 0; node < nodes; ++node)
          for (Eigen::Index row = 0; row < 6; ++row) {
            const double seed = 1.0 + 3.7 * row + 1.3 * node + 0.9 * k + 2.1 * static_cast<double>(i);
            wave.stress(row, node) += 1e6 * std::complex(std::sin(seed), std::cos(1.9 * seed)) * states(k, s);
            if (row < 3) wave.displacement(row, node) += 1e-3 * std::cos(seed) * states(k, s);
          }
      waves.push_back(std::move(wave));
    }
    return waves;
  };
}

/// A motion of nodal diameters 0, 2 and 4 that travels with two lobes: engine order k moves nodal diameter n only if
/// k = +-n + m N, so that after a tenth of a revolution the wheel stands as before, turned.
SpeedResponse travelling_motion(const ReducedModel& model, const SimulatedScene& scene, int samples) {
  SpeedResponse response;
  response.speed = 1000;
  response.samples_per_revolution = samples;
  response.recorded_revolutions = 1;
  response.cycle.emplace();
  for (const int n : scene.nodal_diameters) {
    const Eigen::Index dofs = model.nodal_diameters[static_cast<std::size_t>(n)].M.rows();
    Eigen::MatrixXcd states = Eigen::MatrixXcd::Zero(dofs, samples);
    for (int s = 0; s < samples; ++s)
      for (Eigen::Index k = 0; k < dofs; ++k)
        for (int order : {n, n + sector_count, n - sector_count}) {
          const double phase = two_pi * order * s / samples + 0.3 * static_cast<double>(k) + order;
          states(k, s) += 1e-5 / (2.0 + static_cast<double>(k) + n) * std::polar(1.0, phase);
        }
    if (n == 0) states = states.real().cast<std::complex<double>>();
    response.cycle->displacement.push_back(states);
  }
  return response;
}

class Cycle : public ::testing::Test {
 protected:
  Cycle() : model_(synthetic::model()), scene_(synthetic::two_lobes()) {}

  CycleStress stress_of(const WheelCycle& cycle, int most_fields = 1000) const {
    Tensors spin(6, nodes);
    for (Eigen::Index k = 0; k < spin.size(); ++k) spin.data()[k] = 20 * std::sin(0.7 * static_cast<double>(k));
    Progress progress("", 0, Progress::Shown::never);
    return cycle_stress(cycle, spin, sector_count, made_recovery(scene_.nodal_diameters), most_fields, progress);
  }

  ReducedModel model_;
  SimulatedScene scene_;
};

TEST_F(Cycle, OfAMotionThatTravelsWithTheCasingIsOneBeat) {
  const SpeedResponse response = travelling_motion(model_, scene_, 60);
  const WheelCycle cut = wheel_cycle(response, scene_, model_);
  EXPECT_EQ(cut.samples(), 60 / sector_count);
  EXPECT_EQ(cut.recorded_samples, 60);
  EXPECT_EQ(cut.histories(), 1);
  WheelCycle whole = cut;
  whole.states = response.cycle->displacement;
  whole.turn = 0;
  EXPECT_EQ(whole.histories(), independent);
  const CycleStress of_cut = stress_of(cut), of_whole = stress_of(whole), in_blocks = stress_of(cut, 4);
  for (int node = 0; node < nodes; ++node) {
    EXPECT_NEAR(of_cut.vibration[node], of_whole.vibration[node], 1e-10 * of_whole.vibration[node]);
    EXPECT_NEAR(of_cut.both[node], of_whole.both[node], 1e-10 * of_whole.both[node]);
    for (int blade = 0; blade < independent; ++blade) {
      EXPECT_NEAR(of_cut.mean(node, 0), of_whole.mean(node, blade), 1e-10 * of_whole.mean(node, blade));
      EXPECT_NEAR(of_cut.alternating(node, 0), of_whole.alternating(node, blade),
                  1e-10 * of_whole.alternating(node, blade));
    }
  }
  EXPECT_LT((in_blocks.vibration - of_cut.vibration).norm(), 1e-10 * of_cut.vibration.norm());
  EXPECT_LT((in_blocks.alternating - of_cut.alternating).norm(), 1e-10 * of_cut.alternating.norm());
  EXPECT_EQ(in_blocks.sample, of_cut.sample);
}

TEST_F(Cycle, OfAnotherMotionKeepsAllSamples) {
  SpeedResponse response = travelling_motion(model_, scene_, 60);
  response.cycle->displacement[1].col(7) *= 1.1;
  const WheelCycle cycle = wheel_cycle(response, scene_, model_);
  EXPECT_EQ(cycle.samples(), 60);
  EXPECT_EQ(cycle.histories(), independent);
}

TEST_F(Cycle, IsASingleInstantWithoutOne) {
  SpeedResponse response = travelling_motion(model_, scene_, 60);
  RotorSnapshot& snapshot = response.snapshot.emplace();
  snapshot.sample = 17;
  for (const Eigen::MatrixXcd& states : response.cycle->displacement)
    snapshot.displacement.emplace_back(states.col(17));
  response.cycle.reset();
  const CycleStress stress = stress_of(wheel_cycle(response, scene_, model_));
  EXPECT_EQ(stress.sample, Eigen::VectorXi::Constant(nodes, 17));
  EXPECT_EQ(stress.mean.cols(), 0);
  EXPECT_GT(stress.vibration.minCoeff(), 0);
}

/// Tension along z at all nodes, m + a cos(phase), the same in all sectors; static tension from spin along z as well.
class Tension : public ::testing::Test {
 protected:
  static constexpr double unit = 1e6, middle = 30, amplitude = 100, spin = 250;  // [MPa]

  CycleStress stress() const {
    WheelCycle cycle;
    cycle.whole = true;
    cycle.sectors = 1;
    cycle.states = {Eigen::MatrixXcd(1, 8)};
    for (int s = 0; s < 8; ++s) cycle.states[0](0, s) = middle + amplitude * std::cos(two_pi * (s - 3) / 8);
    Tensors of_spin = Tensors::Zero(6, nodes);
    of_spin.row(2).setConstant(spin * unit);
    const WaveRecovery recover = [](std::size_t, const Eigen::MatrixXcd& states) {
      std::vector<WaveField> waves;
      for (const std::complex<double>& value : states.reshaped()) {
        waves.push_back({0, Eigen::Matrix3Xcd::Zero(3, nodes), ComplexTensors::Zero(6, nodes)});
        waves.back().stress.row(2).setConstant(value * unit);
      }
      return waves;
    };
    Progress progress("", 0, Progress::Shown::never);
    return cycle_stress(cycle, of_spin, 1, recover, 3, progress);
  }
};

TEST_F(Tension, HasTheMeanAndTheAmplitudeThatItIsMadeOf) {
  const CycleStress found = stress();
  for (int node = 0; node < nodes; ++node) {
    EXPECT_NEAR(found.vibration[node], (middle + amplitude) * unit, 1);
    EXPECT_NEAR(found.both[node], (spin + middle + amplitude) * unit, 1);
    EXPECT_NEAR(found.spin[node], spin * unit, 1);
    EXPECT_NEAR(found.mean(node, 0), (spin + middle) * unit, 1);
    EXPECT_NEAR(found.alternating(node, 0), amplitude * unit, 1);
    EXPECT_EQ(found.sample[node], 3);
  }
}

/// A planted point inside a patch is reported apart: the headline is what lies outside.
TEST_F(Tension, InAnExcludedPatchIsNotTheHeadline) {
  SectorFields sector;
  sector.nodes = Eigen::Matrix3Xd::Random(3, nodes);
  sector.node_sets["contact"] = {0};
  CycleStress planted = stress();
  planted.vibration[2] = 5e9;
  planted.alternating(2, 0) = 4e9;
  planted.both[4] = planted.vibration[4] = 3e9;
  planted.vibration[5] += 1e6;
  StressZones zones{0.01, std::vector<StressZone>(nodes, StressZone::body)};
  zones.at_node[2] = StressZone::tip_patch;
  zones.at_node[4] = StressZone::clamp_rim;
  const MaterialStrength strength{1000 * unit, 500 * unit, 760 * unit};
  const FieldPeak peak = field_peak(sector, planted, zones, BladePlaces(sector), strength);
  EXPECT_NEAR(peak.body.vibration, (middle + amplitude + 1) * unit, 1);
  EXPECT_NEAR(peak.body.both, (spin + middle + amplitude) * unit, 1);
  EXPECT_EQ(peak.tip_patch.vibration, 5e9);
  EXPECT_EQ(peak.clamp_rim.both, 3e9);
  EXPECT_NEAR(peak.place[0], sector.nodes.col(5).head<2>().norm(), 1e-12);
  ASSERT_TRUE(peak.cycle.has_value());
  EXPECT_NEAR(peak.cycle->alternating, amplitude * unit, 1);
  EXPECT_NEAR(peak.cycle->goodman.value(), amplitude / 500 + (spin + middle) / 1000, 1e-9);
  EXPECT_NEAR(peak.yield_share.value(), (spin + middle + amplitude) / 760, 1e-9);
  EXPECT_FALSE(field_peak(sector, planted, zones, BladePlaces(sector), {}).cycle->goodman.has_value());
}

}  // namespace
}  // namespace tiprub::postprocess::cycle_stress_test
