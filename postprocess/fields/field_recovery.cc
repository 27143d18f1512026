// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/field_recovery.h"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "cases/program/machine.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub::postprocess {

namespace {

double sector_angle(int sectors, int sector_count) {
  return 2 * std::numbers::pi * sectors / sector_count;
}

Eigen::Matrix3d rotation(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

/// `stress`: summed over the cells of this sector.
void average(const SectorFields& sector, const CellStress& bricks, int nodal_diameter, ComplexTensors& stress) {
  const double alpha = sector_angle(1, sector.sector_count);
  const std::complex<double> next = sector_phase(nodal_diameter, 1, sector.sector_count);
  Eigen::VectorXd count = bricks.cells_at_node().cast<double>();
  const std::vector<int>&low = sector.node_set("cyclic_low"), &high = sector.node_set("cyclic_high");
  for (std::size_t k = 0; k < low.size(); ++k) {
    if (low[k] == high[k]) continue;  // on the axis
    const ComplexTensors both =       // in the frame of the low face
        stress.col(low[k]) + std::conj(next) * turned(ComplexTensors(stress.col(high[k])), -alpha);
    stress.col(low[k]) = both;
    stress.col(high[k]) = next * turned(both, alpha);
    count[low[k]] = count[high[k]] = count[low[k]] + count[high[k]];
  }
  stress *= count.cwiseInverse().asDiagonal();
}

}  // namespace

Eigen::Matrix3Xcd cartesian(const SectorFields& sector, const Eigen::VectorXcd& cylindrical) {
  Eigen::Matrix3Xcd displacement(3, sector.nodes.cols());
  for (Eigen::Index node = 0; node < sector.nodes.cols(); ++node) {
    const double x = sector.nodes(0, node), y = sector.nodes(1, node), r = std::sqrt(x * x + y * y);
    const double cosine = r > 0 ? x / r : 1.0, sine = r > 0 ? y / r : 0.0;
    const auto moved = cylindrical.segment<3>(3 * node);
    displacement.col(node) << cosine * moved[0] - sine * moved[1], sine * moved[0] + cosine * moved[1], moved[2];
  }
  return displacement;
}

void add_stress(const SectorFields& sector, const CellStress& bricks, std::span<WaveField> waves) {
  work_on_pieces(std::ssize(waves), 2, 0, [&](std::ptrdiff_t first, std::ptrdiff_t count) {
    const std::span<WaveField> both = waves.subspan(first, count);
    std::array<ComplexTensors, 2> stress = bricks.sums(both.front().displacement, both.back().displacement);
    for (std::size_t k = 0; k < both.size(); ++k) {
      average(sector, bricks, both[k].nodal_diameter, stress[k]);
      both[k].stress = std::move(stress[k]);
    }
  });
}

WaveField spin_field(const SectorFields& sector, const CellStress& bricks, double speed) {
  const Eigen::Matrix3Xd moved = sector.static_displacement(speed);
  WaveField wave{0, cartesian(sector, moved.reshaped().cast<std::complex<double>>()), {}};
  add_stress(sector, bricks, {&wave, 1});
  return wave;
}

SectorField on_sector(const std::vector<WaveField>& waves, int j, int sector_count) {
  const Eigen::Index nodes = waves.front().displacement.cols();
  const bool stressed = waves.front().stress.cols() > 0;
  SectorField sector{Eigen::Matrix3Xd::Zero(3, nodes), Tensors::Zero(6, stressed ? nodes : 0)};
  for (const WaveField& wave : waves) {
    const std::complex<double> here = sector_phase(wave.nodal_diameter, j, sector_count);
    sector.displacement += here.real() * wave.displacement.real() - here.imag() * wave.displacement.imag();
    if (stressed) sector.stress += here.real() * wave.stress.real() - here.imag() * wave.stress.imag();
  }
  return sector;
}

WheelField on_wheel(const std::vector<WaveField>& waves, int sector_count) {
  WheelField wheel;
  for (int j = 0; j < sector_count; ++j) {
    const double angle = sector_angle(j, sector_count);
    const SectorField sector = on_sector(waves, j, sector_count);
    wheel.displacement.emplace_back(rotation(angle) * sector.displacement);
    wheel.stress.push_back(turned(sector.stress, angle));
  }
  return wheel;
}

Eigen::Matrix3Xd nodes_of_sector(const SectorFields& sector, int j) {
  return rotation(sector_angle(j, sector.sector_count)) * sector.nodes;
}

double outer_radius(const SectorFields& sector) {
  return sector.nodes.topRows<2>().colwise().norm().maxCoeff();
}

}  // namespace tiprub::postprocess
