// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/sweep_record.h"

#include "postprocess/records/columns.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

Cell amplitude_cell(const std::optional<SweptSpeed>& swept) {
  return swept ? Cell(swept->amplitude * mm_per_m) : Cell(std::string());
}

std::string swept_motion(const std::optional<SweptSpeed>& swept) {
  return swept ? motion_text(swept->motion, swept->period_beats) : std::string();
}

Cell difference_cell(const std::optional<SweptSpeed>& swept) {
  return swept ? Cell(swept->difference) : Cell(std::string());
}

}  // namespace

Table sweep_record(const Study& study) {
  Table table{{"speed [rpm]", "from rest [mm]", "up [mm]", "down [mm]", "motion from rest", "motion up",
               "motion down", "up from rest [1]", "down from rest [1]", "differ"},
              {}};
  for (const SweepComparison& compared : study.sweeps) {
    const SpeedResponse& from_rest = study.response.speeds[static_cast<std::size_t>(compared.index)];
    table.rows.push_back({from_rest.speed * rpm_per_rad_s, study.amplitudes.largest[compared.index] * mm_per_m,
                          amplitude_cell(compared.up), amplitude_cell(compared.down),
                          motion_text(from_rest.motion, from_rest.period_beats), swept_motion(compared.up),
                          swept_motion(compared.down), difference_cell(compared.up), difference_cell(compared.down),
                          yes_or_no(compared.differs())});
  }
  return table;
}

}  // namespace tiprub
