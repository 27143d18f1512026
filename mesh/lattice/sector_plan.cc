// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/lattice/sector_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tiprub {

namespace {

constexpr int most_elements = 400;  // a direction; beyond it no computer of ours holds the sector

int count(CaseTable& table, const char* key, int fallback, int least) {
  return table.integer(key, fallback, Range::between(least, most_elements), "elements");
}

void read_blade_counts(CaseTable& table, ElementCounts& elements) {
  elements.blade = count(table, "elements_through_blade", 3, 2);
  elements.span = count(table, "elements_along_span", 8, 1);
}

void read_element(CaseTable& table, SectorPlan& plan) {
  plan.element = table.choice<ElementKind>("element", ElementKind::hex20,
                                           {{"hex20", ElementKind::hex20}, {"hex27", ElementKind::hex27}});
}

// Half a passage lies on either side of the sector's cuts.
void check_passages(CaseTable& table, const SectorPlan& plan) {
  if (plan.blades != Blades::none && plan.elements.between_blades % 2 != 0)
    table.reject("elements_between_blades", "= " + std::to_string(plan.elements.between_blades) +
                                                " must be even, because the sector is cut in mid-passage; add one");
}

}  // namespace

double SectorPlan::pitch() const {
  return 2.0 * std::numbers::pi / sector_count;
}

double SectorPlan::station(int half_index) const {
  if (blades != Blades::main_and_splitter) return 0.5 * half_index / elements.chord;
  const int before = 2 * elements.upstream;
  if (half_index <= before) return splitter_start * half_index / before;
  return splitter_start + (1.0 - splitter_start) * (half_index - before) / (2 * elements.chord - before);
}

double SectorPlan::splitter_chord(double station_fraction) const {
  return std::max(0.0, (station_fraction - splitter_start) / (1.0 - splitter_start));
}

void read_common(CaseTable& table, SectorPlan& plan, int fewest_along_chord) {
  ElementCounts& elements = plan.elements;
  read_element(table, plan);
  plan.clamped = table.choice<ClampedSurface>("clamped", ClampedSurface::bore,
                                              {{"bore", ClampedSurface::bore},
                                               {"front_face", ClampedSurface::front_face},
                                               {"bore_and_front_face", ClampedSurface::bore_and_front_face}});
  elements.chord = count(table, "elements_along_chord", 12, fewest_along_chord);
  elements.disc = count(table, "elements_through_disc", 3, 1);
  elements.between_blades = count(table, "elements_between_blades", 4, 1);
  elements.bore = elements.chord;
  if (plan.blades != Blades::none) read_blade_counts(table, elements);
  if (plan.blades == Blades::main_and_splitter) {
    elements.splitter = count(table, "elements_through_splitter", elements.blade, 2);
    elements.upstream = std::clamp(static_cast<int>(std::lround(plan.splitter_start * elements.chord)), 1,
                                   std::max(1, elements.chord - 1));
  }
  check_passages(table, plan);
}

void read_common_of_blade(CaseTable& table, SectorPlan& plan) {
  read_element(table, plan);
  plan.clamped = ClampedSurface::root;
  plan.elements = {};
  plan.elements.chord = count(table, "elements_along_chord", 12, 1);
  read_blade_counts(table, plan.elements);
}

}  // namespace tiprub
