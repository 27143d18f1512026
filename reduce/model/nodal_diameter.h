// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <cstdint>
#include <numbers>

namespace tiprub {

/// Whether a nodal diameter's waves travel (complex, one each way round the wheel) or stand (real, one).
enum class WaveKind { travelling, standing };

/// Nodal diameter n, of either sign, on N sectors: e^{i n alpha} is real for n = 0 and n = N/2 only.
constexpr WaveKind wave_kind(int nodal_diameter, int sector_count) {
  return nodal_diameter == 0 || 2 * nodal_diameter == sector_count || -2 * nodal_diameter == sector_count
             ? WaveKind::standing
             : WaveKind::travelling;
}

constexpr bool is_standing(int nodal_diameter, int sector_count) {
  return wave_kind(nodal_diameter, sector_count) == WaveKind::standing;
}

/// The number of modes of a nodal diameter in each modal family of the wheel: a travelling wave counts twice.
constexpr int wave_count(int nodal_diameter, int sector_count) {
  return is_standing(nodal_diameter, sector_count) ? 1 : 2;
}

/// e^{i n j alpha}, alpha = 2 pi / N: the factor by which a wave of nodal diameter n on sector j is that on sector 0.
/// The angle is reduced in whole numbers, so that equal sectors are equal to the last bit.
inline std::complex<double> sector_phase(int nodal_diameter, int sector, int sector_count) {
  const auto turn = static_cast<double>(std::int64_t{nodal_diameter} * sector % sector_count);
  return std::polar(1.0, 2 * std::numbers::pi * turn / sector_count);
}

}  // namespace tiprub
