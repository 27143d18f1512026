// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/recording.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "reduce/model/nodal_diameter.h"
#include "simulate/motion/casing_areas.h"

namespace tiprub::simulate {

ChatterAudit::ChatterAudit(const TimeMarch& march, const EngineOrderBand& band)
    : band_(band),
      width_(march.width()),
      sum_(Eigen::ArrayXd::Zero(march.displacement().size())),
      squares_(sum_),
      band_squares_(sum_) {}

void ChatterAudit::observe(const Eigen::VectorXd& displacement) {
  sum_ += displacement.array();
  squares_ += displacement.array().square();
  ++instants_;
}

void ChatterAudit::add_revolution(const Eigen::VectorXd& motion) {
  band_squares_ += band_.coefficients(motion).rowwise().squaredNorm().array();
  const Eigen::Index samples = motion.size() / sum_.size();
  samples_ += static_cast<double>(samples);
}

ChatterAudit::Share ChatterAudit::share() const {
  const Eigen::ArrayXd mean_square = (sum_ / instants_).square();
  const Eigen::ArrayXd all = squares_ / instants_ - mean_square;
  const Eigen::ArrayXd above = (all - (band_squares_ / samples_ - mean_square)).max(0.0);
  if (!(all.sum() > 0)) return {};
  Eigen::VectorXd by_node = Eigen::VectorXd::Zero(width_);
  for (Eigen::Index i = 0; i < above.size(); ++i) by_node[i % width_] += above[i];
  Share share{above.sum() / all.sum(), 0};
  by_node.maxCoeff(&share.node);
  return share;
}

Eigen::VectorXd march_revolution(TimeMarch& march, int samples_per_revolution) {
  const int steps = march.steps_per_revolution() / samples_per_revolution;
  const Eigen::Index size = march.displacement().size();
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(samples_per_revolution * size);
  for (int sample = 0; sample < samples_per_revolution; ++sample)
    for (int i = 0; i < steps; ++i) {
      motion.segment(sample * size, size) += march.displacement();
      march.step();
    }
  return motion / steps;
}

Recording::Recording(TimeMarch& march, const Grid& grid)
    : march_(march),
      grid_(grid),
      audit_(march),
      chatter_(march, EngineOrderBand(grid.samples_per_revolution, grid.orders)) {
  const Eigen::Index samples = static_cast<Eigen::Index>(grid.samples_per_revolution) * grid.revolutions;
  const Eigen::Index points = static_cast<Eigen::Index>(march.sectors()) * march.node_count();
  kept_.samples_per_revolution = grid.samples_per_revolution;
  kept_.recorded_revolutions = grid.revolutions;
  kept_.displacement = Eigen::MatrixXd::Zero(samples, 3 * points);
  kept_.contact_force = Eigen::MatrixXd::Zero(samples, points);
  kept_.contact_count.setZero(points, grid.casing_areas);
  if (march.has_friction()) drag_ = torque_ = Eigen::MatrixXd::Zero(samples, march.sectors());
  grid_.cycle_revolutions = std::min(grid.cycle_revolutions, grid.revolutions);
  const Eigen::Index kept = static_cast<Eigen::Index>(grid.samples_per_revolution) * grid_.cycle_revolutions;
  for (const WaveModes& wave : march.rotor().waves) {
    states_.emplace_back(wave.omega.size(), grid.samples_per_revolution);
    cycle_.emplace_back(wave.omega.size(), kept);
  }
}

void Recording::take_states(int sample) {
  for (std::size_t i = 0; i < states_.size(); ++i)
    states_[i].col(sample) = march_.coordinates(i).head(states_[i].rows());
}

/// The forces of a step from t_q to t_{q+1} act at t_q and are recorded there, with the impulses of its impacts.
void Recording::observe(int sample) {
  audit_.observe(march_);
  const double penetration = -march_.gap().minCoeff();
  kept_.largest_penetration = std::max(kept_.largest_penetration, penetration);
  if (penetration > grid_.leftover) ++kept_.leftover_steps;
  const std::vector<int>& closed = march_.contact().closed();
  if (closed.empty()) return;
  const int width = march_.width(), nodes = march_.node_count();
  const double share = static_cast<double>(grid_.samples_per_revolution) / march_.steps_per_revolution();
  double smallest = 0;
  for (int index : closed) {
    const int sector = index / width, node = index % width;
    const double force = march_.contact().multipliers()[index];
    const CasingSteps way{march_.scene().tips.position(node, 1), sector, march_.sector_count(),
                          march_.steps_per_revolution()};
    kept_.contact_force(sample, sector * nodes + node) += share * force;
    if (march_.has_friction()) add_drag(sample, index, share * force);
    ++kept_.contact_count(sector * nodes + node, casing_area(way, march_.step_count() - 1, grid_.casing_areas));
    smallest = std::min(smallest, force);
    (force < 0 ? pulling_ : pushing_) += std::abs(force);
  }
  for (const InnerImpact& impact : march_.impacts()) {
    kept_.contact_force(sample, impact.node() / width * nodes + impact.node() % width) += share * impact.impulse;
    if (march_.has_friction()) add_drag(sample, impact.node(), share * impact.impulse);
    pushing_ += impact.impulse;
  }
  ++kept_.contact_steps;
  if (smallest < 0) ++kept_.tension_steps;
  kept_.smallest_multiplier = std::min(kept_.smallest_multiplier, smallest);
}

void Recording::add_drag(int sample, int index, double force) {
  const Eigen::Vector2d drag = force * march_.drag_ratio().segment<2>(2 * index);
  drag_(sample, index / march_.width()) += drag.norm();
  torque_(sample, index / march_.width()) += march_.scene().tips.position(index % march_.width(), 0) * drag[0];
}

FrictionLoad Recording::friction_load() const {
  FrictionLoad load;
  if (!march_.has_friction()) return load;
  const Eigen::VectorXd of_wheel = march_.symmetry() * torque_.rowwise().sum();
  const double speed = march_.rotor().speed;
  load.drag_work = kept_.energy.drag_work;
  load.blade_drag_mean = drag_.mean();
  load.blade_drag_largest = drag_.maxCoeff();
  load.rub_torque_mean = of_wheel.mean();
  load.rub_torque_largest = of_wheel.maxCoeff();
  load.rub_power_mean = speed * of_wheel.mean();
  load.rub_power_largest = speed * of_wheel.maxCoeff();
  load.blade_rub_power_mean = speed * torque_.mean();
  load.blade_rub_power_largest = speed * torque_.maxCoeff();
  return load;
}

/// u_j = sum over n of Re(Phi_c q e^{i n j alpha}), all samples of a revolution at once.
void Recording::recover_displacements(int first_sample) {
  const int dofs = 3 * march_.node_count();
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const WaveModes& wave = march_.rotor().waves[i];
    const Eigen::MatrixXcd amplitudes = (wave.contact_rows * states_[i]).transpose();
    for (int j = 0; j < march_.sectors(); ++j) {
      const std::complex<double> phase = sector_phase(wave.nodal_diameter, j, march_.rotor().sector_count);
      kept_.displacement.block(first_sample, dofs * j, amplitudes.rows(), dofs) += (amplitudes * phase).real();
    }
  }
}

void Recording::compare_force(int column, int sample) {
  const auto force = [&](int row) { return kept_.contact_force.row(row).cwiseAbs().sum(); };
  if (hardest_sample_ >= 0 && force(sample) <= force(hardest_sample_)) return;
  hardest_sample_ = sample;
  hardest_.clear();
  for (const Eigen::MatrixXcd& states : states_) hardest_.emplace_back(states.col(column));
}

void Recording::keep_cycle() {
  const int place = done_ - (grid_.revolutions - grid_.cycle_revolutions);
  if (place < 0) return;
  const Eigen::Index samples = grid_.samples_per_revolution;
  for (std::size_t i = 0; i < states_.size(); ++i) cycle_[i].middleCols(place * samples, samples) = states_[i];
}

Eigen::VectorXd Recording::revolution() {
  const int steps = march_.steps_per_revolution() / grid_.samples_per_revolution;
  const int first_sample = done_ * grid_.samples_per_revolution;
  const Eigen::Index size = march_.displacement().size();
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(grid_.samples_per_revolution * size);
  for (int sample = 0; sample < grid_.samples_per_revolution; ++sample) {
    take_states(sample);
    for (int i = 0; i < steps; ++i) {
      motion.segment(sample * size, size) += march_.displacement();
      chatter_.observe(march_.displacement());
      march_.step();
      observe(first_sample + sample);
    }
    compare_force(sample, first_sample + sample);
  }
  recover_displacements(first_sample);
  keep_cycle();
  ++done_;
  motion /= steps;
  chatter_.add_revolution(motion);
  return motion;
}

double Recording::normal_amplitude() const {
  double largest = 0;
  for (Eigen::Index point = 0; point < kept_.contact_force.cols(); ++point) {
    const Eigen::VectorXd motion = kept_.displacement.middleCols<3>(3 * point) *
                                   march_.scene().tips.normal.row(point % march_.node_count()).transpose();
    largest = std::max(largest, 0.5 * (motion.maxCoeff() - motion.minCoeff()));
  }
  return largest;
}

RecordedMotion Recording::finish() {
  RotorSnapshot& snapshot = kept_.snapshot.emplace();
  snapshot.sample = hardest_sample_;
  snapshot.force = march_.symmetry() * kept_.contact_force.row(hardest_sample_).cwiseAbs().sum();
  for (std::size_t i = 0; i < hardest_.size(); ++i)
    snapshot.displacement.emplace_back(march_.rotor().waves[i].shapes * hardest_[i]);
  if (grid_.cycle_revolutions > 0) {
    RotorCycle& cycle = kept_.cycle.emplace();
    cycle.first_sample = (grid_.revolutions - grid_.cycle_revolutions) * grid_.samples_per_revolution;
    for (std::size_t i = 0; i < cycle_.size(); ++i)
      cycle.displacement.emplace_back(march_.rotor().waves[i].shapes * cycle_[i]);
  }
  kept_.amplitude = normal_amplitude();
  kept_.energy = audit_.ledger(march_);
  kept_.friction = friction_load();
  const ChatterAudit::Share chatter = chatter_.share();
  kept_.chatter = chatter.share;
  kept_.chatter_node = chatter.node;
  kept_.left_out_energy = audit_.left_out_share();
  if (pulling_ > 0) kept_.tension_share = pulling_ / (pulling_ + pushing_);
  return std::move(kept_);
}

}  // namespace tiprub::simulate
