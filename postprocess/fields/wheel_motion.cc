// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/wheel_motion.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "reduce/model/nodal_diameter.h"

namespace tiprub {

namespace {

/// e^{-i k phi_s} / S: from the S samples of a cycle to its Fourier coefficients; samples x lines. The phase of line
/// m over R revolutions is k phi_s = 2 pi m s / S, s counted from the start of the recording.
Eigen::MatrixXcd transform_of(int first_sample, int samples) {
  Eigen::MatrixXcd transform(samples, samples);
  for (int s = 0; s < samples; ++s)
    for (int m = 0; m < samples; ++m) {
      const int turns = (first_sample + s) % samples * m % samples;
      transform(s, m) = std::polar(1.0 / samples, -2 * std::numbers::pi * turns / samples);
    }
  return transform;
}

/// Waves of one nodal diameter. Of one that stands, whose states are real, both signs of k are one wave.
void add_waves(std::vector<RotorWave>& waves, const Eigen::MatrixXcd& lines, int nodal_diameter, int revolutions,
               bool stands, const Eigen::MatrixXcd& mass) {
  const auto samples = static_cast<int>(lines.cols());
  for (int m = 0; m < samples; ++m) {
    const int k = 2 * m > samples ? m - samples : m;
    if (stands && k < 0) continue;
    const double both_signs = stands && k > 0 && 2 * k != samples ? 2 : 1, time_mean = stands && k == 0 ? 1 : 0.5;
    RotorWave wave{nodal_diameter, static_cast<double>(k) / revolutions, 0, both_signs * lines.col(m)};
    wave.share = time_mean * wave.state.dot(mass * wave.state).real();
    waves.push_back(std::move(wave));
  }
}

}  // namespace

WheelMotion wheel_motion(const SpeedResponse& response, const SimulatedScene& scene, const ReducedModel& model,
                         double left_out, std::size_t most) {
  const RotorCycle& cycle = *response.cycle;
  WheelMotion motion{cycle.first_sample, static_cast<int>(cycle.displacement.front().cols()), {}, 1};
  const int revolutions = std::max(1, motion.samples / response.samples_per_revolution);
  const Eigen::MatrixXcd transform = transform_of(motion.first_sample, motion.samples);
  std::vector<RotorWave> waves;
  for (std::size_t i = 0; i < cycle.displacement.size(); ++i) {
    const int n = scene.nodal_diameters[i];
    add_waves(waves, cycle.displacement[i] * transform, n, revolutions, is_standing(n, scene.sector_count),
              model.nodal_diameters[static_cast<std::size_t>(n)].M);
  }
  std::stable_sort(waves.begin(), waves.end(),
                   [](const RotorWave& a, const RotorWave& b) { return a.share > b.share; });
  double all = 0;
  for (const RotorWave& wave : waves) all += wave.share;
  for (RotorWave& wave : waves) {
    if (motion.waves.size() == most || motion.left_out <= left_out) break;
    wave.share /= all > 0 ? all : 1;
    motion.left_out -= wave.share;
    motion.waves.push_back(std::move(wave));
  }
  return motion;
}

}  // namespace tiprub
