// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/wheels/sector_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tiprub::mesh {

namespace {

constexpr int most_elements = 400;  // in each direction; a sector with more doesn't fit in memory
constexpr double steepest_grading = 100.0;

int count(CaseTable& table, const char* key, int fallback, int least) {
  return table.integer(key, fallback, Range::between(least, most_elements), "elements");
}

double grading(CaseTable& table, const char* key) {
  return table.number(key, 1.0, Range::between(1.0, steepest_grading), "largest element over smallest");
}

void read_chord(CaseTable& table, SectorPlan& plan, int fewest) {
  plan.elements.chord = count(table, "elements_along_chord", 12, fewest);
  plan.grading_along_chord = grading(table, "grading_along_chord");
}

void read_blade(CaseTable& table, SectorPlan& plan) {
  plan.elements.blade = count(table, "elements_through_blade", 3, 2);
  plan.elements.span = count(table, "elements_along_span", 8, 1);
  plan.grading_along_span = grading(table, "grading_along_span");
}

// The number of elements up to the boundary between two that is nearest to the splitter's leading edge.
int elements_upstream(const SectorPlan& plan) {
  const int count_along = plan.elements.chord;
  const auto distance = [&](int element) {
    return std::abs(0.5 * graded(2 * element, count_along, plan.grading_along_chord) -
                    plan.splitter_start * count_along);
  };
  int nearest = 1;
  for (int element = 2; element < count_along; ++element)
    if (distance(element) <= distance(nearest)) nearest = element;
  return nearest;
}

void read_element(CaseTable& table, SectorPlan& plan) {
  plan.element =
      table.choice("element", ElementKind::hex20, {{ElementKind::hex20, "hex20"}, {ElementKind::hex27, "hex27"}});
}

// Half a passage lies on either side of the sector's cuts.
void check_passages(CaseTable& table, const SectorPlan& plan) {
  if (plan.blades != Blades::none && plan.elements.between_blades % 2 != 0)
    table.reject("elements_between_blades", "= " + std::to_string(plan.elements.between_blades) +
                                                " must be even, because the sector is cut in mid-passage; add one");
}

}  // namespace

double graded(int half_index, int count, double ratio) {
  const double growth = std::pow(ratio, 1.0 / std::max(1, (count - 1) / 2));
  double all = 0.0, before = 0.0;
  for (int element = 0; element < count; ++element) {
    const double size = std::pow(growth, std::min(element, count - 1 - element));
    all += size;
    before += size * std::clamp(0.5 * half_index - element, 0.0, 1.0);
  }
  return 2.0 * count * before / all;
}

double SectorPlan::pitch() const {
  return 2.0 * std::numbers::pi / sector_count;
}

double SectorPlan::station(int half_index) const {
  const double at = graded(half_index, elements.chord, grading_along_chord);
  if (blades != Blades::main_and_splitter) return 0.5 * at / elements.chord;
  const double before = graded(2 * elements.upstream, elements.chord, grading_along_chord);
  if (at <= before) return splitter_start * at / before;
  return splitter_start + (1.0 - splitter_start) * (at - before) / (2 * elements.chord - before);
}

double SectorPlan::span(int half_index, double fillet_end) const {
  const int below = 2 * elements.fillet, above = elements.span - elements.fillet;
  if (half_index < below) return fillet_end * half_index / below;
  return fillet_end + 0.5 * (1.0 - fillet_end) * graded(half_index - below, above, grading_along_span) / above;
}

double SectorPlan::splitter_chord(double station_fraction) const {
  return std::max(0.0, (station_fraction - splitter_start) / (1.0 - splitter_start));
}

void read_common(CaseTable& table, SectorPlan& plan, int fewest_along_chord) {
  ElementCounts& elements = plan.elements;
  read_element(table, plan);
  plan.clamped = table.choice("clamped", ClampedSurface::bore,
                              {{ClampedSurface::bore, "bore"},
                               {ClampedSurface::front_face, "front_face"},
                               {ClampedSurface::bore_and_front_face, "bore_and_front_face"}});
  read_chord(table, plan, fewest_along_chord);
  elements.disc = count(table, "elements_through_disc", 3, 1);
  elements.between_blades = count(table, "elements_between_blades", 4, 1);
  elements.bore = elements.chord;
  if (plan.blades != Blades::none) read_blade(table, plan);
  if (plan.blades == Blades::main_and_splitter) {
    elements.splitter = count(table, "elements_through_splitter", elements.blade, 2);
    elements.upstream = elements_upstream(plan);
  }
  check_passages(table, plan);
}

void read_common_of_blade(CaseTable& table, SectorPlan& plan) {
  read_element(table, plan);
  plan.clamped = ClampedSurface::root;
  plan.elements = {};
  read_chord(table, plan, 1);
  read_blade(table, plan);
}

}  // namespace tiprub::mesh
