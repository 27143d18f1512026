// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/periodic/marched_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "reduce/model/nodal_diameter.h"
#include "simulate/motion/attempt.h"
#include "simulate/scene/scene.h"

namespace tiprub::simulate {

namespace {

constexpr double diagonal_shift = 1e-12;  // of W's diagonal, as in ContactImpulses

/// The scene of the disturbances of an orbit, with a casing that all tips touch.
MarchedScene disturbed(MarchedScene orbit, Disturbance disturbance) {
  const auto rotor = std::make_shared<RotorAtSpeed>(*orbit.rotor);
  if (disturbance == Disturbance::excluded) {
    rotor->waves = rotor->others;
    orbit.setup.symmetry = 1;
  }
  rotor->others.clear();
  orbit.rotor = rotor;
  orbit.obstacle = orbit.obstacle.touching();
  return orbit;
}

/// How the nodes slid in the last step of a march, which had contact.
Sliding sliding_of(const TimeMarch& march) {
  const Eigen::Index nodes = march.gap().size();
  Sliding sliding{march.drag_ratio(), Eigen::VectorXd::Zero(nodes), Eigen::VectorXd::Zero(nodes)};
  const auto over_way = [&](int i, double force) {
    return force * march.drag_ratio().segment<2>(2 * i).norm() / march.way().segment<2>(2 * i).norm();
  };
  for (const int i : march.contact().closed()) sliding.turning[i] = over_way(i, march.contact().multipliers()[i]);
  for (const InnerImpact& impact : march.impacts())
    sliding.striking[impact.node()] = over_way(impact.node(), impact.impulse);
  return sliding;
}

}  // namespace

SymmetricMap::SymmetricMap(TimeMarch& march, int power) : march_(march), energy_state_(march) {
  const int sectors = march.sector_count(), lobes = march.scene().obstacle.lobes();
  steps_ = power * (march.steps_per_revolution() / symmetric_maps_per_revolution(sectors, lobes));
  const std::int64_t shift = std::int64_t{power} * sector_shift(sectors, lobes) % sectors;
  for (std::size_t i = 0; i < march.wave_count(); ++i)
    phases_.push_back(std::conj(sector_phase(march.wave(i).nodal_diameter, static_cast<int>(shift), sectors)));
}

TangentMarch::TangentMarch(const TimeMarch& orbit, Disturbance disturbance, int power)
    : march_(disturbed(orbit.scene(), disturbance)),
      map_(march_, power),
      copies_(march_.sectors() / orbit.sectors()),
      nodes_a_copy_(orbit.sectors() * orbit.width()),
      compliance_(march_.compliance()),
      forces_(Eigen::VectorXd::Zero(march_.gap().size())),
      target_(forces_) {
  if (disturbance == Disturbance::symmetric) return;
  // The excluded nodal diameters can't move all copies alike, so that W is singular. A compliance for equal motion of
  // all copies makes it regular; it does not couple to these disturbances.
  const double unit = compliance_.diagonal().maxCoeff() / copies_;
  for (int from = 0; from < copies_; ++from)
    for (int to = 0; to < copies_; ++to)
      compliance_.block(from * nodes_a_copy_, to * nodes_a_copy_, nodes_a_copy_, nodes_a_copy_).diagonal().array() +=
          unit;
}

std::vector<int> TangentMarch::on_all_sectors(const std::vector<int>& nodes) const {
  std::vector<int> all;
  for (int copy = 0; copy < copies_; ++copy)
    for (const int node : nodes) all.push_back(copy * nodes_a_copy_ + node);
  return all;
}

void TangentMarch::hold(const std::shared_ptr<const ContactPattern>& pattern) {
  if (pattern == pattern_) return;
  closed_.clear();
  factors_.clear();
  sliding_factors_.clear();
  for (const std::vector<int>& set : pattern->sets()) {
    closed_.push_back(on_all_sectors(set));
    if (march_.has_friction()) continue;
    Eigen::MatrixXd block = compliance_(closed_.back(), closed_.back());
    block.diagonal() *= 1 + diagonal_shift;
    factors_.emplace_back(block);
    if (factors_.back().info() != Eigen::Success)
      throw NoMotion("the contact compliance of " + std::to_string(set.size()) +
                     " closed nodes is not positive definite: no orbit can be followed with them");
  }
  auto sliding = pattern->sliding().begin();
  for (const int set : pattern->steps())
    if (march_.has_friction() && set != ContactPattern::open)
      sliding_factors_.push_back(
          factor_of(closed_[static_cast<std::size_t>(set)], (sliding++)->drag_ratio.replicate(copies_, 1)));
  pattern_ = pattern;
}

Eigen::PartialPivLU<Eigen::MatrixXd> TangentMarch::factor_of(const std::vector<int>& nodes,
                                                             const Eigen::VectorXd& drag_ratio) {
  Eigen::MatrixXd block = compliance_(nodes, nodes);
  block.diagonal() *= 1 + diagonal_shift;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    block.col(static_cast<Eigen::Index>(i)) +=
        march_.sliding_compliance()(nodes, Eigen::seqN(2 * nodes[i], 2)) * drag_ratio.segment<2>(2 * nodes[i]);
  Eigen::PartialPivLU<Eigen::MatrixXd> factor(block);
  if (!(std::abs(factor.matrixLU().diagonal().cwiseAbs().minCoeff()) > diagonal_shift * block.cwiseAbs().maxCoeff()))
    throw NoMotion("the contact compliance of " + std::to_string(nodes.size()) +
                   " closed nodes with friction is singular: no orbit can be followed with them");
  return factor;
}

Eigen::VectorXd TangentMarch::turned(const Eigen::VectorXd& forces_over_way) const {
  Eigen::VectorXd drag = Eigen::VectorXd::Zero(drag_ratio_.size());
  for (Eigen::Index i = 0; 2 * i < drag_ratio_.size(); ++i) {
    const Eigen::Vector2d along = drag_ratio_.segment<2>(2 * i).normalized(), across(-along[1], along[0]);
    drag.segment<2>(2 * i) = forces_over_way[i % nodes_a_copy_] * across.dot(slide_.segment<2>(2 * i)) * across;
  }
  return drag;
}

Eigen::VectorXd TangentMarch::by_drag(const Eigen::VectorXd& drag, const std::vector<int>& nodes) const {
  return (march_.sliding_compliance() * drag).eval()(nodes);
}

std::vector<InnerImpact::Change> TangentMarch::changes(const std::vector<InnerImpact>& impacts) {
  std::vector<InnerImpact::Change> changes;
  if (impacts.empty()) return changes;
  const auto [before, now, next] = march_.gaps();
  const Eigen::VectorXd& ahead = march_.look_ahead();
  for (int copy = 0; copy < copies_; ++copy)
    for (const InnerImpact& impact : impacts) {
      const int i = copy * nodes_a_copy_ + impact.node();
      changes.push_back(impact.change({before[i], now[i], next[i], ahead[i]}));
    }
  return changes;
}

void TangentMarch::close(std::size_t set, std::size_t place, const std::vector<InnerImpact>& impacts) {
  const std::vector<int>& closed = closed_[set];
  const Sliding* const sliding = march_.has_friction() ? &pattern_->sliding()[place] : nullptr;
  Eigen::VectorXd drag;
  if (sliding != nullptr) {
    slide_ = march_.slide();
    drag_ratio_ = sliding->drag_ratio.replicate(copies_, 1);
    march_.slide_along(drag_ratio_);
    drag = turned(sliding->turning);
  }
  const std::vector<InnerImpact::Change> changed = changes(impacts);
  target_.setZero();
  for (std::size_t i = 0; i < changed.size(); ++i)
    target_[static_cast<int>(i / impacts.size()) * nodes_a_copy_ + impacts[i % impacts.size()].node()] =
        changed[i].target;
  of_set_ = (target_ - march_.gap())(closed);
  if (sliding != nullptr)
    of_set_ = sliding_factors_[place].solve(of_set_ - by_drag(drag, closed)).eval();
  else
    factors_[set].solveInPlace(of_set_);
  forces_.setZero();
  forces_(closed) = of_set_;
  march_.correct(forces_, closed, drag);
  if (!impacts.empty()) strike(impacts, changed, sliding);
}

/// Nodes without an impulse have been pushed off by their neighbours' and keep none.
void TangentMarch::strike(const std::vector<InnerImpact>& impacts, const std::vector<InnerImpact::Change>& changes,
                          const Sliding* sliding) {
  std::vector<int> nodes;
  std::vector<double> jumps;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const InnerImpact& impact = impacts[i % impacts.size()];
    if (!(impact.impulse > 0)) continue;
    nodes.push_back(static_cast<int>(i / impacts.size()) * nodes_a_copy_ + impact.node());
    jumps.push_back(changes[i].jump);
  }
  const Eigen::Map<const Eigen::VectorXd> jump(jumps.data(), static_cast<Eigen::Index>(jumps.size()));
  forces_.setZero();
  if (sliding != nullptr) {
    const Eigen::VectorXd drag = turned(sliding->striking);
    const Eigen::VectorXd impulses = factor_of(nodes, drag_ratio_).solve(jump - by_drag(drag, nodes));
    forces_(nodes) = impulses;
    march_.jump(forces_, nodes, drag);
    return;
  }
  Eigen::MatrixXd block = compliance_(nodes, nodes);
  block.diagonal() *= 1 + diagonal_shift;
  const Eigen::VectorXd impulses = block.llt().solve(jump);
  forces_(nodes) = impulses;
  march_.jump(forces_, nodes);
}

Eigen::VectorXd TangentMarch::operator()(const std::shared_ptr<const ContactPattern>& pattern,
                                         const Eigen::VectorXd& change) {
  hold(pattern);
  const std::int64_t start = march_.step_count();
  map_.put(change);
  static const std::vector<InnerImpact> none;
  auto next = pattern_->impacts().begin();
  std::size_t place = 0;
  for (std::size_t i = 0; i < pattern_->steps().size(); ++i) {
    march_.predict();
    const int set = pattern_->steps()[i];
    if (set == ContactPattern::open) continue;
    const bool struck = next != pattern_->impacts().end() && next->first == i;
    close(static_cast<std::size_t>(set), place++, struck ? (next++)->second : none);
  }
  Eigen::VectorXd changed = map_.image();
  march_.set_step(start);
  return changed;
}

MarchedMap::MarchedMap(TimeMarch& march, int power)
    : march_(march), map_(march, power), tangent_(march, Disturbance::symmetric, power) {
  const auto has_mass = [](const WaveModes& wave) { return wave.moving == wave.omega.size(); };
  all_have_mass_ = std::all_of(march.rotor().waves.begin(), march.rotor().waves.end(), has_mass);
}

void MarchedMap::put(const Eigen::VectorXd& state) {
  map_.put(state);
  if (all_have_mass_) return;
  for (int i = 0; i < march_.steps_per_revolution(); ++i) march_.step();
}

MapImage MarchedMap::image(const Eigen::VectorXd& state) {
  const std::int64_t start = march_.step_count();
  auto pattern = std::make_shared<ContactPattern>();
  map_.put(state);
  for (int i = 0; i < map_.steps(); ++i) {
    march_.step();
    pattern->add(march_.contact().closed(), march_.impacts());
    if (march_.has_friction() && !march_.contact().closed().empty()) pattern->add(sliding_of(march_));
  }
  MapImage image{map_.image(), std::move(pattern)};
  march_.set_step(start);
  return image;
}

Eigen::VectorXd MarchedMap::tangent(const std::shared_ptr<const ContactPattern>& pattern,
                                    const Eigen::VectorXd& change) {
  return tangent_(pattern, change);
}

}  // namespace tiprub::simulate
