// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/time_march.h"

#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "cases/program/text.h"
#include "simulate/march/wave_kernels.h"
#include "simulate/motion/attempt.h"

namespace tiprub::simulate {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// Of the blades of a sector; 0 if the gap is linear.
std::size_t blade_coordinates(const MarchedScene& scene) {
  if (scene.setup.gap != GapOrder::second_order) return 0;
  return static_cast<std::size_t>(scene.tips.second_order->coordinates.cols());
}

}  // namespace

TimeMarch::TimeMarch(MarchedScene scene)
    : scene_(std::move(scene)),
      sector_count_(rotor().sector_count),
      sectors_(sector_count_ / symmetry()),
      node_count_(scene_.tips.size()),
      width_(kernels::rounded_up(static_cast<std::size_t>(node_count_), kernels::lane_count)),
      time_step_(two_pi / rotor().speed / steps_per_revolution()),
      waves_(rotor(), {scene_.setup.scheme, scene_.setup.theta}, time_step_,
             {sector_count_, sectors_, symmetry(), node_count_, width_},
             {has_friction(), blade_coordinates(scene_)}) {
  const auto size = static_cast<Eigen::Index>(sectors_ * width_);
  gap_ = gap_before_ = gap_two_before_ = gap_ahead_ =
      Eigen::VectorXd::Constant(size, std::numeric_limits<double>::infinity());
  blade_forces_ = Eigen::VectorXd::Zero(
      sectors_ * static_cast<Eigen::Index>(kernels::rounded_up(blade_coordinates(scene_), kernels::lane_count)));
  for (TipMotion& motion : motion_) motion = {Eigen::VectorXd::Zero(size), blade_forces_};
  tabulate_obstacle();
  prepare_contact();
  contact_ = contact_law(scene_.setup, of_step_);
  if (finds_impacts(scene_.setup.scheme, scene_.setup.contact))
    inner_.emplace(of_step_, waves_.recoils(rotor(), std::gcd(sector_count_, scene_.obstacle.lobes())));
  impulses_ = Eigen::VectorXd::Zero(size);
  motion_ahead_ = motion_[0];
  measure_both();
}

void TimeMarch::tabulate_obstacle() {
  const Obstacle& obstacle = scene_.obstacle;
  clearance_ = gap_;
  for (int j = 0; j < sectors_; ++j)
    clearance_.segment(j * static_cast<Eigen::Index>(width_), node_count_) = obstacle.clearance(j);
  phases_ = steps_per_revolution() / obstacle.lobes();
  distortion_.assign(phases_ * width_, 0.0);
  for (std::int64_t phase = 0; phase < phases_; ++phase)
    for (int k = 0; k < node_count_; ++k)
      distortion_[phase * width_ + k] =
          obstacle.distortion(k, two_pi * static_cast<double>(phase) / steps_per_revolution());
  if (blade_coordinates(scene_) > 0) second_order_.emplace(scene_.tips, obstacle, steps_per_revolution(), width_);
}

void TimeMarch::prepare_contact() {
  of_step_ = std::make_shared<ContactCompliance>(waves_.responses(rotor(), scene_.setup.friction));
  compliance_ = of_step_->responses().normal.topRows(gap_.size());
  if (!has_friction()) return;
  carried_ = slide_ = drag_ = Eigen::VectorXd::Zero(2 * gap_.size());
  for (Eigen::Index i = 0; i < gap_.size(); ++i)
    if (const Eigen::Index k = i % static_cast<Eigen::Index>(width_); k < node_count_)
      carried_[2 * i] = scene_.tips.position(k, 0) * two_pi / steps_per_revolution();
}

void TimeMarch::set_states(const std::vector<ModalState>& waves, std::size_t first_wave) {
  for (std::size_t i = 0; i < waves.size(); ++i) waves_.set_state(first_wave + i, waves[i].q, waves[i].increment);
  waves_.map_to_sectors(motion_[0], motion_[1]);
  measure_both();
}

void TimeMarch::set_step(std::int64_t step) {
  step_ = step;
  measure_both();
}

void TimeMarch::measure_both() {
  measure_gaps(step_ - 1, motion_[1], gap_before_);
  measure_gaps(step_, motion_[0], gap_);
}

SecondOrderTerms::Place TimeMarch::casing_over(int sector, std::int64_t step) const {
  const std::int64_t turned = static_cast<std::int64_t>(sector) * (steps_per_revolution() / sector_count_);
  return {(step + phases_ + turned) % phases_,
          scene_.obstacle.grown(static_cast<double>(step) / steps_per_revolution())};
}

bool TimeMarch::measure_gaps(std::int64_t step, const TipMotion& motion, Eigen::VectorXd& gap) const {
  bool penetrates = false;
  for (int j = 0; j < sectors_; ++j) {
    const SecondOrderTerms::Place place = casing_over(j, step);
    double* const own = gap.data() + j * width_;
    const bool in_first_order =
        kernels::gap_of_sector(clearance_.data() + j * width_, distortion_.data() + place.phase * width_, place.grown,
                               motion.normal.data() + j * width_, width_, own);
    penetrates |=
        second_order_ ? second_order_->narrow(motion.blades.data() + j * blade_width(), place, own) : in_first_order;
  }
  return penetrates;
}

bool TimeMarch::predict() {
  std::swap(motion_[2], motion_[1]);
  std::swap(motion_[1], motion_[0]);
  gap_two_before_.swap(gap_before_);
  gap_before_.swap(gap_);
  waves_.advance(motion_[0]);  // eq. 13: the predicted displacements
  ++step_;
  return measure_gaps(step_, motion_[0], gap_);  // eq. 14: g^p
}

void TimeMarch::correct(const Eigen::VectorXd& forces, const std::vector<int>& nodes, const TurnedForces& more) {
  push(forces, nodes, more, motion_[0], gap_, 1);
  waves_.add_forces({forces, drag_, blade_forces_, nodes});
}

void TimeMarch::jump(const Eigen::VectorXd& impulses, const std::vector<int>& nodes, const TurnedForces& more) {
  push(impulses, nodes, more, motion_[1], gap_before_, -1);
  waves_.add_impulses({impulses, drag_, blade_forces_, nodes});
}

void TimeMarch::push(const Eigen::VectorXd& forces, const std::vector<int>& nodes, const TurnedForces& more,
                     TipMotion& motion, Eigen::VectorXd& gap, double direction) {
  move(motion, forces, nodes, direction);
  of_step_->open(direction, forces, nodes, gap);
  drag_of(forces, nodes);
  blade_forces(forces, nodes);
  if (more.drag.size() + more.blades.size() == 0) return;
  drag_ += more.drag;
  blade_forces_ += more.blades;
  const Eigen::VectorXd taken = of_step_->response(more.drag, more.blades);
  motion.normal -= direction * taken.head(gap_.size());
  motion.blades -= direction * taken.tail(motion.blades.size());
  gap += direction * opened_by(more);
}

Eigen::VectorXd TimeMarch::opened_by(const TurnedForces& more) const {
  if (more.drag.size() + more.blades.size() == 0) return Eigen::VectorXd::Zero(gap_.size());
  const Eigen::VectorXd taken = of_step_->response(more.drag, more.blades);
  Eigen::VectorXd opened = taken.head(gap_.size());
  if (!second_order_) return opened;
  opened += more.gaps;
  for (int j = 0; j < sectors_; ++j)
    opened.segment(j * width(), width()) += of_step_->slopes().middleRows(j * width(), width()) *
                                            taken.segment(gap_.size() + j * blade_width(), blade_width());
  return opened;
}

Eigen::MatrixXd TimeMarch::compliance(const std::vector<int>& nodes) {
  const auto size = static_cast<Eigen::Index>(nodes.size()), stride = static_cast<Eigen::Index>(of_step_->stride());
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(stride, size);
  of_step_->block(nodes, columns.data());
  Eigen::MatrixXd block = columns.topRows(size);
  if (!has_friction()) block = block.selfadjointView<Eigen::Lower>();
  return block;
}

Eigen::VectorXd TimeMarch::blade_response(const Eigen::VectorXd& forces, const std::vector<int>& nodes) {
  of_step_->respond(forces, nodes);
  return of_step_->blade_response();
}

void TimeMarch::move(TipMotion& motion, const Eigen::VectorXd& forces, const std::vector<int>& nodes,
                     double direction) {
  if (!second_order_) {
    of_step_->open(-direction, forces, nodes, motion.normal);
    return;
  }
  of_step_->respond(forces, nodes);
  motion.normal -= direction * of_step_->normal_response();
  motion.blades -= direction * of_step_->blade_response();
}

const Eigen::VectorXd& TimeMarch::slide() {
  waves_.slide(slide_);
  return slide_;
}

void TimeMarch::turn() {
  if (has_friction()) {
    slide();
    slide_ += carried_;
    slide_along(slide_);
  }
  if (second_order_) find_slopes(motion_[1].blades, step_ - 1, of_step_->tilt());
}

void TimeMarch::find_slopes(const Eigen::VectorXd& blades, std::int64_t step, Eigen::MatrixXd& slopes) const {
  for (int j = 0; j < sectors_; ++j)
    second_order_->slopes(blades.data() + j * blade_width(), casing_over(j, step), slopes.data() + j * width_,
                          static_cast<std::size_t>(slopes.rows()));
}

Eigen::MatrixXd TimeMarch::slopes(const Eigen::VectorXd& blades, std::int64_t step) const {
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(gap_.size(), blade_width());
  find_slopes(blades, step, slopes);
  return slopes;
}

void TimeMarch::require_sliding() const {
  if (!has_friction()) return;
  for (const int i : contact_->closed()) {
    const bool rubs = drag_ratio()[2 * i] != 0 || drag_ratio()[2 * i + 1] != 0;
    if (!rubs || slide_[2 * i] * carried_[2 * i] > 0) continue;
    throw NoMotion(
        text_of("contact node ", i % width(), " (from 0) of sector ", i / width(),
                " no longer slides forward: its velocity over the casing along the circumference is ",
                slide_[2 * i] / time_step_, " m/s after ", static_cast<double>(step_) / steps_per_revolution(),
                " revolutions, and friction is modelled for tips that slide; raise the speed, or set [casing] "
                "friction_coefficient = 0"));
  }
}

const Eigen::VectorXd& TimeMarch::drag_of(const Eigen::VectorXd& forces, const std::vector<int>& nodes) {
  if (!has_friction()) return drag_;
  drag_.setZero();
  for (const int i : nodes) drag_.segment<2>(2 * i) = forces[i] * drag_ratio().segment<2>(2 * i);
  return drag_;
}

const Eigen::VectorXd& TimeMarch::blade_forces(const Eigen::VectorXd& forces, const std::vector<int>& nodes) {
  if (!second_order_) return blade_forces_;
  blade_forces_.setZero();
  const Eigen::MatrixXd& slopes = of_step_->slopes();
  for (const int i : nodes)
    blade_forces_.segment(i / width() * slopes.cols(), slopes.cols()) += forces[i] * slopes.row(i).transpose();
  return blade_forces_;
}

double TimeMarch::contact_work() const {
  double work = 0;
  for (const int i : contact_->closed()) {
    double way = motion_[0].normal[i] - motion_[2].normal[i];
    if (second_order_) {
      const Eigen::MatrixXd& slopes = of_step_->slopes();
      const Eigen::Index first = i / width() * slopes.cols();
      way += slopes.row(i).dot((motion_[0].blades - motion_[2].blades).segment(first, slopes.cols()));
    }
    work -= contact_->multipliers()[i] * way / 2;
  }
  return work;
}

const std::vector<InnerImpact>& TimeMarch::impacts() const {
  static const std::vector<InnerImpact> none;
  return inner_ ? inner_->all() : none;
}

const Eigen::VectorXd& TimeMarch::look_ahead() {
  waves_.look_ahead(motion_ahead_);
  measure_gaps(step_ + 1, motion_ahead_, gap_ahead_);
  return gap_ahead_;
}

void TimeMarch::aim(double direction) {
  for (const InnerImpact& impact : impacts()) gap_[impact.node()] += direction * impact.target();
}

void TimeMarch::step() {
  const bool penetrates = predict();
  if (inner_) inner_->clear();
  if (inner_ && penetrates && inner_->foresee(gaps())) inner_->find(gaps(), look_ahead());
  if (!of_step_->is_constant() && (penetrates || traits_of(scene_.setup.scheme).has_memory)) turn();
  aim(-1);
  const bool has_force =
      contact_->step(gap_before_, gap_, penetrates);  // eq. 14, eq. 15: lambda that closes the gaps
  aim(1);
  if (!has_force) return;
  const Eigen::VectorXd& forces = contact_->multipliers();
  if (second_order_)
    move(motion_[0], forces, contact_->closed(), 1);
  else
    motion_[0].normal -= contact_->correction();  // eq. 15: the corrected displacements
  require_sliding();
  waves_.add_forces(
      {forces, drag_of(forces, contact_->closed()), blade_forces(forces, contact_->closed()), contact_->closed()});
  if (!impacts().empty()) strike();
}

void TimeMarch::strike() {
  inner_->push(contact_->multipliers());
  for (const int index : struck_) impulses_[index] = 0;
  struck_.clear();
  for (const InnerImpact& impact : impacts()) {
    struck_.push_back(impact.node());
    impulses_[impact.node()] = impact.impulse;
  }
  jump(impulses_, struck_);
}

}  // namespace tiprub::simulate
