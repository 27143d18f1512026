// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/motion/sector_signals.h"

#include "postprocess/figures/axes.h"
#include "postprocess/tables/units.h"

namespace tiprub {

SectorSignal motion_of_sectors(const Study& study) {
  return {std::string("The ") + name_of(study.parameters.component) + ", " + name_of(study.parameters.edge) +
              of_main_blade(study),
          "mm",
          tip_motion(study.shown_response(), study.response.scene, study.model.contact, study.map.node,
                     study.parameters.component) *
              mm_per_m};
}

SectorSignal force_of_sectors(const Study& study) {
  return {std::string("The contact force at the ") + name_of(study.parameters.edge) + of_main_blade(study), "N",
          tip_force(study.shown_response(), study.response.scene, study.map.node)};
}

std::string shown_speed_text(const Study& study) {
  return rpm_text(study.shown_response().speed);
}

}  // namespace tiprub
