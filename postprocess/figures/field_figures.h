// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "postprocess/fields/field_study.h"
#include "postprocess/fields/wheel_surface.h"
#include "postprocess/figures/figure.h"

namespace tiprub {

/// Paper, fig. 2.
Figure meridional_section_figure(const Study& study, const FieldStudy& fields, const std::vector<SurfaceFace>& faces);

// One builder a picture; `faces` are the sector's.
Figure wheel_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces);
Figure sector_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces);       ///< paper, figs. 3, 7
Figure mode_shapes_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces);  ///< paper, fig. 5
Figure disc_modes_figure(const FieldStudy& fields,
                         const std::vector<SurfaceFace>& faces);  ///< fig. 6; needs modes.disc

// Those of the contact instant: for fields that have one.
Figure contact_displacement_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces);  ///< fig. 23
Figure contact_stress_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces);        ///< fig. 23
// These two with a part `disc`.
Figure disc_displacement_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces);  ///< fig. 23
Figure disc_stress_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces);        ///< fig. 23
Figure running_stress_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces);

/// All of them that there are, in the order of the page.
std::vector<Figure> field_figures(const Study& study, const FieldStudy& fields);

}  // namespace tiprub
