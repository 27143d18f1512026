// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/field_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include "postprocess/interruption.h"
#include "postprocess/units.h"
#include "postprocess/wheel_picture.h"

namespace tiprub {

namespace {

const Rgb metal(0.80f, 0.82f, 0.85f), orange(0.93f, 0.55f, 0.14f), red(0.85f, 0.10f, 0.12f),
    blue(0.05f, 0.30f, 0.85f), green(0.55f, 0.80f, 0.58f), violet(0.76f, 0.66f, 0.90f),
    grey_line(0.42f, 0.44f, 0.47f);
constexpr double drawn_motion = 0.05;  // of the outer radius: how far the largest displacement is drawn
constexpr double drawn_mode = 0.07;    // likewise, of a mode
constexpr double usual_tilt = 42;      // [deg]
constexpr double mpa_per_pa = 1e-6;
constexpr double colour_quantile = 0.999;  // of the nodes: single ones, at corners of the clamp, may stand far above

int scaled(double length) {
  return static_cast<int>(std::lround(picture_scale * length));
}

Eigen::Matrix3Xf even(Eigen::Index nodes, const Rgb& colour) {
  return colour.replicate(1, nodes);
}

Eigen::Matrix3Xf painted(const Eigen::VectorXd& values, double largest, const Palette& palette) {
  Eigen::Matrix3Xf colours(3, values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i) colours.col(i) = palette.at(values[i] / largest);
  return colours;
}

double outer_radius(const SectorFields& sector) {
  return sector.nodes.topRows<2>().colwise().norm().maxCoeff();
}

std::string text(const char* format, double value) {
  char words[64];
  std::snprintf(words, sizeof words, format, value);
  return words;
}

std::string rpm(double speed) {
  return text("%.0f rpm", speed * rpm_per_rad_s);
}

/// "main blade" for "main_blade".
std::string spoken(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

using Colours = std::function<Eigen::Matrix3Xf(int sector)>;
using Nodes = std::function<Eigen::Matrix3Xd(int sector)>;

void draw_wheel(SurfacePicture& picture, const FieldStudy& fields, const std::vector<SurfaceFace>& faces,
                const Nodes& nodes, const Colours& colours) {
  for (int j = 0; j < fields.sector.sector_count; ++j)
    draw_faces(picture, faces, nodes(j), colours(j), CutFaces::hidden);
}

Figure wheel_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  constexpr int width = 900, height = 620;
  const SectorFields& sector = fields.sector;
  SurfacePicture picture(scaled(width), scaled(height));
  View view = wheel_view(fields, usual_tilt);
  picture.begin_panel(scaled(20), scaled(15), scaled(width - 40), scaled(height - 30), view);
  draw_wheel(
      picture, fields, faces, [&](int j) { return nodes_of_sector(sector, j); },
      [&](int j) { return even(sector.nodes.cols(), j == 0 ? orange : metal); });
  Figure figure = picture_figure("wheel", width, height, picture,
                                 label("sector 0", 0.03, 0.94, "left font ',14' textcolor rgb '#c96f10'"));
  figure.title = "The wheel";
  figure.caption = std::to_string(sector.sector_count) + " sectors; in colour the one that was meshed and reduced (" +
                   std::to_string(sector.nodes.cols()) + " nodes, " + std::to_string(sector.cells.cols()) +
                   " bricks). Seen from the inlet.";
  figure.data = {{"sectors", "nodes a sector", "bricks a sector", "outer radius [m]"},
                 {{sector.sector_count, static_cast<int>(sector.nodes.cols()), static_cast<int>(sector.cells.cols()),
                   outer_radius(sector)}}};
  return figure;
}

Eigen::Matrix3Xf set_colours(const SectorFields& sector) {
  return even(sector.nodes.cols(), metal);
}

/// One view of the sector with its node sets.
void draw_sector(SurfacePicture& picture, const SectorFields& sector, const std::vector<SurfaceFace>& faces) {
  std::vector<SurfaceFace> by_side[3];
  for (const SurfaceFace& face : faces) by_side[static_cast<int>(face.side)].push_back(face);
  const Eigen::Index nodes = sector.nodes.cols();
  draw_faces(picture, by_side[0], sector.nodes, set_colours(sector), CutFaces::shown);
  draw_faces(picture, by_side[1], sector.nodes, even(nodes, green), CutFaces::shown);
  draw_faces(picture, by_side[2], sector.nodes, even(nodes, violet), CutFaces::shown);
  draw_edges(picture, faces, sector.nodes, grey_line, 0.7);
  for (const int node : sector.node_set("clamped")) picture.ball(sector.nodes.col(node), red, 3.2);
  for (const int node : sector.node_set("contact")) picture.ball(sector.nodes.col(node), blue, 5.5);
}

Figure sector_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  constexpr int width = 1000, height = 560;
  const SectorFields& sector = fields.sector;
  SurfacePicture picture(scaled(width), scaled(height));
  const View wheel = wheel_view(fields, usual_tilt);
  const Eigen::Vector3d axis(0, 0, wheel.towards_viewer.z() > 0 ? 1 : -1);
  const Eigen::Vector3d middle = sector.nodes.rowwise().mean();
  const Eigen::Vector3d outward = Eigen::Vector3d(middle.x(), middle.y(), 0).normalized();
  const Eigen::Vector3d across = axis.cross(outward);
  for (const double side : {1.0, -1.0}) {
    View view;
    // Once from beside the lower cut face, once from inside the bore and beside the upper one.
    view.towards_viewer = side > 0 ? Eigen::Vector3d(0.6 * axis + 0.75 * across + 0.4 * outward)
                                   : Eigen::Vector3d(0.5 * axis - 0.5 * across - 0.75 * outward);
    view.up = axis;
    view.seen = sector.nodes;
    picture.begin_panel(scaled(side > 0 ? 25 : width / 2 + 15), scaled(55), scaled(width / 2 - 40),
                        scaled(height - 75), view);
    draw_sector(picture, sector, faces);
  }
  const auto key = [&](const std::string& words, double x, const char* colour) {
    return label("\xE2\x97\x8F " + words, x, 0.955, "left font ',13' textcolor rgb '" + std::string(colour) + "'");
  };
  Figure figure = picture_figure("sector", width, height, picture,
                                 key("clamped", 0.07, "#d91a1f") + key("contact nodes", 0.24, "#0d4dd9") +
                                     key("lower cut face", 0.47, "#3f8a4c") + key("upper cut face", 0.71, "#7d5fa8"));
  figure.title = "One sector and its node sets";
  figure.caption =
      "The mesh of sector 0 from both sides. Red: clamped nodes; blue: the contact nodes on the tip line, "
      "leading to trailing edge; green and violet: the cut faces, where the neighbours join.";
  figure.data = {{"node set", "nodes"}, {}};
  for (const auto& [name, nodes] : sector.node_sets)
    figure.data.rows.push_back({name, static_cast<int>(nodes.size())});
  return figure;
}

Figure mode_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  int families = 0;
  for (const ModeField& mode : fields.modes) families = std::max(families, mode.family + 1);
  const int columns = std::max(1, static_cast<int>(fields.modes.size()) / std::max(1, families));
  constexpr int cell = 330, cell_height = 270, bar = 90, top = 10;
  const int width = columns * cell + bar, height = families * cell_height + top;
  SurfacePicture picture(scaled(width), scaled(height));
  std::string labels;
  Figure data;
  data.data = {{"nodal diameter", "family", "frequency [Hz]", "speed [rpm]"}, {}};
  for (std::size_t i = 0; i < fields.modes.size(); ++i) {
    const ModeField& mode = fields.modes[i];
    const int column = static_cast<int>(i) / families, row = mode.family;
    const WheelField field = on_wheel({mode.wave}, fields.sector.sector_count);
    double largest = 0;
    for (const Eigen::Matrix3Xd& moved : field.displacement)
      largest = std::max(largest, moved.colwise().norm().maxCoeff());
    const double size = drawn_mode * outer_radius(fields.sector) / largest;
    picture.begin_panel(scaled(column * cell + 8), scaled(top + row * cell_height + 30), scaled(cell - 16),
                        scaled(cell_height - 34), wheel_view(fields, usual_tilt));
    draw_wheel(
        picture, fields, faces,
        [&](int j) -> Eigen::Matrix3Xd {
          return nodes_of_sector(fields.sector, j) + size * field.displacement[static_cast<std::size_t>(j)];
        },
        [&](int j) {
          return painted(field.displacement[static_cast<std::size_t>(j)].colwise().norm().transpose(), largest,
                         displacement_palette());
        });
    labels +=
        label("nodal diameter " + std::to_string(mode.wave.nodal_diameter) + ", family " +
                  std::to_string(mode.family + 1) + ": " + text("%.0f Hz", mode.frequency),
              (column + 0.5) * cell / width, 1 - (top + row * cell_height + 16.0) / height, "center font ',12'");
    data.data.rows.push_back(
        {mode.wave.nodal_diameter, mode.family + 1, mode.frequency, fields.speed * rpm_per_rad_s});
  }
  Figure figure = picture_figure("mode_shapes", width, height, picture,
                                 labels + colour_bar(displacement_palette(), 1, "displacement"));
  figure.data = data.data;
  figure.title = "Mode shapes";
  figure.caption =
      "Natural modes at " + rpm(fields.speed) +
      ", of the nodal diameters that the casing's lowest harmonics drive. Largest displacement 1 in "
      "each, drawn as " +
      text("%.0f %%", 100 * drawn_mode) +
      " of the outer radius. A nodal diameter strictly between 0 and N/2 has this shape at any angle. For "
      "ParaView: fields/modes_wheel.vtu, fields/modes_sector.vtu.";
  return figure;
}

/// What one panel of a contact instant shows.
struct Panel {
  std::string title;
  double tilt;                                         ///< [deg]
  std::function<Eigen::VectorXd(std::size_t)> values;  ///< by sector
};

std::vector<Eigen::Matrix3Xd> moved_nodes(const FieldStudy& fields, double size) {
  std::vector<Eigen::Matrix3Xd> nodes;
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
        picture.ball(nodes[static_cast<std::size_t>(j)].col(contact[k]), red, 3.0 + 3.5 * std::sqrt(share));
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

Figure instant_figure(const std::string& name, const FieldStudy& fields, const std::vector<SurfaceFace>& faces,
                      const std::vector<Panel>& panels, const Palette& palette, const std::string& unit) {
  constexpr int cell = 460, height = 480, bar = 110;
  const int count = static_cast<int>(panels.size()), width = count * cell + bar;
  double largest = 0;
  for (const Eigen::Matrix3Xd& moved : fields.vibration.displacement)
    largest = std::max(largest, moved.colwise().norm().maxCoeff());
  const std::vector<Eigen::Matrix3Xd> nodes =
      moved_nodes(fields, largest > 0 ? drawn_motion * outer_radius(fields.sector) / largest : 0);
  const double limit = colour_limit(panels, fields.sector.sector_count);
  SurfacePicture picture(scaled(width), scaled(height));
  std::string labels;
  for (int i = 0; i < count; ++i) {
    const Panel& panel = panels[static_cast<std::size_t>(i)];
    picture.begin_panel(scaled(i * cell + 10), scaled(45), scaled(cell - 20), scaled(height - 60),
                        wheel_view(fields, panel.tilt));
    draw_wheel(
        picture, fields, faces, [&](int j) { return nodes[static_cast<std::size_t>(j)]; },
        [&](int j) { return painted(panel.values(static_cast<std::size_t>(j)), limit, palette); });
    draw_contacts(picture, fields, nodes);
    labels += label(panel.title, (i + 0.5) * cell / width, 0.955, "center font ',13'");
  }
  Figure figure = picture_figure(name, width, height, picture, labels + colour_bar(palette, limit, unit));
  figure.data = {
      {"speed [rpm]", "largest displacement of the vibration [mm]", "von Mises, vibration [MPa]",
       "von Mises, spin [MPa]", "von Mises, both [MPa]", "at sector", "r [mm]", "theta [deg]", "z [mm]", "part"},
      {}};
  for (const FieldPeak& peak : fields.peaks)
    figure.data.rows.push_back({peak.speed * rpm_per_rad_s, peak.displacement * mm_per_m, peak.vibration * mpa_per_pa,
                                peak.spin * mpa_per_pa, peak.both * mpa_per_pa, peak.sector, peak.place[0] * mm_per_m,
                                peak.place[1] * 180 / std::numbers::pi, peak.place[2] * mm_per_m, peak.part});
  return figure;
}

std::string instant_sentence(const FieldStudy& fields) {
  return "At " + rpm(fields.speed) + ", at the instant of the largest contact force (" +
         text("%.0f N", fields.force) +
         " in all; red balls: where "
         "the casing pushes, the larger the harder).";
}

std::string invariance_sentence(const FieldStudy& fields) {
  const int sectors = fields.sector.sector_count;
  if (fields.invariant_sectors == sectors) return "";
  return " Turned by " + std::to_string(fields.invariant_sectors) + " of " + std::to_string(sectors) +
         " sectors, the displacement is itself within " + text("%.1e", fields.invariance.displacement) +
         " of its largest value, the stress within " + text("%.1e", fields.invariance.stress) + ".";
}

Figure displacement_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  const auto values = [&](std::size_t j) -> Eigen::VectorXd {
    return mm_per_m * fields.vibration.displacement[j].colwise().norm().transpose();
  };
  Figure figure = instant_figure("contact_displacement", fields, faces,
                                 {{"from the inlet, tilted", usual_tilt, values}, {"along the axis", 0, values}},
                                 displacement_palette(), "[mm]");
  double largest = 0;
  for (std::size_t j = 0; j < fields.vibration.displacement.size(); ++j)
    largest = std::max(largest, values(j).maxCoeff());
  figure.title = "Displacement at a contact instant";
  figure.caption = instant_sentence(fields) + " The vibration alone, up to " + text("%.3f mm", largest) +
                   ", drawn as " + text("%.0f %%", 100 * drawn_motion) + " of the outer radius." +
                   invariance_sentence(fields) +
                   " For ParaView: fields/contact_wheel.vtu, fields/contact_sector.vtu.";
  return figure;
}

Figure stress_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
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
      figure.caption += ", up to " + text("%.0f MPa", peak.vibration * mpa_per_pa) +
                        (peak.part.empty() ? "" : " on the " + spoken(peak.part)) +
                        text(" at radius %.1f mm", peak.place[0] * mm_per_m) + "; of the spin alone up to " +
                        text("%.0f MPa", peak.spin * mpa_per_pa) + ", of both together " +
                        text("%.0f MPa", peak.both * mpa_per_pa);
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

}  // namespace

std::vector<Figure> field_figures(const FieldStudy& fields) {
  const std::vector<SurfaceFace> faces = sector_surface(fields.sector);
  std::vector<Figure (*)(const FieldStudy&, const std::vector<SurfaceFace>&)> builders = {wheel_figure, sector_figure,
                                                                                          mode_figure};
  if (fields.has_instant)
    builders.insert(builders.end(), {displacement_figure, stress_figure, running_stress_figure});
  std::vector<Figure> figures;
  for (const auto& build : builders) {
    stop_if_interrupted();
    figures.push_back(build(fields, faces));
  }
  return figures;
}

}  // namespace tiprub
