// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/field_figures.h"

#include "postprocess/fields/blade_place.h"
#include "postprocess/tables/interruption.h"

namespace tiprub {

std::vector<Figure> field_figures(const Study& study, const FieldStudy& fields) {
  const std::vector<SurfaceFace> faces = sector_surface(fields.sector);
  std::vector<Figure (*)(const FieldStudy&, const std::vector<SurfaceFace>&)> builders = {wheel_figure, sector_figure,
                                                                                          mode_shapes_figure};
  if (!fields.modes.disc.empty()) builders.push_back(disc_modes_figure);
  if (fields.has_instant) {
    builders.insert(builders.end(), {contact_displacement_figure, contact_stress_figure});
    if (fields.sector.parts.contains(disc_part))
      builders.insert(builders.end(), {disc_displacement_figure, disc_stress_figure});
    builders.push_back(running_stress_figure);
  }
  std::vector<Figure> figures = {meridional_section_figure(study, fields, faces)};
  for (const auto& build : builders) {
    stop_if_interrupted();
    figures.push_back(build(fields, faces));
  }
  return figures;
}

}  // namespace tiprub
