// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "postprocess/fields/blade_place.h"
#include "postprocess/figures/field_figures.h"
#include "postprocess/figures/wheel/wheel_picture.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

constexpr double drawn_mode = 0.07;  // of the outer radius: how far a mode's largest displacement is drawn

/// Where the panels stand [px of the figure]: a row a family, a column a nodal diameter.
struct Layout {
  static constexpr int cell = 330, cell_height = 270, bar = 90, top = 10;
  int families = 1, columns = 1;

  explicit Layout(const std::vector<ModeField>& modes) {
    std::set<int> found;
    for (const ModeField& mode : modes) found.insert(mode.family);
    families = std::max(1, static_cast<int>(found.size()));
    columns = std::max(1, static_cast<int>(modes.size()) / families);
  }
  int width() const { return columns * cell + bar; }
  int height() const { return families * cell_height + top; }
};

/// The wheel moved by a mode, coloured by how far.
void draw_mode(SurfacePicture& picture, const SectorFields& sector, const std::vector<SurfaceFace>& faces,
               const ModeField& mode) {
  const WheelField field = on_wheel({mode.wave}, sector.sector_count);
  const double largest = largest_displacement(field),
               size = largest > 0 ? drawn_mode * outer_radius(sector) / largest : 0;
  const auto moved = [&](int j) -> const Eigen::Matrix3Xd& {
    return field.displacement[static_cast<std::size_t>(j)];
  };
  draw_wheel(
      picture, sector, faces, [&](int j) -> Eigen::Matrix3Xd { return nodes_of_sector(sector, j) + size * moved(j); },
      [&](int j) { return painted(moved(j).colwise().norm().transpose(), largest, displacement_palette()); });
}

PanelName panel_name(const ModeField& mode, const Layout& layout, int row, int column) {
  constexpr double name_height = 16;  // [px] from the panel's top to the middle of its name
  return {"nodal diameter " + std::to_string(mode.wave.nodal_diameter) + ", family " +
              std::to_string(mode.family + 1) + ": " + fixed(mode.frequency, 0) + " Hz",
          (column + 0.5) * Layout::cell / layout.width(),
          1 - (Layout::top + row * Layout::cell_height + name_height) / layout.height()};
}

/// The frequency of every mode that was looked at, and how much each part of the wheel takes part in it.
Table shares_table(const FieldStudy& fields) {
  Table table{{"nodal diameter", "family", "frequency [Hz]", "speed [rpm]"}, {}};
  for (const auto& [part, cells] : fields.sector.parts) table.header.push_back("share of " + part + " [1]");
  for (const ModeShares& mode : fields.modes.shares) {
    table.rows.push_back({mode.nodal_diameter, mode.family + 1, mode.frequency, fields.speed * rpm_per_rad_s});
    for (const auto& [part, share] : mode.share) table.rows.back().emplace_back(share);
  }
  return table;
}

/// How much the parts take part in the modes of the disc.
std::string participation(const NaturalModes& modes) {
  std::string text;
  for (const ModeShares& mode : modes.shares) {
    if (std::none_of(modes.disc.begin(), modes.disc.end(), [&](const ModeField& drawn) {
          return drawn.family == mode.family && drawn.wave.nodal_diameter == mode.nodal_diameter;
        }))
      continue;
    std::string shares;
    for (const auto& [part, share] : mode.share)
      shares += (shares.empty() ? "" : ", ") + spoken(part) + " " + fixed(100 * share, 0) + " %";
    text += "Nodal diameter " + std::to_string(mode.nodal_diameter) + ": " + shares +
            " of the mean square of the motion. ";
  }
  return text;
}

std::string how_drawn() {
  return "Largest displacement 1 in each, drawn as " + fixed(100 * drawn_mode, 0) +
         " % of the outer radius. A nodal diameter strictly between 0 and N/2 has this shape at any angle.";
}

/// All but title and caption. `modes` by nodal diameter, then family.
Figure modes_figure(const std::string& name, const FieldStudy& fields, const std::vector<SurfaceFace>& faces,
                    const std::vector<ModeField>& modes) {
  const Layout layout(modes);
  SurfacePicture picture(in_pixels(layout.width()), in_pixels(layout.height()));
  std::vector<PanelName> names;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const int column = static_cast<int>(i) / layout.families, row = static_cast<int>(i) % layout.families;
    picture.begin_panel(in_pixels(column * Layout::cell + 8), in_pixels(Layout::top + row * Layout::cell_height + 30),
                        in_pixels(Layout::cell - 16), in_pixels(Layout::cell_height - 34),
                        wheel_view(fields, usual_tilt));
    draw_mode(picture, fields.sector, faces, modes[i]);
    names.push_back(panel_name(modes[i], layout, row, column));
  }
  Figure figure{.drawing = {.name = name, .width = layout.width(), .height = layout.height(), .script = "panels"},
                .title = {},
                .caption = {},
                .data = shares_table(fields)};
  set_picture(figure, picture);
  set_panels(figure.drawing, names);
  set_colour_bar(figure.drawing, displacement_palette(), 1, "displacement");
  return figure;
}

}  // namespace

Figure mode_shapes_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  Figure figure = modes_figure("mode_shapes", fields, faces, fields.modes.lowest);
  figure.title = "Mode shapes";
  figure.caption = "Natural modes at " + rpm_text(fields.speed) +
                   ", of the nodal diameters that the casing's lowest harmonics drive. " + how_drawn();
  figure.fields = {"fields/modes_wheel.vtu", "fields/modes_sector.vtu"};
  return figure;
}

Figure disc_modes_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  const std::vector<ModeField>& modes = fields.modes.disc;
  Figure figure = modes_figure("disc_modes", fields, faces, modes);
  figure.title = "Modes of the disc";
  figure.caption = "Natural modes at " + rpm_text(fields.speed) + " of family " +
                   std::to_string(modes.front().family + 1) +
                   ", of the higher families the one in which the disc takes part most. " +
                   participation(fields.modes) + "Its table has all families that were looked at. " + how_drawn();
  return figure;
}

}  // namespace tiprub
