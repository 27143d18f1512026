// SPDX-License-Identifier: GPL-3.0-or-later
// Displacement and stress on the wheel at the instant of the largest contact force.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <numeric>
#include <set>

#include "postprocess/fields/blade_place.h"
#include "postprocess/figures/field_figures.h"
#include "postprocess/figures/wheel/wheel_picture.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

constexpr double drawn_motion = 0.05;  // of the outer radius: how far the largest displacement is drawn

/// What one panel of a contact instant shows.
struct Panel {
  std::string title;
  double tilt;                                         ///< [deg]
  std::function<Eigen::VectorXd(std::size_t)> values;  ///< by sector
};

/// What of the wheel is coloured: all of it, or a part, and the rest has the colour of metal.
struct Coloured {
  std::vector<SurfaceFace> faces, rest;
  std::vector<int> nodes;  ///< that the colours are to tell apart
  double above = 0.001;    ///< [1] share of these above the colours: single ones, at corners, may stand far above
};

Coloured all_of(const SectorFields& sector, const std::vector<SurfaceFace>& faces) {
  Coloured all{faces, {}, std::vector<int>(static_cast<std::size_t>(sector.nodes.cols()))};
  std::iota(all.nodes.begin(), all.nodes.end(), 0);
  return all;
}

Coloured disc_of(const SectorFields& sector) {
  std::vector<int> others;
  for (const auto& [part, cells] : sector.parts)
    if (part != disc_part) others.insert(others.end(), cells.begin(), cells.end());
  Coloured disc{surface_of_cells(sector, sector.parts.at(disc_part)), surface_of_cells(sector, others), {}, 0.02};
  std::set<int> nodes, shared;
  for (const SurfaceFace& face : disc.faces) nodes.insert(face.nodes.begin(), face.nodes.end());
  for (const SurfaceFace& face : disc.rest) shared.insert(face.nodes.begin(), face.nodes.end());
  std::set_difference(nodes.begin(), nodes.end(), shared.begin(), shared.end(), std::back_inserter(disc.nodes));
  return disc;
}

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

/// The value that all but the highest few of the nodes stay below, in all sectors.
double colour_limit(const std::vector<Panel>& panels, const Coloured& coloured, int sectors) {
  double limit = 0;
  for (const Panel& panel : panels) {
    std::vector<double> all;
    for (int j = 0; j < sectors; ++j) {
      const Eigen::VectorXd values = panel.values(static_cast<std::size_t>(j))(coloured.nodes);
      all.insert(all.end(), values.begin(), values.end());
    }
    const auto place =
        all.begin() + static_cast<std::ptrdiff_t>((1 - coloured.above) * static_cast<double>(all.size() - 1));
    std::nth_element(all.begin(), place, all.end());
    limit = std::max(limit, *place);
  }
  return limit > 0 ? limit : 1;
}

constexpr double behind_tilt = 155;  // [deg]

/// Where the panels stand [px of the figure], side by side.
constexpr int cell = 460, instant_height = 480, bar = 110;

int instant_width(const std::vector<Panel>& panels) {
  return static_cast<int>(panels.size()) * cell + bar;
}

SurfacePicture instant_picture(const FieldStudy& fields, const Coloured& coloured, const std::vector<Panel>& panels,
                               const Palette& palette, double limit) {
  const double largest = largest_displacement(fields.vibration);
  const std::vector<Eigen::Matrix3Xd> nodes =
      moved_nodes(fields, largest > 0 ? drawn_motion * outer_radius(fields.sector) / largest : 0);
  SurfacePicture picture(in_pixels(instant_width(panels)), in_pixels(instant_height));
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Panel& panel = panels[i];
    picture.begin_panel(in_pixels(static_cast<int>(i) * cell + 10), in_pixels(45), in_pixels(cell - 20),
                        in_pixels(instant_height - 60), wheel_view(fields, panel.tilt));
    const auto moved = [&](int j) { return nodes[static_cast<std::size_t>(j)]; };
    draw_wheel(picture, fields.sector, coloured.faces, moved,
               [&](int j) { return painted(panel.values(static_cast<std::size_t>(j)), limit, palette); });
    draw_wheel(picture, fields.sector, coloured.rest, moved,
               [&](int) { return even(fields.sector.nodes.cols(), surface_colours::metal); });
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
Figure instant_figure(const std::string& name, const FieldStudy& fields, const Coloured& coloured,
                      const std::vector<Panel>& panels, const Palette& palette, const std::string& unit) {
  const double limit = colour_limit(panels, coloured, fields.sector.sector_count);
  Figure figure{
      .drawing = {.name = name, .width = instant_width(panels), .height = instant_height, .script = "panels"},
      .title = {},
      .caption = {},
      .data = peak_table(fields),
      .fields = {"fields/contact_wheel.vtu", "fields/contact_sector.vtu"}};
  if (moving_at_instant(fields)) figure.fields.push_back("fields/motion_sector.pvd");
  set_picture(figure, instant_picture(fields, coloured, panels, palette, limit));
  set_panels(figure.drawing, panel_names(panels));
  set_colour_bar(figure.drawing, palette, limit, unit);
  return figure;
}

/// [mm] of the vibration, by node of sector j.
Eigen::VectorXd displacement_at(const FieldStudy& fields, std::size_t j) {
  return mm_per_m * fields.vibration.displacement[j].colwise().norm().transpose();
}

/// [MPa] likewise, the von Mises stress.
Eigen::VectorXd stress_at(const FieldStudy& fields, std::size_t j) {
  return mpa_per_pa * von_mises(fields.vibration.stress[j]);
}

/// The largest values on the disc, by sector.
Table disc_table(const FieldStudy& fields, const Coloured& disc) {
  Table table{{"sector", "largest displacement of the disc [mm]", "largest von Mises stress of the disc [MPa]",
               "largest displacement [mm]", "largest von Mises stress [MPa]"},
              {}};
  for (int j = 0; j < fields.sector.sector_count; ++j) {
    const auto sector = static_cast<std::size_t>(j);
    const Eigen::VectorXd displacement = displacement_at(fields, sector), stress = stress_at(fields, sector);
    table.rows.push_back({j, displacement(disc.nodes).maxCoeff(), stress(disc.nodes).maxCoeff(),
                          displacement.maxCoeff(), stress.maxCoeff()});
  }
  return table;
}

/// The disc alone in colour, from both sides; all but title.
Figure disc_figure(const std::string& name, const FieldStudy& fields,
                   Eigen::VectorXd (*values)(const FieldStudy&, std::size_t), const Palette& palette,
                   const std::string& unit) {
  const Coloured disc = disc_of(fields.sector);
  const auto by_sector = [&](std::size_t j) { return values(fields, j); };
  Figure figure = instant_figure(
      name, fields, disc,
      {{"from the inlet, tilted", usual_tilt, by_sector}, {"from behind, tilted", behind_tilt, by_sector}}, palette,
      unit);
  figure.data = disc_table(fields, disc);
  double largest = 0;
  for (int j = 0; j < fields.sector.sector_count; ++j)
    largest = std::max(largest, by_sector(static_cast<std::size_t>(j))(disc.nodes).maxCoeff());
  figure.caption = " Colours are for the disc, on which it reaches " + significant(largest, 3) + " " + unit +
                   " beside the blades' roots; they end where 2 % of the nodes there lie above. The blades are grey.";
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

Figure disc_displacement_figure(const FieldStudy& fields, const std::vector<SurfaceFace>&) {
  Figure figure = disc_figure("disc_displacement", fields, displacement_at, displacement_palette(), "[mm]");
  figure.title = "Displacement of the disc at that instant";
  figure.caption = instant_sentence(fields) + " The vibration alone." + figure.caption;
  return figure;
}

Figure disc_stress_figure(const FieldStudy& fields, const std::vector<SurfaceFace>&) {
  Figure figure = disc_figure("disc_stress", fields, stress_at, stress_palette(), "[MPa]");
  figure.title = "Von Mises stress of the disc at that instant";
  figure.caption = instant_sentence(fields) + " Stress of the vibration alone." + figure.caption;
  return figure;
}

Figure contact_displacement_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  const auto values = [&](std::size_t j) { return displacement_at(fields, j); };
  Figure figure = instant_figure("contact_displacement", fields, all_of(fields.sector, faces),
                                 {{"from the inlet, tilted", usual_tilt, values}, {"along the axis", 0, values}},
                                 displacement_palette(), "[mm]");
  figure.title = "Displacement at a contact instant";
  figure.caption = instant_sentence(fields) + " The vibration alone, up to " +
                   fixed(mm_per_m * largest_displacement(fields.vibration), 3) + " mm" + ", drawn as " +
                   fixed(100 * drawn_motion, 0) + " % of the outer radius." + invariance_sentence(fields);
  return figure;
}

Figure contact_stress_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  const auto alone = [&](std::size_t j) { return stress_at(fields, j); };
  Figure figure = instant_figure("contact_stress", fields, all_of(fields.sector, faces),
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
  Figure figure = instant_figure("running_stress", fields, all_of(fields.sector, faces),
                                 {{"spin alone", usual_tilt, spin}, {"spin and vibration", usual_tilt, both}},
                                 stress_palette(), "[MPa]");
  figure.title = "Von Mises stress with spin";
  figure.caption = instant_sentence(fields) +
                   " Left: the static stress under spin; right: with the vibration's. Linear elasticity for both.";
  return figure;
}

}  // namespace tiprub
