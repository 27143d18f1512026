// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/periodic/symmetric_map.h"

#include <cstdint>
#include <numeric>

#include "reduce/model/nodal_diameter.h"
#include "simulate/scene/scene_scope.h"

namespace tiprub {

SymmetricMap::SymmetricMap(TimeMarch& march, int power)
    : march_(march), energy_state_(march, 0, EnergyState::StandingWaves::real) {
  const int sectors = march.sector_count(), lobes = march.scene().obstacle.lobes();
  steps_ = power * (march.steps_per_revolution() / std::lcm(sectors, lobes));
  const std::int64_t shift = std::int64_t{power} * sector_shift(sectors, lobes) % sectors;
  for (std::size_t i = 0; i < march.wave_count(); ++i)
    phases_.push_back(std::conj(sector_phase(march.wave(i).nodal_diameter, static_cast<int>(shift), sectors)));
}

}  // namespace tiprub
