// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/wheel_cycle.h"

#include <cmath>
#include <complex>
#include <numeric>

#include "cases/program/errors.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub {

namespace {

constexpr double same_state = 1e-3;  // of the norm of the states

void require_dofs(Eigen::Index found, Eigen::Index asked) {
  if (found != asked)
    throw InputError("the response's states of the rotor have " + std::to_string(found) + " dofs, the model has " +
                     std::to_string(asked) + "; give the model that the response was made with");
}

/// How far the later states of a cycle are from earlier ones turned.
class TurnedDifference {
 public:
  TurnedDifference(const WheelCycle& cycle, const SpeedResponse& response, const SimulatedScene& scene,
                   const ReducedModel& model)
      : cycle_(cycle), scene_(scene) {
    for (const int n : scene.nodal_diameters)
      stiffness_.push_back(model.nodal_diameters[static_cast<std::size_t>(n)].stiffness(response.speed));
    for (std::size_t i = 0; i < cycle.states.size(); ++i) norm_ += energy(i, cycle.states[i]);
  }

  /// [1] of the norm: states `shift` samples later against those that turned by so many sectors.
  double operator()(int shift, int turn) const {
    double difference = 0;
    const Eigen::Index columns = cycle_.samples() - shift;
    for (std::size_t i = 0; i < cycle_.states.size(); ++i) {
      const std::complex<double> phase = sector_phase(scene_.nodal_diameters[i], turn, scene_.sector_count);
      difference += energy(i, cycle_.states[i].rightCols(columns) - phase * cycle_.states[i].leftCols(columns));
    }
    const double share = static_cast<double>(columns) / cycle_.samples();
    return norm_ > 0 ? std::sqrt(difference / (norm_ * share)) : 0;
  }

 private:
  double energy(std::size_t i, const Eigen::MatrixXcd& states) const {
    return states.conjugate().cwiseProduct(stiffness_[i] * states).sum().real();
  }

  const WheelCycle& cycle_;
  const SimulatedScene& scene_;
  std::vector<Eigen::MatrixXcd> stiffness_;
  double norm_ = 0;
};

/// Keeps the samples up to the first from which on all are earlier ones turned. Only after whole beats, when each
/// lobe is where another one was, can it be; half of the samples at least must show it.
void drop_repeats(WheelCycle& cycle, int beat, const TurnedDifference& difference) {
  for (int shift = beat; 2 * shift <= cycle.samples(); shift += beat)
    for (int turn = 0; turn < cycle.sectors; ++turn)
      if (difference(shift, turn) < same_state) {
        cycle.turn = turn;
        for (Eigen::MatrixXcd& states : cycle.states) states.conservativeResize(Eigen::NoChange, shift);
        return;
      }
}

}  // namespace

int WheelCycle::histories() const {
  return std::gcd(turn, sectors);
}

WheelCycle wheel_cycle(const SpeedResponse& response, const SimulatedScene& scene, const ReducedModel& model) {
  WheelCycle cycle;
  cycle.sectors = scene.independent_sectors;
  cycle.whole = response.cycle.has_value();
  if (cycle.whole) {
    cycle.first_sample = response.cycle->first_sample;
    cycle.states = response.cycle->displacement;
  } else {
    cycle.first_sample = response.snapshot->sample;
    for (const Eigen::VectorXcd& state : response.snapshot->displacement) cycle.states.emplace_back(state);
  }
  for (std::size_t i = 0; i < cycle.states.size(); ++i) {
    const auto n = static_cast<std::size_t>(scene.nodal_diameters[i]);
    require_dofs(cycle.states[i].rows(), model.nodal_diameters[n].M.rows());
  }
  cycle.recorded_samples = cycle.samples();
  const int beats = std::lcm(scene.sector_count, scene.lobes);
  if (cycle.whole && response.samples_per_revolution % beats == 0)
    drop_repeats(cycle, response.samples_per_revolution / beats, TurnedDifference(cycle, response, scene, model));
  return cycle;
}

}  // namespace tiprub
