// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>

#include "postprocess/figures/axes.h"
#include "postprocess/figures/maps/map_picture.h"
#include "postprocess/figures/study_figures.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

Table map_table(const Study& study, const InteractionMap& map) {
  Table table{{"speed [rpm]", "frequency [Hz]", "engine order", "total [mm]"}, {}};
  for (int n = 0; n <= study.model.nodal_diameter_max(); ++n)
    table.header.push_back("nodal diameter " + std::to_string(n) + " [mm]");
  for (const MapColumn& column : map.columns)
    for (int line = 0; line < column.spectrum.lines(); ++line) {
      const double order = column.spectrum.engine_order(line);
      if (order > study.parameters.engine_order_max) break;
      std::vector<Cell> row = {column.speed * rpm_per_rad_s, order * column.speed * hz_per_rad_s, order,
                               column.total[line] * mm_per_m};
      for (Eigen::Index n = 0; n < column.parts.cols(); ++n) row.emplace_back(column.parts(line, n) * mm_per_m);
      table.rows.push_back(std::move(row));
    }
  return table;
}

/// "node 9, the trailing edge", "node 4 of 0 .. 9".
std::string node_name(const Study& study, int node) {
  const ContactLine& contact = study.model.contact;
  const std::string place = contact.place_of(node);
  return name_of(contact.kind) + (" " + std::to_string(node)) +
         (place.empty() ? " of 0 .. " + std::to_string(contact.size() - 1) : ", the " + place);
}

std::string what_is_drawn(const Study& study, TipEdge edge) {
  return std::string("Amplitude of the ") + name_of(study.parameters.component) + " at the " + name_of(edge) +
         of_main_blade(study) +
         ", the sum over the nodal diameters, rotor frame, logarithmic colours, the same for both edges. The largest "
         "amplitude of all speeds is at " +
         node_name(study, study.amplitudes.node[study.worst]) + ".";
}

/// Where the families of nodal diameter 0 enter the map [Hz], those that do.
ScriptTable family_labels(const Study& study) {
  const double speed = speed_axis(study).low / rpm_per_rad_s;
  std::vector<double> frequencies;
  for (int family = 0; family < drawn_families(study, 0); ++family)
    if (const double frequency = study.curves.frequency(0, family, speed); frequency < map_frequency_high(study))
      frequencies.push_back(frequency);
  return {"family_labels", {as_column(frequencies)}};
}

/// Speeds [rpm] whose motion is of a kind that the paper's assumptions leave out.
ScriptTable speeds_where(const Study& study, const char* name,
                         const std::function<bool(const SpeedResponse&)>& holds) {
  std::vector<double> speeds;
  for (const SpeedResponse& response : study.response.speeds)
    if (holds(response)) speeds.push_back(response.speed * rpm_per_rad_s);
  return {name, {as_column(speeds)}};
}

std::vector<ScriptTable> unusual_motion(const Study& study) {
  return {speeds_where(study, "irregular", [](const SpeedResponse& response) { return !repeats(response.motion); }),
          speeds_where(study, "subharmonic",
                       [](const SpeedResponse& response) { return response.motion == MotionClass::subharmonic; }),
          speeds_where(study, "breaking", [](const SpeedResponse& response) {
            return response.audit.symmetry == SymmetryVerdict::breaking;
          })};
}

}  // namespace

Figure interaction_map_figure(const Study& study, TipEdge edge) {
  const InteractionMap& map = edge == study.parameters.edge ? study.map : study.other_map;
  const std::string where = edge == TipEdge::leading ? "leading" : "trailing";
  constexpr int columns = 700, rows = 480;
  Figure figure{
      .drawing = {.name = "interaction_map_" + where + "_edge",
                  .width = 1000,
                  .height = 640,
                  .script = "interaction_map"},
      .title = "Interaction map, " + where + " edge" + of_main_blade(study),
      .caption = what_is_drawn(study, edge) +
                 " White lines: engine orders f = k\xCE\xA9. Orange lines: natural frequencies of the first "
                 "families, all nodal diameters. Diamonds: the critical speeds. A ridge glows where an engine order "
                 "meets a mode that its nodal "
                 "diameter can drive. Marks at the foot: speeds whose motion is not the same every revolution, or at "
                 "which a nodal diameter that was left out would grow. Grey: speeds without a response.",
      .data = map_table(study, map)};
  set_map_axes(figure.drawing, study);
  figure.drawing.tables.push_back(family_labels(study));
  for (ScriptTable& marks : unusual_motion(study)) figure.drawing.tables.push_back(std::move(marks));
  set_pixels(figure, map_pixels(study, map, columns, rows));
  return figure;
}

}  // namespace tiprub
