// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/wheels/wheel.h"

#include <algorithm>
#include <sstream>

#include "mesh/wheels/blade_file.h"
#include "mesh/wheels/bladed_disc.h"
#include "mesh/wheels/impeller.h"
#include "mesh/wheels/root_fillet.h"

namespace tiprub {

namespace {

enum class Family { impeller, bladed_disc, blade_file };

constexpr int fewest_sectors = 3;  // so that a sector and its two neighbours are different sectors
constexpr int most_sectors = 1000;

// The blades are checked without their fillets first, so that a fillet is at fault if they cross only with it.
const char* key_of_width(const CaseTable& table, const SectorPlan& plan, double span) {
  if (plan.elements.fillet > 0) return "fillet_radius";
  if (table.has("blade_file")) return "blade_file";
  return span == 0.0 ? "thickness_root" : "thickness_tip";
}

[[noreturn]] void refuse_width(const CaseTable& table, const char* key, double station, double width, double room) {
  std::ostringstream text;
  text << "makes blades cross: at " << station << " of the meridional length they take " << width
       << " rad of the circle, and have " << room
       << " rad; make the blade or its fillet thinner, or its angle smaller";
  table.reject(key, text.str());
}

// At the hub the columns of a splitter also exist upstream of it.
bool splitter_is_at(const SectorPlan& plan, double station, double span) {
  return plan.blades == Blades::main_and_splitter && (span == 0.0 || station >= plan.splitter_start);
}

// Neighbours must not meet in the narrower of the two passages; at the hub neither may reach the sector's cut, which
// halves the passage behind the splitter.
void check_widths_at(const CaseTable& table, const Wheel& wheel, double station, double span) {
  const SectorPlan& plan = wheel.plan;
  const bool has_splitter = splitter_is_at(plan, station, span);
  const double main = wheel.geometry->half_width(BladeKind::main, station, span);
  const double neighbour = has_splitter ? wheel.geometry->half_width(BladeKind::splitter, station, span) : main;
  const double passage = has_splitter ? 1.0 - plan.splitter_pitch : 1.0;
  const double narrower = has_splitter ? std::min(plan.splitter_pitch, passage) : 1.0;
  if (main + neighbour >= narrower * plan.pitch())
    refuse_width(table, key_of_width(table, plan, span), station, main + neighbour, narrower * plan.pitch());
  const double to_cut = 0.5 * passage * plan.pitch();
  if (span == 0.0 && std::max(main, neighbour) >= to_cut)
    refuse_width(table, key_of_width(table, plan, span), station, std::max(main, neighbour), to_cut);
}

void check_widths(const CaseTable& table, const Wheel& wheel) {
  for (int half = 0; half <= 2 * wheel.plan.elements.chord; ++half)
    for (double span : {0.0, 1.0}) check_widths_at(table, wheel, wheel.plan.station(half), span);
}

// The key is also read for a wheel without splitters, so that the message can say what is wrong.
void read_contact_blades(CaseTable& table, SectorPlan& plan) {
  const bool has_splitter = plan.blades == Blades::main_and_splitter;
  if (!has_splitter && !table.has("contact_blades")) return;
  plan.contact_blades = table.choice<ContactBlades>("contact_blades", ContactBlades::main,
                                                    {{"main", ContactBlades::main}, {"both", ContactBlades::both}});
  if (plan.contact_blades == ContactBlades::both && !has_splitter)
    table.reject("contact_blades",
                 "= \"both\" asks for contact on splitters, and this wheel has none; take \"main\"");
}

}  // namespace

Wheel read_wheel(CaseTable& table) {
  Wheel wheel;
  const Family family = table.choice<Family>(
      "family", std::nullopt,
      {{"impeller", Family::impeller}, {"bladed_disc", Family::bladed_disc}, {"blade_file", Family::blade_file}});
  wheel.plan.sector_count =
      table.integer("blade_count", std::nullopt, Range::between(fewest_sectors, most_sectors), "sectors");
  if (family == Family::impeller) {
    const ImpellerParameters parameters = read_impeller(table, wheel.plan);
    wheel.geometry = make_impeller(parameters, wheel.plan);
  } else if (family == Family::bladed_disc) {
    wheel.geometry = make_bladed_disc(read_bladed_disc(table, wheel.plan));
  } else {
    wheel.geometry = read_wheel_of_blade_file(table, wheel.plan);
  }
  read_contact_blades(table, wheel.plan);
  if (wheel.plan.blades != Blades::none) {
    check_widths(table, wheel);
    if (wheel.plan.has_disc()) wheel.geometry = read_root_fillet(table, wheel.plan, std::move(wheel.geometry));
    check_widths(table, wheel);
  }
  table.close();
  return wheel;
}

}  // namespace tiprub
