// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/study_figures.h"

#include "postprocess/figures/maps.h"
#include "postprocess/records/study_records.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

std::vector<Figure> map_figures(const Study& study, const SpeedFrame& frame) {
  const std::string of_blade = of_main_blade(study.model.contact);
  const MapFrame axes = map_frame(frame, study.waves, study.parameters);
  std::vector<Figure> figures;
  for (const TipEdge edge : {study.waves.asked, other_than(study.waves.asked)})
    figures.push_back(interaction_map_figure(frame, axes,
                                             {edge, study.waves.of(edge), name_of(study.parameters.component),
                                              of_blade, largest_place(study.amplitudes, study.model.contact)},
                                             study.response.speeds));
  figures.push_back(interaction_map_parts_figure(frame, axes, study.waves, study.response.scene.nodal_diameters));
  for (const TipEdge edge : {TipEdge::leading, TipEdge::trailing})
    figures.push_back(contact_map_figure(frame, edge, study.contact, of_blade));
  return figures;
}

/// The shown speed, of the contact node whose map comes first.
std::vector<Figure> motion_figures(const Study& study, const SpeedFrame& frame) {
  const SpeedResponse& shown = study.shown_response();
  const SimulatedScene& scene = study.response.scene;
  const ContactLine& contact = study.model.contact;
  const Component component = study.parameters.component;
  const int node = study.waves.first().node;
  const double decades = study.parameters.amplitude_decades;
  const std::string place = name_of(study.waves.asked) + of_main_blade(contact);
  const SectorSignal motion{std::string("The ") + name_of(component) + ", " + place, "mm",
                            tip_motion(shown, scene, contact, node, component) * mm_per_m},
      force{"The contact force at the " + place, "N", tip_force(shown, scene, node)};
  return {sectors_figure("tip_motion", motion, shown),
          two_way_spectrum_figure("tip_spectrum", motion, shown, frame, decades),
          contact_force_figure(scene, shown, contact, frame.engine_order_max),
          sectors_figure("force_of_sectors", force, shown),
          two_way_spectrum_figure("force_spectrum", force, shown, frame, decades),
          harmonic_bars_figure(study.waves.first().columns[static_cast<std::size_t>(study.shown)],
                               frame.engine_order_max)};
}

}  // namespace

std::vector<Figure> response_figures(const Study& study, const FieldResults& fields) {
  const SpeedFrame frame = speed_frame(study);
  const std::vector<AvoidedBand> avoided = speeds_to_avoid(study, fields);
  std::vector<Figure> figures = {response_figure(frame, study.amplitudes, study.rules, study.response.speeds,
                                                 study.parameters.component, avoided)};
  if (const auto budgets = error_budgets(study, fields); !budgets.empty())
    figures.push_back(error_budget_figure(largest_budget(budgets)));
  if (fields.over_speed.size() > 0) figures.push_back(stress_figure(frame, fields, avoided));
  return figures;
}

std::vector<Figure> study_figures(const Study& study) {
  const SpeedFrame frame = speed_frame(study);
  const InteractionMap& map = study.waves.first();
  std::vector<Figure> figures;
  if (!study.sweeps.empty())
    figures.push_back(sweeps_figure(frame, study.amplitudes, study.sweeps,
                                    sweep_record(study.response.speeds, study.amplitudes, study.sweeps)));
  if (!study.response.branches.empty())
    figures.push_back(branches_figure(study.amplitudes, frame.speeds, study.sweeps, study.response.branches));
  return joined<Figure>({figures,
                         map_figures(study, frame),
                         {campbell_figure(frame, study.rules),
                          interference_figure(frame, study.shown_response().speed, study.parameters.families)},
                         motion_figures(study, frame),
                         {nodal_diameter_tracking_figure(frame, map), engine_order_tracking_figure(frame, map),
                          waterfall_figure(frame, map),
                          casing_figure(study.response.scene, study.shown_response(), study.model.contact)}});
}

std::vector<Figure> sector_figures(const Study& study, const FieldStudy& fields) {
  std::vector<Figure> figures = {
      meridional_section_figure(fields.sector, study.model.contact, study.response.scene.clearance)};
  if (fields.mesh_error_of_frequencies.size() > 0) figures.push_back(mesh_error_figure(fields));
  return figures;
}

Figure error_budget_figure(const ErrorBudget& budget) {
  const double speed = budget.critical->speed * rpm_per_rad_s, excursion = budget.excursion * mm_per_m,
               stress = budget.stress * mpa_per_pa;
  const bool stressed = stress > 0;
  std::vector<std::string> panels = {"critical speed [rpm]", "tip |u| [mm]"},
                           at = {fixed(speed, 0), fixed(excursion, 2)};
  if (stressed) {
    panels.emplace_back("stress of the vibration [MPa]");
    at.push_back(fixed(stress, 0));
  }
  Table data{{"source", "kind", "change of speed [rpm]", "change of |u| [mm]", "change of stress [MPa]"}, {}};
  const auto times = [](const std::optional<double>& change, double value) {
    return change ? Cell(*change * value) : Cell(NoNumber{});
  };
  const auto add = [&](const std::string& source, const char* kind, double shift,
                       const std::optional<double>& further, const std::optional<double>& higher) {
    data.rows.push_back({source, std::string(kind), shift * speed, times(further, excursion),
                         times(stressed ? higher : std::nullopt, stress)});
  };
  for (const BudgetRow& row : budget.rows)
    if (row.failure.empty() && row.in_sum())
      add(row.source, row.is_setting ? "setting" : "data", row.shift,
          row.only_speed ? std::nullopt : std::optional(row.excursion), row.stress);
  const BudgetSum sum = sum_of(budget);
  add("all together", "sum", sum.shift, sum.excursion, sum.stress);
  const auto bound = std::ranges::find_if(budget.rows, &BudgetRow::is_bound);
  Figure figure = listed_figure(
      "error_budget", {{"speed", rpm_text(budget.critical->speed)},
                       {"wave", wave_names(*budget.critical)},
                       {"bound", bound == budget.rows.end() ? "" : fixed(percent * bound->excursion, 0) + " %"}});
  std::vector<std::string> sources;
  for (const auto& row : data.rows) sources.push_back(std::get<std::string>(row.front()));
  figure.drawing.values = {{"panel_title", panels}, {"panel_value", at}, {"source", sources}};
  figure.data = std::move(data);
  return figure;
}

}  // namespace tiprub::postprocess
