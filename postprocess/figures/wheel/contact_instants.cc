// SPDX-License-Identifier: GPL-3.0-or-later
// Displacement and stress on the wheel at the instant of the largest contact force.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "postprocess/figures/field_figures.h"
#include "postprocess/figures/wheel/wheel_picture.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

constexpr double drawn_motion = 0.05;      // of the outer radius: how far the largest displacement is drawn
constexpr double colour_quantile = 0.999;  // of the nodes: single ones, at corners of the clamp, may stand far above

/// What one panel of a contact instant shows.
struct Panel {
  std::string title;
  double tilt;                                         ///< [deg]
  std::function<Eigen::VectorXd(std::size_t)> values;  ///< by sector
};

std::vector<Eigen::Matrix3Xd> moved_nodes(const FieldStudy& fields, double size) {
  std::vector<Eigen::Matrix3Xd> nodes;
  nodes.reserve(static_cast<std::size_t>(fields.sector.sector_count));
  for (int j = 0; j < fields.sector.sector_count; ++j)
    nodes.push_back(nodes_of_sector(fields.sector, j) +
                    size * fields.vibration.displacement[static_cast<std::size_t>(j)]);
  return nodes;
}

/// Balls where the casing pushes; the larger the harder.
void draw_contacts(SurfacePicture& picture, const FieldStudy& fields, const std::vector<Eigen::Matrix3Xd>& nodes) {
  const double hardest = fields.contact_force.maxCoeff();
  if (!(hardest > 0)) return;
  const std::vector<int>& contact = fields.sector.node_set("contact");
  for (Eigen::Index j = 0; j < fields.contact_force.rows(); ++j)
    for (std::size_t k = 0; k < contact.size(); ++k) {
      const double share = fields.contact_force(j, static_cast<Eigen::Index>(k)) / hardest;
      if (share > 0.01)
        picture.ball(nodes[static_cast<std::size_t>(j)].col(contact[k]), surface_colours::pushed,
                     3.0 + 3.5 * std::sqrt(share));
    }
}

/// The value that all but the highest few nodes of the wheel stay below.
double colour_limit(const std::vector<Panel>& panels, int sectors) {
  double limit = 0;
  for (const Panel& panel : panels) {
    std::vector<double> all;
    for (int j = 0; j < sectors; ++j) {
      const Eigen::VectorXd values = panel.values(static_cast<std::size_t>(j));
      all.insert(all.end(), values.begin(), values.end());
    }
    const auto place =
        all.begin() + static_cast<std::ptrdiff_t>(colour_quantile * static_cast<double>(all.size() - 1));
    std::nth_element(all.begin(), place, all.end());
    limit = std::max(limit, *place);
  }
  return limit > 0 ? limit : 1;
}

/// Where the panels stand [px of the figure], side by side.
constexpr int cell = 460, instant_height = 480, bar = 110;

int instant_width(const std::vector<Panel>& panels) {
  return static_cast<int>(panels.size()) * cell + bar;
}

SurfacePicture instant_picture(const FieldStudy& fields, const std::vector<SurfaceFace>& faces,
                               const std::vector<Panel>& panels, const Palette& palette, double limit) {
  const double largest = largest_displacement(fields.vibration);
  const std::vector<Eigen::Matrix3Xd> nodes =
      moved_nodes(fields, largest > 0 ? drawn_motion * outer_radius(fields.sector) / largest : 0);
  SurfacePicture picture(in_pixels(instant_width(panels)), in_pixels(instant_height));
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Panel& panel = panels[i];
    picture.begin_panel(in_pixels(static_cast<int>(i) * cell + 10), in_pixels(45), in_pixels(cell - 20),
                        in_pixels(instant_height - 60), wheel_view(fields, panel.tilt));
    draw_wheel(
        picture, fields.sector, faces, [&](int j) { return nodes[static_cast<std::size_t>(j)]; },
        [&](int j) { return painted(panel.values(static_cast<std::size_t>(j)), limit, palette); });
    draw_contacts(picture, fields, nodes);
  }
  return picture;
}

std::vector<PanelName> panel_names(const std::vector<Panel>& panels) {
  constexpr double name_height = 0.955;  // of the figure's
  std::vector<PanelName> names;
  names.reserve(panels.size());
  for (const Panel& panel : panels)
    names.push_back(
        {panel.title, (static_cast<double>(names.size()) + 0.5) * cell / instant_width(panels), name_height});
  return names;
}

Table peak_table(const FieldStudy& fields) {
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

/// All but title and caption.
Figure instant_figure(const std::string& name, const FieldStudy& fields, const std::vector<SurfaceFace>& faces,
                      const std::vector<Panel>& panels, const Palette& palette, const std::string& unit) {
  const double limit = colour_limit(panels, fields.sector.sector_count);
  Figure figure{.drawing = {.name = name,
                            .width = instant_width(panels),
                            .height = instant_height,
                            .script = "contact_instant"},
                .title = {},
                .caption = {},
                .data = peak_table(fields),
                .fields = {"fields/contact_wheel.vtu", "fields/contact_sector.vtu"}};
  set_picture(figure, instant_picture(fields, faces, panels, palette, limit));
  set_panels(figure.drawing, panel_names(panels));
  set_colour_bar(figure.drawing, palette, limit, unit);
  return figure;
}

std::string instant_sentence(const FieldStudy& fields) {
  return "At " + rpm_text(fields.speed) + ", at the instant of the largest contact force (" + fixed(fields.force, 0) +
         " N in all; red balls: where "
         "the casing pushes, the larger the harder).";
}

std::string invariance_sentence(const FieldStudy& fields) {
  const int sectors = fields.sector.sector_count;
  if (fields.invariant_sectors == sectors) return "";
  return " Turned by " + std::to_string(fields.invariant_sectors) + " of " + std::to_string(sectors) +
         " sectors, the displacement is itself within " + scientific(fields.invariance.displacement, 1) +
         " of its largest value, the stress within " + scientific(fields.invariance.stress, 1) + ".";
}

}  // namespace

Figure contact_displacement_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  const auto values = [&](std::size_t j) -> Eigen::VectorXd {
    return mm_per_m * fields.vibration.displacement[j].colwise().norm().transpose();
  };
  Figure figure = instant_figure("contact_displacement", fields, faces,
                                 {{"from the inlet, tilted", usual_tilt, values}, {"along the axis", 0, values}},
                                 displacement_palette(), "[mm]");
  figure.title = "Displacement at a contact instant";
  figure.caption = instant_sentence(fields) + " The vibration alone, up to " +
                   fixed(mm_per_m * largest_displacement(fields.vibration), 3) + " mm" + ", drawn as " +
                   fixed(100 * drawn_motion, 0) + " % of the outer radius." + invariance_sentence(fields);
  return figure;
}

Figure contact_stress_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  const auto alone = [&](std::size_t j) -> Eigen::VectorXd {
    return mpa_per_pa * von_mises(fields.vibration.stress[j]);
  };
  Figure figure = instant_figure("contact_stress", fields, faces,
                                 {{"from the inlet, tilted", usual_tilt, alone}, {"along the axis", 0, alone}},
                                 stress_palette(), "[MPa]");
  figure.title = "Von Mises stress at a contact instant";
  figure.caption = instant_sentence(fields) + " Stress of the vibration alone";
  for (const FieldPeak& peak : fields.peaks)
    if (peak.speed == fields.speed)
      figure.caption += "; outside tip patch and clamp rim it reaches " + fixed(peak.body.vibration * mpa_per_pa, 0) +
                        " MPa" + (peak.cycle ? " in the cycle" : "") + (peak.where.empty() ? "" : ", " + peak.where) +
                        ", the spin alone " + fixed(peak.body.spin * mpa_per_pa, 0) + " MPa, both together " +
                        fixed(peak.body.both * mpa_per_pa, 0) + " MPa";
  figure.caption += ". Colours end where 0.1 % of the nodes lie above. The table beside it has all critical speeds.";
  return figure;
}

Figure running_stress_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  const auto spin = [&](std::size_t j) -> Eigen::VectorXd { return mpa_per_pa * von_mises(fields.spin.stress[j]); };
  const auto both = [&](std::size_t j) -> Eigen::VectorXd {
    return mpa_per_pa * von_mises(fields.vibration.stress[j] + fields.spin.stress[j]);
  };
  Figure figure = instant_figure("running_stress", fields, faces,
                                 {{"spin alone", usual_tilt, spin}, {"spin and vibration", usual_tilt, both}},
                                 stress_palette(), "[MPa]");
  figure.title = "Von Mises stress with spin";
  figure.caption = instant_sentence(fields) +
                   " Left: the static stress under spin; right: with the vibration's. Linear elasticity for both.";
  return figure;
}

}  // namespace tiprub
