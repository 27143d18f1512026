// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/wheel_cycle.h"

#include <fftw3.h>
#include <functional>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <mutex>
#include <numbers>
#include <numeric>

#include "reduce/model/dense_eigen.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub::postprocess {

namespace {

constexpr double same_state = 1e-3;  // of the norm of the states
std::mutex planning;                 // FFTW makes one plan at a time

/// How far the later states of a cycle are from earlier ones that are turned.
class TurnedDifference {
 public:
  TurnedDifference(const WheelCycle& cycle, double speed, const SimulatedScene& scene, const ReducedModel& model)
      : cycle_(cycle), scene_(scene) {
    for (std::size_t i = 0; i < cycle.states.size(); ++i) {
      const auto n = static_cast<std::size_t>(scene.nodal_diameters[i]);
      forces_.push_back(model.nodal_diameters[n].stiffness(speed) * cycle.states[i]);
      norm_ += energy(cycle.states[i], forces_[i]);
    }
  }

  /// [1] Relative difference between the states `shift` samples later and the states turned by `turn` sectors.
  double operator()(int shift, int turn) const {
    double difference = 0;
    const Eigen::Index columns = cycle_.samples() - shift;
    for (std::size_t i = 0; i < cycle_.states.size(); ++i) {
      const std::complex<double> phase = sector_phase(scene_.nodal_diameters[i], turn, scene_.sector_count);
      const auto turned = [&](const Eigen::MatrixXcd& all) {
        return all.rightCols(columns) - phase * all.leftCols(columns);
      };
      difference += energy(turned(cycle_.states[i]), turned(forces_[i]));
    }
    const double share = static_cast<double>(columns) / cycle_.samples();
    return norm_ > 0 ? std::sqrt(difference / (norm_ * share)) : 0;
  }

 private:
  /// Of states and the elastic forces that belong to them. It is linear in both, so that those of a difference need
  /// no product with the stiffness.
  template <class States, class Forces>
  static double energy(const States& states, const Forces& forces) {
    return states.conjugate().cwiseProduct(forces).sum().real();
  }

  const WheelCycle& cycle_;
  const SimulatedScene& scene_;
  std::vector<Eigen::MatrixXcd> forces_;  // [N in contact rows] as the states
  double norm_ = 0;
};

/// Drops the samples that repeat earlier ones, turned by some sectors. A motion can repeat only after whole beats,
/// when each lobe has taken the place of another one; at least half of the samples must confirm that it does.
void drop_repeats(WheelCycle& cycle, int beat, const TurnedDifference& difference) {
  for (int shift = beat; 2 * shift <= cycle.samples(); shift += beat)
    for (int turn = 0; turn < cycle.sectors; ++turn)
      if (difference(shift, turn) < same_state) {
        cycle.turn = turn;
        for (Eigen::MatrixXcd& states : cycle.states) states.conservativeResize(Eigen::NoChange, shift);
        return;
      }
}

/// A `Motion` has a speed [rad/s], its samples per revolution and a cycle.
template <class Motion>
WheelCycle without_repeats(const Motion& motion, const SimulatedScene& scene, const ReducedModel& model) {
  WheelCycle cycle = whole_cycle(*motion.cycle, scene);
  cycle.samples_per_revolution = motion.samples_per_revolution;
  if (const int beats = std::lcm(scene.sector_count, scene.lobes);
      beats > 0 && motion.samples_per_revolution % beats == 0)
    drop_repeats(cycle, motion.samples_per_revolution / beats, TurnedDifference(cycle, motion.speed, scene, model));
  return cycle;
}

void destroy(fftw_plan_s* plan) {
  const std::lock_guard lock(planning);
  fftw_destroy_plan(plan);
}

/// Adds the waves of one nodal diameter. If it stands, its states are real, and both signs of k are one wave.
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

int WheelCycle::histories() const {
  return std::gcd(turn, sectors);
}

WheelCycle whole_cycle(const RotorCycle& cycle, const SimulatedScene& scene) {
  WheelCycle whole;
  whole.sectors = scene.independent_sectors;
  whole.whole = true;
  whole.first_sample = cycle.first_sample;
  whole.states = cycle.displacement;
  whole.recorded_samples = whole.samples();
  return whole;
}

WheelCycle wheel_cycle(const SpeedResponse& response, const SimulatedScene& scene, const ReducedModel& model) {
  return response.cycle ? without_repeats(response, scene, model) : wheel_instant(response, scene);
}

WheelCycle wheel_instant(const SpeedResponse& response, const SimulatedScene& scene) {
  WheelCycle instant;
  instant.sectors = scene.independent_sectors;
  instant.first_sample = response.snapshot->sample;
  for (const Eigen::VectorXcd& state : response.snapshot->displacement) instant.states.emplace_back(state);
  instant.recorded_samples = instant.samples();
  return instant;
}

WheelCycle wheel_cycle(const PeakVariation& peak, const SimulatedScene& scene, const ReducedModel& model) {
  return without_repeats(peak, scene, model);
}

WheelCycle every(int stride, const WheelCycle& cycle) {
  WheelCycle some = cycle;
  some.stride = stride * cycle.stride;
  for (Eigen::MatrixXcd& states : some.states)
    states = Eigen::MatrixXcd(states(Eigen::all, Eigen::seq(0, Eigen::last, stride)));
  return some;
}

WheelCycle of_fewer_states(WheelCycle cycle, const std::vector<Eigen::MatrixXcd>& stiffness, double left_out) {
  std::vector<ComplexEigenpairs> energy;  // of combinations of the samples
  double all = 0;
  for (std::size_t i = 0; i < cycle.states.size(); ++i) {
    const Eigen::MatrixXcd& states = cycle.states[i];
    energy.push_back(eigenpairs(hermitian_part(states.adjoint() * (stiffness[i] * states))));
    all += energy.back().values.sum();
  }
  const double negligible = left_out * left_out * all;
  for (std::size_t i = 0; i < cycle.states.size(); ++i) {
    const auto& [values, vectors] = energy[i];
    if (!(values[0] >= -negligible)) continue;  // an unstable wheel's energy is no norm
    Eigen::Index few = values.size();
    for (double lost = 0; few > 1 && (lost += values[values.size() - few]) <= negligible;) --few;
    const Eigen::MatrixXcd kept = vectors.rightCols(few);
    cycle.states[i] = (cycle.states[i] * kept) * kept.adjoint();
  }
  return cycle;
}

Eigen::MatrixXcd fourier_lines(Eigen::MatrixXcd states, int first_sample) {
  const auto dofs = static_cast<int>(states.rows()), samples = static_cast<int>(states.cols());
  Eigen::MatrixXcd lines(dofs, samples);
  const auto make_plan = [&] {
    const std::lock_guard lock(planning);
    return fftw_plan_many_dft(1, &samples, dofs, reinterpret_cast<fftw_complex*>(states.data()), nullptr, dofs, 1,
                              reinterpret_cast<fftw_complex*>(lines.data()), nullptr, dofs, 1, FFTW_FORWARD,
                              FFTW_ESTIMATE);
  };
  const std::unique_ptr<fftw_plan_s, decltype(&destroy)> plan(make_plan(), &destroy);
  fftw_execute(plan.get());
  for (int m = 0; m < samples; ++m) {
    const int turns = first_sample % samples * m % samples;
    lines.col(m) *= std::polar(1.0 / samples, -2 * std::numbers::pi * turns / samples);
  }
  return lines;
}

WheelMotion wheel_motion(const SpeedResponse& response, const SimulatedScene& scene, const ReducedModel& model,
                         double left_out, std::size_t most) {
  const RotorCycle& cycle = *response.cycle;
  WheelMotion motion{cycle.first_sample, static_cast<int>(cycle.displacement.front().cols()), {}, 1};
  const int revolutions = std::max(1, motion.samples / response.samples_per_revolution);
  std::vector<RotorWave> waves;
  for (std::size_t i = 0; i < cycle.displacement.size(); ++i) {
    const int n = scene.nodal_diameters[i];
    add_waves(waves, fourier_lines(cycle.displacement[i], motion.first_sample), n, revolutions,
              is_standing(n, scene.sector_count), model.nodal_diameters[static_cast<std::size_t>(n)].M);
  }
  std::ranges::stable_sort(waves, std::greater(), &RotorWave::share);
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

}  // namespace tiprub::postprocess
