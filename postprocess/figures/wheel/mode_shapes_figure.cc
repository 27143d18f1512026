// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

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

  int width() const { return columns * cell + bar; }
  int height() const { return families * cell_height + top; }
};

Layout layout_of(const std::vector<ModeField>& modes) {
  Layout layout;
  for (const ModeField& mode : modes) layout.families = std::max(layout.families, mode.family + 1);
  layout.columns = std::max(1, static_cast<int>(modes.size()) / layout.families);
  return layout;
}

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

PanelName panel_name(const ModeField& mode, const Layout& layout, int column) {
  constexpr double name_height = 16;  // [px] from the panel's top to the middle of its name
  return {"nodal diameter " + std::to_string(mode.wave.nodal_diameter) + ", family " +
              std::to_string(mode.family + 1) + ": " + fixed(mode.frequency, 0) + " Hz",
          (column + 0.5) * Layout::cell / layout.width(),
          1 - (Layout::top + mode.family * Layout::cell_height + name_height) / layout.height()};
}

std::string mode_caption(const FieldStudy& fields) {
  return "Natural modes at " + rpm_text(fields.speed) +
         ", of the nodal diameters that the casing's lowest harmonics drive. Largest displacement 1 in each, drawn "
         "as " +
         fixed(100 * drawn_mode, 0) +
         " % of the outer radius. A nodal diameter strictly between 0 and N/2 has this shape at any angle.";
}

}  // namespace

Figure mode_shapes_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  const Layout layout = layout_of(fields.modes);
  SurfacePicture picture(in_pixels(layout.width()), in_pixels(layout.height()));
  std::vector<PanelName> names;
  Table table{{"nodal diameter", "family", "frequency [Hz]", "speed [rpm]"}, {}};
  for (std::size_t i = 0; i < fields.modes.size(); ++i) {
    const ModeField& mode = fields.modes[i];
    const int column = static_cast<int>(i) / layout.families;
    picture.begin_panel(in_pixels(column * Layout::cell + 8),
                        in_pixels(Layout::top + mode.family * Layout::cell_height + 30), in_pixels(Layout::cell - 16),
                        in_pixels(Layout::cell_height - 34), wheel_view(fields, usual_tilt));
    draw_mode(picture, fields.sector, faces, mode);
    names.push_back(panel_name(mode, layout, column));
    table.rows.push_back({mode.wave.nodal_diameter, mode.family + 1, mode.frequency, fields.speed * rpm_per_rad_s});
  }
  Figure figure{
      .drawing = {.name = "mode_shapes", .width = layout.width(), .height = layout.height(), .script = "mode_shapes"},
      .title = "Mode shapes",
      .caption = mode_caption(fields),
      .data = std::move(table),
      .fields = {"fields/modes_wheel.vtu", "fields/modes_sector.vtu"}};
  set_picture(figure, picture);
  set_panels(figure.drawing, names);
  set_colour_bar(figure.drawing, displacement_palette(), 1, "displacement");
  return figure;
}

}  // namespace tiprub
