// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/excluded_growth.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <random>
#include <vector>

#include "reduce/model/dense_eigen.h"
#include "simulate/march/march_state.h"

namespace tiprub::simulate {

namespace {

constexpr double seed_share = 1e-8;       // of the settled motion
constexpr double visible_share = 0.1;     // of it: more than contacts that switch within a step can disturb it
constexpr double linear = 0.9;            // least ratio of the factors from these two, if the growth is linear
constexpr double smallest_margin = 1e-3;  // of the factor from 1
constexpr double small_residual = 1e-4;   // of the factor: then it is exact enough
constexpr double clear_residual = 0.1;    // of the distance of the factor from 1: then its side of 1 is clear
constexpr int fewest_states = 6;          // before a residual counts
constexpr int looks_to_double = 8;        // between two looks at it their number grows by one part in so many

/// The march of the whole wheel, with the nodal diameters that the settled march leaves out as a state vector.
class WholeWheel {
 public:
  /// The states that it takes are multiples of a `share` of the settled motion.
  WholeWheel(const TimeMarch& settled, double share)
      : march_(whole(settled.scene())), first_(settled.wave_count()), excluded_(march_, first_) {
    for (std::size_t i = 0; i < first_; ++i) {
      const Eigen::Index modes = settled.wave(i).modes();
      const Eigen::VectorXcd now = settled.coordinates(i).head(modes);
      march_.set_state(i, now, settled.increments(i).head(modes));
      size_ += (settled.wave(i).omega.cwiseMax(settled.rotor().speed) * now.array().abs()).square().sum();
    }
    size_ = share * std::sqrt(size_);
    march_.set_step(settled.step_count());
  }

  Eigen::VectorXd seed() const { return seeded_disturbance(march_, first_); }

  /// The image of a state of any size after some revolutions.
  Eigen::VectorXd advanced(const Eigen::VectorXd& state, int revolutions) {
    excluded_.put(size_ * state, march_);
    const std::int64_t steps = static_cast<std::int64_t>(revolutions) * march_.steps_per_revolution();
    for (std::int64_t i = 0; i < steps; ++i) march_.step();
    return excluded_.of(march_) / size_;
  }

 private:
  static MarchedScene whole(MarchedScene scene) {
    const auto rotor = std::make_shared<RotorAtSpeed>(*scene.rotor);
    rotor->waves.insert(rotor->waves.end(), rotor->others.begin(), rotor->others.end());
    scene.rotor = rotor;
    scene.setup.symmetry = 1;
    return scene;
  }
  TimeMarch march_;
  std::size_t first_;     ///< of the waves left out
  EnergyState excluded_;  ///< what they are at
  double size_ = 0;       ///< [m/s sqrt(kg)] of the disturbance
};

/// The magnitude of the largest eigenvalue of the Hessenberg matrix, and the residual of its Ritz pair.
Growth largest_ritz_value(const Eigen::MatrixXd& hessenberg, double next) {
  const GeneralEigenpairs ritz = general_eigenpairs(hessenberg);
  Eigen::Index largest = 0;
  const double factor = ritz.values.cwiseAbs().maxCoeff(&largest);
  const Eigen::VectorXcd vector = ritz.vectors.col(largest).normalized();
  return {factor, next * std::abs(vector[vector.size() - 1])};
}

/// Of numbers in succession, which depend on each other: from the means of four parts, with 95 % by Student's
/// distribution.
double uncertainty_of_mean(const Eigen::ArrayXd& values) {
  constexpr Eigen::Index parts = 4;
  constexpr double student = 3.18;  // of three degrees of freedom
  const Eigen::Index length = values.size() / parts;
  if (length == 0) return 1;  // too few to tell
  const Eigen::ArrayXd means = values.tail(length * parts).reshaped(length, parts).colwise().mean().transpose();
  return student * std::sqrt((means - means.mean()).square().sum() / ((parts - 1) * parts));
}

Growth by_mean(WholeWheel& wheel, int revolutions) {
  Eigen::VectorXd state = wheel.seed();
  std::vector<double> logarithms;
  for (int r = 0; r < revolutions; ++r) {
    state = wheel.advanced(state, 1);
    const double norm = state.norm();
    if (!(norm > 0)) return {};
    if (2 * r >= revolutions || r + 1 == revolutions) logarithms.push_back(std::log(norm));
    state /= norm;
  }
  const Eigen::Map<const Eigen::ArrayXd> values(logarithms.data(), static_cast<Eigen::Index>(logarithms.size()));
  const double factor = std::exp(values.mean());
  return {factor, factor * uncertainty_of_mean(values)};
}

/// The growth of disturbances of this share of the motion.
Growth growth_from(double share, const TimeMarch& settled, int period, int revolutions) {
  WholeWheel wheel(settled, share);
  if (period == 0) return by_mean(wheel, revolutions);
  const auto map = [&](const Eigen::VectorXd& state) { return wheel.advanced(state, period); };
  return largest_growth(map, wheel.seed(), std::max(revolutions / period, 1), 1.0 / period);
}

}  // namespace

Eigen::VectorXd seeded_disturbance(const TimeMarch& march, std::size_t first_wave) {
  std::mt19937 source(1);
  Eigen::VectorXd state(EnergyState(march, first_wave).layout().size());
  Eigen::Index place = 0;
  for (std::size_t i = first_wave; i < march.wave_count(); ++i) {
    const Eigen::Index modes = march.wave(i).moving;
    for (Eigen::Index k = 0; k < 4 * modes; ++k) {
      const double mode = 1 + static_cast<double>(k % modes);
      const double random = 2.0 * source() / std::mt19937::max() - 1.0;
      if (march.wave(i).kind == WaveKind::standing && k / modes % 2 == 1) continue;  // no imaginary parts
      state[place++] = march.wave(i).omega[k % modes] > 0 ? random / (mode * mode) : 0.0;
    }
  }
  return state.normalized();
}

Growth largest_growth(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& map, const Eigen::VectorXd& seed,
                      int most, double maps) {
  std::vector<Eigen::VectorXd> basis{seed};
  Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(most + 1, most);
  Growth growth;
  int look = std::min(fewest_states, most);
  for (int m = 0; m < most; ++m) {
    Eigen::VectorXd next = map(basis.back());
    for (int twice = 0; twice < 2; ++twice)
      for (int i = 0; i <= m; ++i) {
        const double share = basis[static_cast<std::size_t>(i)].dot(next);
        hessenberg(i, m) += share;
        next -= share * basis[static_cast<std::size_t>(i)];
      }
    hessenberg(m + 1, m) = next.norm();
    const bool is_complete = hessenberg(m + 1, m) == 0;
    if (m + 1 == look || is_complete) {
      growth = largest_ritz_value(hessenberg.topLeftCorner(m + 1, m + 1), hessenberg(m + 1, m));
      look = std::min(look + std::max(look / looks_to_double, 1), most);
      const double small = std::max(small_residual * growth.factor, clear_residual * std::abs(1 - growth.factor));
      if (is_complete || growth.uncertainty < small) break;
    }
    basis.push_back(next / hessenberg(m + 1, m));
  }
  const double power = std::pow(growth.factor, maps);
  return {power, growth.factor > 0 ? power * maps * growth.uncertainty / growth.factor : growth.uncertainty};
}

Growth excluded_growth(const TimeMarch& settled, int period, int revolutions) {
  const Growth small = growth_from(seed_share, settled, period, revolutions);
  const MarchSetup& setup = settled.scene().setup;
  if (maps_states(setup.scheme, setup.contact) || judge(small) != SymmetryVerdict::breaking) return small;
  const Growth visible = growth_from(visible_share, settled, period, revolutions);
  return visible.factor < linear * small.factor ? visible : small;
}

SymmetryVerdict judge(const Growth& growth, int period) {
  const double margin = std::max(growth.uncertainty, smallest_margin);
  if (growth.factor > 1 + margin) return SymmetryVerdict::breaking;
  return period > 0 && growth.factor < 1 - margin ? SymmetryVerdict::holds : SymmetryVerdict::undecided;
}

}  // namespace tiprub::simulate
