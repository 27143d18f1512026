// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/field_record.h"

#include <numbers>

#include "postprocess/tables/units.h"

namespace tiprub {

Table stress_peak_record(const FieldStudy& fields) {
  Table table{{"speed [rpm]", "largest displacement of the vibration [mm]", "von Mises, vibration [MPa]",
               "von Mises, spin [MPa]", "von Mises, both [MPa]", "at sector", "at sample", "r [mm]", "theta [deg]",
               "z [mm]", "part"},
              {}};
  for (const FieldPeak& peak : fields.peaks)
    table.rows.push_back({peak.speed * rpm_per_rad_s, peak.displacement * mm_per_m, peak.body.vibration * mpa_per_pa,
                          peak.body.spin * mpa_per_pa, peak.body.both * mpa_per_pa, peak.sector, peak.sample,
                          peak.place[0] * mm_per_m, peak.place[1] * 180 / std::numbers::pi, peak.place[2] * mm_per_m,
                          peak.part});
  return table;
}

Table mode_record(const FieldStudy& fields) {
  Table table{{"nodal diameter", "family", "frequency [Hz]", "speed [rpm]"}, {}};
  for (const auto& [part, cells] : fields.sector.parts) table.header.push_back("share of " + part + " [1]");
  for (const ModeShares& mode : fields.modes.shares) {
    table.rows.push_back({mode.nodal_diameter, mode.family + 1, mode.frequency, fields.speed * rpm_per_rad_s});
    for (const auto& [part, share] : mode.share) table.rows.back().emplace_back(share);
  }
  return table;
}

}  // namespace tiprub
