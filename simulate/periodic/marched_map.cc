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
  if (orbit.tips.second_order) {  // TangentMarch adds its slopes
    orbit.tips.second_order->curvature.setZero();
    for (Eigen::MatrixXd& displacement : orbit.tips.second_order->displacement) displacement.setZero();
  }
  orbit.obstacle = orbit.obstacle.touching();
  return orbit;
}

/// How the nodes slid in the last step of a march, which had contact.
Sliding sliding_of(const TimeMarch& march) {
  const Eigen::Index nodes = march.gap().size();
  Sliding sliding{march.way(), Eigen::VectorXd::Zero(nodes), Eigen::VectorXd::Zero(nodes)};
  const auto over_way = [&](int i, double force) {
    return force * march.drag_ratio().segment<2>(2 * i).norm() / march.way().segment<2>(2 * i).norm();
  };
  for (const int i : march.contact().closed()) sliding.turning[i] = over_way(i, march.contact().multipliers()[i]);
  for (const InnerImpact& impact : march.impacts())
    sliding.striking[impact.node()] = over_way(impact.node(), impact.impulse);
  return sliding;
}

/// The blades in the last step of a march, which began with the coordinates `start`.
BladeStep blades_of(TimeMarch& march, Eigen::VectorXd start) {
  BladeStep blades;
  blades.start = std::move(start);
  blades.free = march.blades();
  if (march.contact().closed().empty()) return blades;
  blades.forces = march.contact().multipliers();
  blades.taken = march.blade_response(blades.forces, march.contact().closed());
  blades.free += blades.taken;
  if (march.impacts().empty()) return blades;
  blades.ahead = march.blades_ahead();
  blades.impulses = march.impulses();
  std::vector<int> struck;
  for (const InnerImpact& impact : march.impacts()) struck.push_back(impact.node());
  blades.taken_by_impulses = march.blade_response(blades.impulses, struck);
  return blades;
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
    : orbit_(orbit),
      march_(disturbed(orbit.scene(), disturbance)),
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
  pattern_ = pattern;
  closed_.clear();
  factors_.clear();
  turning_factors_.clear();
  for (const std::vector<int>& set : pattern->sets) {
    closed_.push_back(on_all_sectors(set));
    if (turns()) continue;
    Eigen::MatrixXd block = compliance_(closed_.back(), closed_.back());
    block.diagonal() *= 1 + diagonal_shift;
    factors_.emplace_back(block);
    if (factors_.back().info() != Eigen::Success)
      throw NoMotion("the contact compliance of " + std::to_string(set.size()) +
                     " closed nodes is not positive definite: no orbit can be followed with them");
  }
  for (std::size_t step = 0; turns() && step < pattern->steps.size(); ++step) {
    if (pattern->steps[step] == ContactPattern::open) continue;
    direct(step, turning_factors_.size());
    turning_factors_.push_back(factor_of(closed_[static_cast<std::size_t>(pattern->steps[step])]));
  }
}

void TangentMarch::direct(std::size_t step, std::size_t contact) {
  if (march_.has_friction()) {
    way_ = pattern_->sliding[contact].way.replicate(copies_, 1);
    march_.slide_along(way_);
  }
  if (march_.is_curved())
    march_.tilt(orbit_.slopes(pattern_->blades[step].start, pattern_->first_step + static_cast<std::int64_t>(step))
                    .replicate(copies_, 1));
}

Eigen::PartialPivLU<Eigen::MatrixXd> TangentMarch::factor_of(const std::vector<int>& nodes) {
  Eigen::MatrixXd block = march_.compliance(nodes);
  block += compliance_(nodes, nodes) - march_.compliance()(nodes, nodes);
  block.diagonal() *= 1 + diagonal_shift;
  Eigen::PartialPivLU<Eigen::MatrixXd> factor(block);
  if (!(std::abs(factor.matrixLU().diagonal().cwiseAbs().minCoeff()) > diagonal_shift * block.cwiseAbs().maxCoeff()))
    throw NoMotion("the contact compliance of " + std::to_string(nodes.size()) +
                   " closed nodes whose forces turn is singular: no orbit can be followed with them");
  return factor;
}

Eigen::VectorXd TangentMarch::narrowed(const Eigen::VectorXd& y, const Eigen::VectorXd& blades,
                                       std::int64_t step) const {
  const Eigen::MatrixXd slopes = orbit_.slopes(y, step);
  const Eigen::Index sectors = march_.sectors(), width = march_.width(), coordinates = slopes.cols();
  Eigen::VectorXd narrowed(sectors * width);
  for (Eigen::Index j = 0; j < sectors; ++j)
    narrowed.segment(j * width, width) =
        slopes.middleRows(j * width % nodes_a_copy_, width) * blades.segment(j * coordinates, coordinates);
  return narrowed;
}

void TangentMarch::narrow_start() {
  const Eigen::VectorXd before = march_.gaps().now, now = march_.gap();
  march_.set_gaps(before - narrowed(pattern_->blades_before, march_.blades_before(), pattern_->first_step - 1),
                  now - narrowed(pattern_->blades.front().start, march_.blades(), pattern_->first_step));
}

void TangentMarch::narrow(std::size_t step) {
  const std::int64_t next = pattern_->first_step + static_cast<std::int64_t>(step) + 1;
  const Eigen::VectorXd before = march_.gaps().now, now = march_.gap();
  march_.set_gaps(before, now - narrowed(pattern_->blades[step].free, march_.blades(), next));
}

void TangentMarch::turn_slopes(std::size_t step) {
  const std::int64_t at = pattern_->first_step + static_cast<std::int64_t>(step);
  const Eigen::VectorXd changes = march_.blades_before();
  const Eigen::Index blades_a_copy = changes.size() / copies_;
  const Eigen::MatrixXd unturned = orbit_.slopes(Eigen::VectorXd::Zero(blades_a_copy), at);
  turned_slopes_.resize(unturned.rows() * copies_, unturned.cols());
  for (int copy = 0; copy < copies_; ++copy)
    turned_slopes_.middleRows(copy * unturned.rows(), unturned.rows()) =
        orbit_.slopes(changes.segment(copy * blades_a_copy, blades_a_copy), at) - unturned;
}

TurnedForces TangentMarch::turned(const Eigen::VectorXd& over_way, const Eigen::VectorXd& forces,
                                  const Eigen::VectorXd& taken) const {
  TurnedForces turned;
  if (march_.has_friction()) turned.drag = Eigen::VectorXd::Zero(way_.size());
  for (Eigen::Index i = 0; 2 * i < turned.drag.size(); ++i) {
    const Eigen::Vector2d along = way_.segment<2>(2 * i).normalized(), across(-along[1], along[0]);
    turned.drag.segment<2>(2 * i) = over_way[i % nodes_a_copy_] * across.dot(slide_.segment<2>(2 * i)) * across;
  }
  if (!march_.is_curved()) return turned;
  const Eigen::Index coordinates = turned_slopes_.cols();
  turned.blades = Eigen::VectorXd::Zero(march_.blades().size());
  turned.gaps.resize(turned_slopes_.rows());
  for (Eigen::Index i = 0; i < turned.gaps.size(); ++i) {
    const Eigen::Index sector = i / march_.width(), in_copy = i % nodes_a_copy_ / march_.width();
    turned.blades.segment(sector * coordinates, coordinates) +=
        forces[i % nodes_a_copy_] * turned_slopes_.row(i).transpose();
    turned.gaps[i] = turned_slopes_.row(i).dot(taken.segment(in_copy * coordinates, coordinates));
  }
  return turned;
}

std::vector<InnerImpact::Change> TangentMarch::changes(std::size_t step, const std::vector<InnerImpact>& impacts) {
  std::vector<InnerImpact::Change> changes;
  if (impacts.empty()) return changes;
  const auto [before, now, next] = march_.gaps();
  Eigen::VectorXd ahead = march_.look_ahead();
  if (march_.is_curved())
    ahead -= narrowed(pattern_->blades[step].ahead, march_.blades_ahead(),
                      pattern_->first_step + static_cast<std::int64_t>(step) + 2);
  for (int copy = 0; copy < copies_; ++copy)
    for (const InnerImpact& impact : impacts) {
      const int i = copy * nodes_a_copy_ + impact.node();
      changes.push_back(impact.change({before[i], now[i], next[i], ahead[i]}));
    }
  return changes;
}

void TangentMarch::close(std::size_t step, std::size_t contact, const std::vector<InnerImpact>& impacts) {
  static const Sliding no_sliding;
  static const BladeStep no_blades;
  const auto set = static_cast<std::size_t>(pattern_->steps[step]);
  const std::vector<int>& closed = closed_[set];
  const Sliding& sliding = march_.has_friction() ? pattern_->sliding[contact] : no_sliding;
  const BladeStep& blades = march_.is_curved() ? pattern_->blades[step] : no_blades;
  if (march_.has_friction()) slide_ = march_.slide();
  if (march_.is_curved()) turn_slopes(step);
  direct(step, contact);
  const TurnedForces more = turned(sliding.turning, blades.forces, blades.taken);
  const std::vector<InnerImpact::Change> changed = changes(step, impacts);
  target_.setZero();
  for (std::size_t i = 0; i < changed.size(); ++i)
    target_[static_cast<int>(i / impacts.size()) * nodes_a_copy_ + impacts[i % impacts.size()].node()] =
        changed[i].target;
  of_set_ = (target_ - march_.gap() - march_.opened_by(more))(closed);
  if (turns())
    of_set_ = turning_factors_[contact].solve(of_set_).eval();
  else
    factors_[set].solveInPlace(of_set_);
  forces_.setZero();
  forces_(closed) = of_set_;
  march_.correct(forces_, closed, more);
  if (!impacts.empty()) strike(impacts, changed, turned(sliding.striking, blades.impulses, blades.taken_by_impulses));
}

/// Nodes without an impulse have been pushed off by their neighbours' and keep none.
void TangentMarch::strike(const std::vector<InnerImpact>& impacts, const std::vector<InnerImpact::Change>& changes,
                          const TurnedForces& more) {
  std::vector<int> nodes;
  std::vector<double> jumps;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const InnerImpact& impact = impacts[i % impacts.size()];
    if (!(impact.impulse > 0)) continue;
    nodes.push_back(static_cast<int>(i / impacts.size()) * nodes_a_copy_ + impact.node());
    jumps.push_back(changes[i].jump);
  }
  const Eigen::Map<const Eigen::VectorXd> jump(jumps.data(), static_cast<Eigen::Index>(jumps.size()));
  if (turns()) {
    of_set_ = factor_of(nodes).solve(jump - march_.opened_by(more)(nodes));
  } else {
    Eigen::MatrixXd block = compliance_(nodes, nodes);
    block.diagonal() *= 1 + diagonal_shift;
    of_set_ = block.llt().solve(jump);
  }
  forces_.setZero();
  forces_(nodes) = of_set_;
  march_.jump(forces_, nodes, more);
}

Eigen::VectorXd TangentMarch::operator()(const std::shared_ptr<const ContactPattern>& pattern,
                                         const Eigen::VectorXd& change) {
  hold(pattern);
  const std::int64_t start = march_.step_count();
  map_.put(change);
  if (march_.is_curved()) narrow_start();
  static const std::vector<InnerImpact> none;
  auto next = pattern_->impacts.begin();
  std::size_t contact = 0;
  for (std::size_t i = 0; i < pattern_->steps.size(); ++i) {
    march_.predict();
    if (march_.is_curved()) narrow(i);
    if (pattern_->steps[i] == ContactPattern::open) continue;
    const bool struck = next != pattern_->impacts.end() && next->first == i;
    close(i, contact++, struck ? (next++)->second : none);
  }
  Eigen::VectorXd changed = map_.image();
  march_.set_step(start);
  return changed;
}

Eigen::VectorXd TangentMarch::in_free_flight(const Eigen::VectorXd& change) {
  const std::int64_t start = march_.step_count();
  map_.put(change);
  for (int i = 0; i < map_.steps(); ++i) march_.predict();
  Eigen::VectorXd changed = map_.image();
  march_.set_step(start);
  return changed;
}

MarchedMap::MarchedMap(TimeMarch& march, int power)
    : march_(march), map_(march, power), tangent_(march, Disturbance::symmetric, power) {
  const auto has_mass = [](const WaveModes& wave) { return wave.moving == wave.omega.size(); };
  all_have_mass_ = std::ranges::all_of(march.rotor().waves, has_mass);
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
  pattern->first_step = start;
  pattern->blades_before = march_.blades_before();
  for (int i = 0; i < map_.steps(); ++i) {
    Eigen::VectorXd blades = march_.blades();
    march_.step();
    pattern->add(march_.contact().closed(), march_.impacts());
    if (march_.is_curved()) pattern->blades.push_back(blades_of(march_, std::move(blades)));
    if (march_.has_friction() && !march_.contact().closed().empty()) pattern->sliding.push_back(sliding_of(march_));
  }
  MapImage image{map_.image(), std::move(pattern)};
  march_.set_step(start);
  return image;
}

Eigen::VectorXd MarchedMap::tangent(const std::shared_ptr<const ContactPattern>& pattern,
                                    const Eigen::VectorXd& change) {
  ++tangents_;
  return tangent_(pattern, change);
}

/// The modes do not couple: a flight from unit positions of all modes and one from unit velocities tell all.
void MarchedMap::invert_free_flight() {
  const StateLayout& layout = map_.layout();
  Eigen::VectorXd at_one(layout.size()), moving(layout.size());
  for (std::size_t i = 0; i < march_.wave_count(); ++i) {
    const Eigen::VectorXcd none = Eigen::VectorXcd::Zero(march_.wave(i).moving);
    Eigen::VectorXcd ones = none;
    ones.head(march_.rotor().waves[i].moving).setOnes();  // what follows is padding, which never moves
    layout.write({ones, none}, i, at_one);
    layout.write({none, ones}, i, moving);
  }
  const Eigen::VectorXd from_position = tangent_.in_free_flight(at_one),
                        from_velocity = tangent_.in_free_flight(moving);
  for (std::size_t i = 0; i < march_.wave_count(); ++i) {
    const auto [a, c] = layout.read(from_position, i);
    const auto [b, d] = layout.read(from_velocity, i);
    const Eigen::ArrayXcd kept = 1 - a.array(), other = 1 - d.array();
    const Eigen::ArrayXcd determinant = kept * other - b.array() * c.array();
    free_.push_back({other / determinant, b.array() / determinant, c.array() / determinant, kept / determinant});
  }
}

Eigen::VectorXd MarchedMap::precondition(const Eigen::VectorXd& change) {
  if (free_.empty()) invert_free_flight();
  const StateLayout& layout = map_.layout();
  Eigen::VectorXd solved(change.size());
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const auto [position, velocity] = layout.read(change, i);
    const auto& [pp, pv, vp, vv] = free_[i];
    const Eigen::VectorXcd to_position = pp * position.array() + pv * velocity.array();
    layout.write({to_position, vp * position.array() + vv * velocity.array()}, i, solved);
  }
  return solved;
}

}  // namespace tiprub::simulate
