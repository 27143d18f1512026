// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/wheel.h"

#include <sstream>

#include "mesh/bladed_disc.h"
#include "mesh/impeller.h"

namespace tiprub {

namespace {

enum class Family { impeller, bladed_disc };

constexpr int fewest_sectors = 3;  // below it a sector and its neighbour on either side are no longer three
constexpr int most_sectors = 1000;
constexpr double sectors_are_cut_in_mid_passage = 0.5;

struct Widths {
  double main;
  double splitter;
};

Widths half_widths(const Wheel& wheel, double station, double span) {
  const bool has_splitter = wheel.plan.blades == Blades::main_and_splitter;
  return {wheel.geometry->half_width(BladeKind::main, station, span),
          has_splitter ? wheel.geometry->half_width(BladeKind::splitter, station, span) : 0.0};
}

[[noreturn]] void refuse_width(const CaseTable& table, const char* key, double station, double width, double room) {
  std::ostringstream text;
  text << "makes blades cross: at " << station << " of the meridional length they take " << width
       << " rad of the circle, and have " << room << " rad; make the blade thinner or its angle smaller";
  table.reject(key, text.str());
}

// The narrowest passage, from mid-blade to mid-blade, and half of the one that the sector's cut halves.
void check_widths(const CaseTable& table, const Wheel& wheel) {
  const SectorPlan& plan = wheel.plan;
  const bool has_splitter = plan.blades == Blades::main_and_splitter;
  const double before_cut = has_splitter ? 1.0 - plan.splitter_pitch : 1.0;
  const double room_to_cut = sectors_are_cut_in_mid_passage * before_cut * plan.pitch();
  const double room = has_splitter ? plan.splitter_pitch * plan.pitch() : plan.pitch();
  for (int half = 0; half <= 2 * plan.elements.chord; ++half) {
    const double station = plan.station(half);
    for (double span : {0.0, 1.0}) {
      const char* key = span == 0.0 ? "thickness_root" : "thickness_tip";
      const Widths widths = half_widths(wheel, station, span);
      const double wider = std::max(widths.main, widths.splitter);
      if (wider >= room_to_cut) refuse_width(table, key, station, wider, room_to_cut);
      if (has_splitter && widths.main + widths.splitter >= room)
        refuse_width(table, key, station, widths.main + widths.splitter, room);
    }
  }
}

}  // namespace

Wheel read_wheel(CaseTable& table) {
  Wheel wheel;
  const Family family = table.choice<Family>("family", std::nullopt,
                                             {{"impeller", Family::impeller}, {"bladed_disc", Family::bladed_disc}});
  wheel.plan.sector_count =
      table.integer("blade_count", std::nullopt, Range::between(fewest_sectors, most_sectors), "sectors");
  if (family == Family::impeller) {
    const ImpellerParameters parameters = read_impeller(table, wheel.plan);
    wheel.geometry = make_impeller(parameters, wheel.plan);
  } else {
    wheel.geometry = make_bladed_disc(read_bladed_disc(table, wheel.plan));
  }
  table.close();
  if (wheel.plan.blades != Blades::none) check_widths(table, wheel);
  return wheel;
}

}  // namespace tiprub
