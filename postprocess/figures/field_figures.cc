// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/field_figures.h"

#include "postprocess/tables/interruption.h"

namespace tiprub {

std::vector<Figure> field_figures(const FieldStudy& fields) {
  const std::vector<SurfaceFace> faces = sector_surface(fields.sector);
  std::vector<Figure (*)(const FieldStudy&, const std::vector<SurfaceFace>&)> builders = {wheel_figure, sector_figure,
                                                                                          mode_shapes_figure};
  if (fields.has_instant)
    builders.insert(builders.end(), {contact_displacement_figure, contact_stress_figure, running_stress_figure});
  std::vector<Figure> figures;
  for (const auto& build : builders) {
    stop_if_interrupted();
    figures.push_back(build(fields, faces));
  }
  return figures;
}

}  // namespace tiprub
