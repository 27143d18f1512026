// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/modal_waves.h"

#include <algorithm>
#include <complex>

#include "simulate/march/wave_kernels.h"

namespace tiprub::simulate {

namespace {

Eigen::ArrayXd padded(const Eigen::ArrayXd& values, Eigen::Index size, double padding) {
  Eigen::ArrayXd longer = Eigen::ArrayXd::Constant(size, padding);
  longer.head(values.size()) = values;
  return longer;
}

/// Arranges Y or S in the order of wave_kernels.h; a standing wave has no imaginary part.
kernels::Lines lay_out_shapes(const Eigen::MatrixXcd& rows, Eigen::Index modes, WaveKind kind) {
  const std::size_t parts = kind == WaveKind::travelling ? 2 : 1, block = kernels::mode_block;
  const auto nodes = static_cast<std::size_t>(rows.rows());
  kernels::Lines shapes(parts * nodes * modes);
  for (std::size_t m = 0; m < static_cast<std::size_t>(rows.cols()); ++m)
    for (std::size_t k = 0; k < nodes; ++k) {
      const std::complex<double> value = rows(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(m));
      const std::size_t offset = ((m / block * nodes + k) * parts) * block + m % block;
      shapes[offset] = value.real();
      if (parts == 2) shapes[offset + block] = value.imag();
    }
  return shapes;
}

/// The same in the order of to_rows, with `width` rows.
kernels::Lines lay_out_by_mode(const Eigen::MatrixXcd& rows, std::size_t width, WaveKind kind) {
  const std::size_t parts = kind == WaveKind::travelling ? 2 : 1;
  kernels::Lines shapes(parts * width * static_cast<std::size_t>(rows.cols()));
  for (Eigen::Index m = 0; m < rows.cols(); ++m)
    for (Eigen::Index k = 0; k < rows.rows(); ++k) {
      const std::size_t place = static_cast<std::size_t>(m) * parts * width + static_cast<std::size_t>(k);
      shapes[place] = rows(k, m).real();
      if (parts == 2) shapes[place + width] = rows(k, m).imag();
    }
  return shapes;
}

MarchedWave marched(const WaveModes& from, const SchemeOptions& scheme, double step, int sector_count) {
  const Eigen::Index modes = kernels::rounded_up(from.omega.size(), kernels::mode_block);
  MarchedWave wave;
  wave.nodal_diameter = from.nodal_diameter;
  wave.kind = from.kind;
  wave.weight = wave_count(from.nodal_diameter, sector_count);
  wave.omega = padded(from.omega, modes, 0);
  wave.moving = kernels::rounded_up(from.moving, kernels::mode_block);
  const StepCoefficients unpadded = step_coefficients(scheme, from.omega, from.damping_ratio, step, from.moving);
  wave.coefficients = {padded(unpadded.r, modes, 1), padded(unpadded.k, modes, 1), padded(unpadded.c, modes, 0)};
  return wave;
}

}  // namespace

Eigen::VectorXcd ModalCoordinates::head(Eigen::Index count) const {
  Eigen::VectorXcd values(count);
  values.real() = real.head(count).matrix();
  values.imag() = imaginary.head(count).matrix();
  return values;
}

ModalWaves::ModalWaves(const RotorAtSpeed& rotor, const SchemeOptions& scheme, double time_step, const Nodes& nodes,
                       const Needs& needs)
    : nodes_(nodes) {
  normal_.count = static_cast<std::size_t>(nodes_.nodes);
  normal_.width = nodes_.width;
  if (needs.friction) {
    sliding_.count = 2 * normal_.count;
    sliding_.width = 2 * normal_.width;
  }
  blades_.count = needs.coordinates;
  blades_.width = kernels::rounded_up(needs.coordinates, kernels::lane_count);
  for (std::size_t row = 0; row < blades_.count; ++row) blades_.forced.push_back(static_cast<int>(row));
  for (const WaveModes& wave : rotor.waves) {
    waves_.push_back(marched(wave, scheme, time_step, nodes_.sector_count));
    if (needs.friction || needs.coordinates > 0)
      waves_.back().sliding = kernels::rounded_up(wave.sliding_rows.cols(), kernels::mode_block);
    memory_.push_back(lay_out(wave, waves_.back()));
  }
  for (int j = 0; j < nodes_.sectors; ++j)
    for (const Memory& memory : memory_)
      phases_of_sectors_.insert(phases_of_sectors_.end(), {memory.cosine[j], memory.sine[j]});
  for (Directions* directions : {&normal_, &sliding_, &blades_})
    directions->p = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * waves_.size() * directions->width));
}

ModalWaves::Memory ModalWaves::lay_out(const WaveModes& from, const MarchedWave& wave) const {
  Memory memory;
  memory.q = memory.increment = memory.increment_before = memory.jump = Eigen::VectorXd::Zero(2 * wave.modes());
  memory.normal.forces = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(normal_.width));
  memory.sliding.forces = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(sliding_.width));
  memory.blades.forces = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(blades_.width));
  memory.cosine.resize(nodes_.sectors);
  memory.sine.resize(nodes_.sectors);
  for (int j = 0; j < nodes_.sectors; ++j) {
    const std::complex<double> phase = sector_phase(wave.nodal_diameter, j, nodes_.sector_count);
    memory.cosine[j] = phase.real();
    memory.sine[j] = phase.imag();
  }
  memory.normal.shapes = lay_out_shapes(from.normal_rows, wave.modes(), wave.kind);
  const auto lay_out_few = [&](Rows& rows, const Eigen::MatrixXcd& values, const Directions& directions) {
    if (directions.count == 0) return;
    rows.shapes = lay_out_shapes(values, wave.sliding, wave.kind);
    rows.by_mode = lay_out_by_mode(values, directions.width, wave.kind);
    rows.modes = static_cast<std::size_t>(values.cols());
  };
  lay_out_few(memory.sliding, from.sliding_rows, sliding_);
  lay_out_few(memory.blades, from.blade_rows, blades_);
  return memory;
}

ModalCoordinates ModalWaves::view(std::size_t wave, Eigen::VectorXd Memory::*parts) const {
  settle_forces();
  const double* values = (memory_[wave].*parts).data();
  const Eigen::Index modes = waves_[wave].modes();
  return {{values, modes}, {values + modes, modes}};
}

Eigen::VectorXcd ModalWaves::forces(std::size_t wave) const {
  Eigen::VectorXcd forces(nodes_.nodes);
  const Eigen::VectorXd& parts = memory_[wave].normal.forces;
  forces.real() = parts.head(nodes_.nodes);
  forces.imag() = parts.segment(static_cast<Eigen::Index>(nodes_.width), nodes_.nodes);
  return forces;
}

Eigen::MatrixXd ModalWaves::compliance(const RotorAtSpeed& rotor, const RowsOf& moved, const RowsOf& pushed) const {
  const auto height = static_cast<Eigen::Index>(moved.width), breadth = static_cast<Eigen::Index>(pushed.width);
  Eigen::MatrixXd compliance = Eigen::MatrixXd::Zero(nodes_.sectors * height, nodes_.sectors * breadth);
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    const Eigen::MatrixXcd &moves = rotor.waves[i].*moved.rows, &pushes = rotor.waves[i].*pushed.rows;
    const Eigen::Index modes = std::min(moves.cols(), pushes.cols());
    // eq. 15: C_N^T [M_r/h^2 + D_r/(2h)]^-1 C_N in modes, for the scheme's own c
    const Eigen::MatrixXcd moved_by =
        moves.leftCols(modes) * waves_[i].coefficients.c.head(modes).matrix().asDiagonal();
    Eigen::MatrixXcd own = moved_by * pushes.leftCols(modes).adjoint();
    own *= waves_[i].weight * nodes_.symmetry / nodes_.sector_count;
    for (int row = 0; row < nodes_.sectors; ++row)
      for (int column = 0; column < nodes_.sectors; ++column) {
        const int apart = (row - column + nodes_.sector_count) % nodes_.sector_count;
        compliance.block(row * height, column * breadth, own.rows(), own.cols()) +=
            (own * sector_phase(waves_[i].nodal_diameter, apart, nodes_.sector_count)).real();
      }
  }
  return compliance;
}

Eigen::MatrixXd ModalWaves::compliance(const RotorAtSpeed& rotor) const {
  const RowsOf along_normals{&WaveModes::normal_rows, normal_.width};
  const Eigen::MatrixXd compliance = this->compliance(rotor, along_normals, along_normals);
  const Eigen::MatrixXd transposed = compliance.transpose();
  return 0.5 * (compliance + transposed);
}

ContactCompliance::Responses ModalWaves::responses(const RotorAtSpeed& rotor, const Eigen::VectorXd& friction) const {
  const RowsOf normal{&WaveModes::normal_rows, normal_.width}, sliding{&WaveModes::sliding_rows, sliding_.width},
      blades{&WaveModes::blade_rows, blades_.width};
  const auto stacked = [](const Eigen::MatrixXd& above, const Eigen::MatrixXd& below) {
    Eigen::MatrixXd both(above.rows() + below.rows(), above.cols());
    both << above, below;
    return both;
  };
  ContactCompliance::Responses responses{compliance(rotor), {}, {}, {}, nodes_.sectors};
  responses.friction = Eigen::VectorXd::Zero(responses.normal.cols());
  for (int j = 0; j < nodes_.sectors && friction.size() > 0; ++j)
    responses.friction.segment(j * static_cast<Eigen::Index>(normal_.width), nodes_.nodes) =
        friction.size() == 1 ? Eigen::VectorXd::Constant(nodes_.nodes, friction[0]) : friction;
  if (sliding_.count > 0) responses.sliding = compliance(rotor, normal, sliding);
  if (blades_.count == 0) return responses;
  responses.normal = stacked(responses.normal, compliance(rotor, blades, normal));
  if (sliding_.count > 0) responses.sliding = stacked(responses.sliding, compliance(rotor, blades, sliding));
  responses.blades = stacked(compliance(rotor, normal, blades), compliance(rotor, blades, blades));
  return responses;
}

std::vector<Recoil> ModalWaves::recoils(const RotorAtSpeed& rotor, int symmetry) const {
  Eigen::ArrayX3d sums = Eigen::ArrayX3d::Zero(static_cast<Eigen::Index>(nodes_.width), 3);  // of c, r c, k c
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    if (waves_[i].nodal_diameter % symmetry != 0) continue;
    const Eigen::MatrixXd square = rotor.waves[i].normal_rows.cwiseAbs2() * waves_[i].weight;
    const auto& [r, k, c] = waves_[i].coefficients;
    Eigen::MatrixX3d of_modes(c.size(), 3);
    of_modes << c.matrix(), (r * c).matrix(), (k * c).matrix();
    sums.topRows(nodes_.nodes) += (square * of_modes.topRows(square.cols())).array();
  }
  std::vector<Recoil> recoils;
  for (const auto& sum : sums.rowwise())
    recoils.push_back(sum[0] > 0 ? Recoil(sum[1] / sum[0], sum[2] / sum[0]) : Recoil(0, 0));
  return recoils;
}

void ModalWaves::set_state(std::size_t wave, const Eigen::VectorXcd& q, const Eigen::VectorXcd& increment) {
  settle_forces();
  Memory& memory = memory_[wave];
  const Eigen::Index modes = waves_[wave].modes();
  memory.q.head(q.size()) = q.real();
  memory.q.segment(modes, q.size()) = q.imag();
  memory.increment.head(q.size()) = increment.real();
  memory.increment.segment(modes, q.size()) = increment.imag();
}

void ModalWaves::map_to_sectors(TipMotion& motion, TipMotion& before) {
  settle_forces();
  for (std::size_t i = 0; i < waves_.size(); ++i) map_to_tips(i, memory_[i].q - memory_[i].increment);
  add_sectors(before);
  for (std::size_t i = 0; i < waves_.size(); ++i) map_to_tips(i, memory_[i].q);
  add_sectors(motion);
}

void ModalWaves::slide(Eigen::VectorXd& displacement) {
  for (std::size_t i = 0; i < waves_.size(); ++i)
    map_to_rows(i, memory_[i].sliding, memory_[i].increment_before, sliding_);
  add_sectors(sliding_, displacement);
}

void ModalWaves::map_to_tips(std::size_t index, const Eigen::VectorXd& q) {
  const MarchedWave& wave = waves_[index];
  const auto moving = static_cast<std::size_t>(wave.moving);
  const double* shapes = memory_[index].normal.shapes.data();
  double* p = normal_.p.data() + 2 * index * normal_.width;
  if (wave.kind == WaveKind::travelling)
    kernels::to_nodes_travelling(shapes, q.data(), q.data() + wave.modes(), moving, normal_.count, p,
                                 p + normal_.width);
  else
    kernels::to_nodes_standing(shapes, q.data(), moving, normal_.count, p);
  if (blades_.count > 0) map_to_rows(index, memory_[index].blades, q, blades_);
}

void ModalWaves::map_to_rows(std::size_t index, const Rows& rows, const Eigen::VectorXd& q, Directions& directions) {
  const MarchedWave& wave = waves_[index];
  double* p = directions.p.data() + 2 * index * directions.width;
  if (wave.kind == WaveKind::travelling)
    kernels::to_rows_travelling(rows.by_mode.data(), q.data(), q.data() + wave.modes(), rows.modes, directions.width,
                                p, p + directions.width);
  else
    kernels::to_rows_standing(rows.by_mode.data(), q.data(), rows.modes, directions.width, p);
}

void ModalWaves::add_sectors(const Directions& directions, Eigen::VectorXd& displacement) const {
  for (int j = 0; j < nodes_.sectors; ++j)
    kernels::add_waves(directions.p.data(), phases_of_sectors_.data() + 2 * waves_.size() * j, waves_.size(),
                       directions.width, displacement.data() + j * directions.width);
}

void ModalWaves::add_sectors(TipMotion& motion) const {
  add_sectors(normal_, motion.normal);
  if (blades_.count > 0) add_sectors(blades_, motion.blades);
}

void ModalWaves::advance_modes(std::size_t index) {
  const MarchedWave& wave = waves_[index];
  Memory& memory = memory_[index];
  const auto modes = static_cast<std::size_t>(wave.modes()), moving = static_cast<std::size_t>(wave.moving);
  memory.increment_before.swap(memory.increment);
  for (std::size_t part = 0; part < (wave.kind == WaveKind::travelling ? 2 : 1); ++part)  // eq. 13
    kernels::advance(wave.coefficients.r.data(), wave.coefficients.k.data(),
                     memory.increment_before.data() + part * modes, memory.q.data() + part * modes,
                     memory.increment.data() + part * modes, moving);
  if (moving == modes) return;
  for (const Eigen::Index first : {wave.moving, wave.modes() + wave.moving}) {
    auto massless = memory.q.segment(first, wave.modes() - wave.moving);
    memory.increment.segment(first, massless.size()) = -massless;
    massless.setZero();
  }
}

void ModalWaves::look_ahead(TipMotion& motion) {
  settle_forces();
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    const auto& [r, k, c] = waves_[i].coefficients;
    Memory& memory = memory_[i];
    ahead_ = memory.q;
    for (Eigen::Index part = 0; part < 2; ++part)
      kernels::advance(r.data(), k.data(), memory.increment.data() + part * r.size(), ahead_.data() + part * r.size(),
                       memory.jump.data() + part * r.size(), static_cast<std::size_t>(r.size()));
    map_to_tips(i, ahead_);
  }
  add_sectors(motion);
}

void ModalWaves::advance(TipMotion& motion) {
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    if (forces_wait_) add_waiting_forces(i);
    advance_modes(i);
    map_to_tips(i, memory_[i].q);
  }
  forces_wait_ = false;
  add_sectors(motion);
}

/// eq. 15 in modes: the effect of lambda on the displacements, u+ = u+,p + [M_r/h^2 + D_r/(2h)]^-1 C_N lambda.
void ModalWaves::take_forces(std::size_t index, Eigen::VectorXd& other) const {
  const MarchedWave& wave = waves_[index];
  take_forces(index, memory_[index].normal, normal_, wave.modes(), other);
  if (sliding_.count > 0) take_forces(index, memory_[index].sliding, sliding_, wave.sliding, other);
  if (blades_.count > 0) take_forces(index, memory_[index].blades, blades_, wave.sliding, other);
}

void ModalWaves::take_forces(std::size_t index, const Rows& rows, const Directions& directions, Eigen::Index modes,
                             Eigen::VectorXd& other) const {
  const MarchedWave& wave = waves_[index];
  const auto pushed = static_cast<std::size_t>(modes), all = static_cast<std::size_t>(wave.modes());
  const kernels::ForcedNodes forced{directions.forced.data(), directions.forced.size(), directions.count};
  const kernels::Modes real{other.data(), memory_[index].increment.data()};
  if (wave.kind == WaveKind::travelling)
    kernels::add_force_travelling(rows.shapes.data(), wave.coefficients.c.data(), rows.forces.data(),
                                  rows.forces.data() + directions.width, forced, pushed, real,
                                  {real.q + all, real.increment + all});
  else
    kernels::add_force_standing(rows.shapes.data(), wave.coefficients.c.data(), rows.forces.data(), forced, pushed,
                                real);
}

void ModalWaves::settle_forces() const {
  if (!forces_wait_) return;
  for (std::size_t i = 0; i < waves_.size(); ++i) add_waiting_forces(i);
  forces_wait_ = false;
}

void ModalWaves::add_forces(const Forces& forces) {
  settle_forces();
  gather(forces);
  forces_wait_ = true;
}

void ModalWaves::add_impulses(const Forces& impulses) {
  settle_forces();
  gather(impulses);
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    memory_[i].jump.setZero();
    take_forces(i, memory_[i].jump);
  }
}

void ModalWaves::gather(const Forces& forces) {
  const auto width = static_cast<int>(nodes_.width);
  forced_sectors_.clear();
  normal_.forced.clear();
  sliding_.forced.clear();
  node_has_force_.assign(nodes_.width, 0);
  for (int index : forces.nodes) {
    const int sector = index / width;
    if (forced_sectors_.empty() || forced_sectors_.back() != sector) forced_sectors_.push_back(sector);
    node_has_force_[index - sector * width] = 1;
  }
  for (int k = 0; k < nodes_.nodes; ++k) {
    if (!node_has_force_[k]) continue;
    normal_.forced.push_back(k);
    sliding_.forced.insert(sliding_.forced.end(), {2 * k, 2 * k + 1});
  }
  gather(forces.normal, normal_, &Memory::normal);
  if (sliding_.count > 0) gather(forces.drag, sliding_, &Memory::sliding);
  if (blades_.count > 0) gather(forces.blades, blades_, &Memory::blades);
}

void ModalWaves::gather(const Eigen::VectorXd& forces, const Directions& directions, Rows Memory::*rows) {
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    Memory& memory = memory_[i];
    Eigen::VectorXd& gathered = (memory.*rows).forces;
    kernels::gather_sectors(forces.data(), memory.cosine.data(), memory.sine.data(), forced_sectors_.data(),
                            forced_sectors_.size(), directions.width, gathered.data(),
                            gathered.data() + directions.width);
    gathered *= waves_[i].weight * nodes_.symmetry / nodes_.sector_count;
  }
}

}  // namespace tiprub::simulate
