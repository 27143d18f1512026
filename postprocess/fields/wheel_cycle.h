// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub::postprocess {

/// The wheel's states over a cycle, without repetitions. A motion that follows the casing repeats itself many
/// times per revolution, turned by some sectors. A few samples of all independent sectors therefore contain the
/// stress of the whole cycle.
struct WheelCycle {
  /// By nodal diameter, as SimulatedScene lists them; model dofs x samples. After the last sample the first one
  /// follows again, turned by `turn` sectors, or the cycle ends.
  std::vector<Eigen::MatrixXcd> states;
  int first_sample = 0;  ///< of the recorded ones
  int stride = 1;        ///< recorded samples from one to the next
  int turn = 0;          ///< [sectors] after the last sample sector j repeats what sector j + turn did
  int sectors = 0;       ///< independent ones
  bool whole = false;    ///< whether this is a whole cycle; if not, it is one instant, without a mean
  /// How many samples the whole cycle has.
  int recorded_samples = 0;
  int samples_per_revolution = 0;  ///< of the recording

  int samples() const { return static_cast<int>(states.front().cols()); }
  /// The number of blades with different histories: blades j and j + histories() pass through the same states at
  /// different times.
  int histories() const;
};

/// The cycle as it was recorded, with its repetitions.
WheelCycle whole_cycle(const RotorCycle& cycle, const SimulatedScene& scene);

/// From the cycle of a speed or, without one, from its snapshot; the speed must have either. States that differ by
/// less than 1e-3 of their norm (of elastic energy) count as equal; the error of stress from a mesh is far larger.
WheelCycle wheel_cycle(const SpeedResponse& response, const SimulatedScene& scene, const ReducedModel& model);
/// The single sample of a speed's snapshot, which it must have.
WheelCycle wheel_instant(const SpeedResponse& response, const SimulatedScene& scene);
/// The cycle of a varied peak that has one.
WheelCycle wheel_cycle(const PeakVariation& peak, const SimulatedScene& scene, const ReducedModel& model);

/// Each sample of a cycle at a distance of `stride`, from the first one on.
WheelCycle every(int stride, const WheelCycle& cycle);

/// The cycle with states that are sums of fewer ones (proper orthogonal decomposition). What is left out of a nodal
/// diameter has at most the share `left_out` of the cycle's norm (of elastic energy, over all samples). `stiffness`:
/// as the states.
WheelCycle of_fewer_states(WheelCycle cycle, const std::vector<Eigen::MatrixXcd>& stiffness, double left_out);

/// The Fourier coefficients of states at evenly spaced samples of a cycle; dofs x lines. The phase of line m over R
/// revolutions is k phi_s = 2 pi m s / S, k = m/R, with s counted from the start of the recording; the upper half of
/// the lines has negative k.
Eigen::MatrixXcd fourier_lines(Eigen::MatrixXcd states, int first_sample);

/// One travelling wave of the whole rotor: sector j moves by Re(x e^{i (k phi + n j alpha)}), phi the rotor's angle
/// from the start of the recording, k = engine_order, of either sign.
struct RotorWave {
  int nodal_diameter = 0;   ///< n, 0 .. N/2
  double engine_order = 0;  ///< k; 0: at rest in the rotor
  double share = 0;         ///< [1] of the motion's mean square, weighted by mass
  Eigen::VectorXcd state;   ///< x, in the model's dofs [m in contact rows]
};

/// The rotor's motion over a cycle as a sum of its largest waves: a few numbers per node describe all instants.
struct WheelMotion {
  int first_sample = 0;          ///< of the recorded ones: the cycle's
  int samples = 0;               ///< in the cycle, to the end of the recording
  std::vector<RotorWave> waves;  ///< the largest first
  double left_out = 0;           ///< [1] share of the mean square in all other waves
};

/// The largest waves of the motion of a speed that has a cycle: as many as leave out a share of `left_out` or less,
/// but at most `most`. They are terms of the Fourier series of the model's states over whole revolutions.
WheelMotion wheel_motion(const SpeedResponse& response, const SimulatedScene& scene, const ReducedModel& model,
                         double left_out, std::size_t most);

}  // namespace tiprub::postprocess
